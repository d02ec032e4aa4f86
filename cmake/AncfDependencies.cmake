# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Looks for what ancf stands on; used by ancf's own build and by its installed package alike, so that
# the same header package serves a consumer with Eigen only and one with everything.
#
# ancf_find_dependencies(PART): PART is core, compiled, suitesparse, sundials or petsc. Sets ancf_PART_FOUND and, where it
# is false, ancf_PART_MESSAGE: what is missing and how to get it.
#
# These are macros: find_package must leave its targets and variables with the caller.

set(_ancf_module_dir ${CMAKE_CURRENT_LIST_DIR})

macro(ancf_find_dependencies part)
    if("${part}" STREQUAL "core")
        _ancf_find_eigen()
    elseif("${part}" STREQUAL "compiled")
        _ancf_find_compiled()
    elseif("${part}" STREQUAL "suitesparse")
        _ancf_find_suitesparse()
    elseif("${part}" STREQUAL "sundials")
        _ancf_find_sundials()
    elseif("${part}" STREQUAL "petsc")
        _ancf_find_petsc()
    else()
        set(ancf_${part}_FOUND FALSE)
        set(ancf_${part}_MESSAGE
            "ancf has no component '${part}'; there are: compiled, suitesparse, sundials, petsc (the core needs no name)")
    endif()
endmacro()

# Sets ancf_PART_MESSAGE: the problem, and what cures it. The last four arguments are package names.
function(ancf_explain part problem debian fedora homebrew conda)
    set(ancf_${part}_MESSAGE "${problem}
  Debian, Ubuntu:  apt install ${debian}
  Fedora:          dnf install ${fedora}
  macOS:           brew install ${homebrew}
  conda:           conda install -c conda-forge ${conda}
  elsewhere:       -D CMAKE_PREFIX_PATH=where it is installed"
        PARENT_SCOPE)
endfunction()

# No version is asked for: Eigen 5 refuses a request for 3.4, and a range shuts out the next one.
macro(_ancf_find_eigen)
    find_package(Eigen3 QUIET CONFIG)
    set(ancf_core_FOUND FALSE)
    if(NOT TARGET Eigen3::Eigen)
        ancf_explain(core "ancf needs Eigen 3.4 or newer, which was not found."
            libeigen3-dev eigen3-devel eigen eigen)
    elseif(DEFINED Eigen3_VERSION AND Eigen3_VERSION VERSION_LESS 3.4)
        ancf_explain(core "ancf needs Eigen 3.4 or newer, found ${Eigen3_VERSION} in ${Eigen3_DIR}."
            libeigen3-dev eigen3-devel eigen eigen)
    else()
        set(ancf_core_FOUND TRUE)
    endif()
endmacro()

# The compiled library of this installation, or another one of the same version.
macro(_ancf_find_compiled)
    find_package(ancf_compiled ${ancf_VERSION} EXACT QUIET CONFIG HINTS "${_ancf_module_dir}/../../..")
    set(ancf_compiled_MESSAGE
        "ancf ${ancf_VERSION} is here without its compiled library: install it by `cmake --preset install-compiled`")
endmacro()

macro(_ancf_find_suitesparse)
    list(PREPEND CMAKE_MODULE_PATH "${_ancf_module_dir}")
    find_package(SuiteSparse QUIET MODULE COMPONENTS CHOLMOD KLU UMFPACK)
    list(POP_FRONT CMAKE_MODULE_PATH)
    set(ancf_suitesparse_FOUND FALSE)
    set(_ancf_absent)
    foreach(_ancf_library CHOLMOD KLU UMFPACK)
        if(NOT TARGET SuiteSparse::${_ancf_library})
            list(APPEND _ancf_absent ${_ancf_library})
        endif()
    endforeach()
    list(JOIN _ancf_absent ", " _ancf_absent)
    if(SuiteSparse_VERSION AND SuiteSparse_VERSION VERSION_LESS 5.12)
        ancf_explain(suitesparse
            "ancf's component suitesparse needs SuiteSparse 5.12 or newer, found ${SuiteSparse_VERSION} in ${SuiteSparse_config_INCLUDE_DIR}."
            libsuitesparse-dev suitesparse-devel suite-sparse suitesparse)
    elseif(_ancf_absent OR NOT SuiteSparse_FOUND)
        ancf_explain(suitesparse
            "ancf's component suitesparse needs CHOLMOD, KLU and UMFPACK of SuiteSparse 5.12 or newer (not found: ${_ancf_absent})."
            libsuitesparse-dev suitesparse-devel suite-sparse suitesparse)
    else()
        set(ancf_suitesparse_FOUND TRUE)
    endif()
endmacro()

# Sets RESULT to whether a target that ancf::sundials links names LIBRARY, itself or through others.
function(_ancf_sundials_names library result)
    set(waiting SUNDIALS::ida SUNDIALS::arkode SUNDIALS::nvecserial SUNDIALS::sunmatrixsparse SUNDIALS::sunlinsolklu
        SUNDIALS::core)
    set(names)
    while(waiting)
        list(POP_FRONT waiting name)
        if(name IN_LIST names)
            continue()
        endif()
        list(APPEND names "${name}")
        if(TARGET "${name}")
            get_target_property(linked "${name}" INTERFACE_LINK_LIBRARIES)
            string(REGEX REPLACE "\\$<LINK_ONLY:([^>]*)>" "\\1" linked "${linked}") # a static library
            list(APPEND waiting ${linked})
        endif()
    endwhile()
    if(library IN_LIST names)
        set(${result} TRUE PARENT_SCOPE)
    else()
        set(${result} FALSE PARENT_SCOPE)
    endif()
endfunction()

macro(_ancf_find_sundials)
    # A SUNDIALS with OpenMP vectors asks for OpenMP even where nobody uses them and leaves half of its targets
    # undefined when the compiler has none. An empty stand-in keeps the serial parts usable.
    if(NOT TARGET OpenMP::OpenMP_C)
        find_package(OpenMP QUIET)
        if(NOT OpenMP_FOUND AND NOT TARGET OpenMP::OpenMP_C)
            add_library(OpenMP::OpenMP_C INTERFACE IMPORTED)
        endif()
    endif()
    find_package(SUNDIALS QUIET CONFIG COMPONENTS ida arkode nvecserial sunmatrixsparse sunlinsolklu)
    set(ancf_sundials_FOUND FALSE)
    # A SUNDIALS with MPI names MPI::MPI_C, which FindMPI makes only where the language C is enabled. What it finds for
    # C++ serves as well.
    _ancf_sundials_names(MPI::MPI_C _ancf_with_mpi)
    if(_ancf_with_mpi AND NOT TARGET MPI::MPI_C AND TARGET MPI::MPI_CXX)
        add_library(MPI::MPI_C INTERFACE IMPORTED)
        set_target_properties(MPI::MPI_C PROPERTIES INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
    endif()
    if(SUNDIALS_VERSION AND SUNDIALS_VERSION VERSION_LESS 6.4)
        ancf_explain(sundials
            "ancf's component sundials needs SUNDIALS 6.4 or newer, found ${SUNDIALS_VERSION} in ${SUNDIALS_DIR}."
            libsundials-dev sundials-devel sundials sundials)
    elseif(SUNDIALS_DIR AND NOT (TARGET SUNDIALS::ida AND TARGET SUNDIALS::arkode AND TARGET SUNDIALS::sunlinsolklu))
        ancf_explain(sundials
            "ancf's component sundials needs SUNDIALS with IDA, ARKODE and KLU, found ${SUNDIALS_VERSION} in ${SUNDIALS_DIR} without them."
            libsundials-dev sundials-devel sundials sundials)
    elseif(_ancf_with_mpi AND NOT TARGET MPI::MPI_C)
        ancf_explain(sundials
            "ancf's component sundials needs MPI for C++, which was not found: SUNDIALS ${SUNDIALS_VERSION} in ${SUNDIALS_DIR} was built with it."
            mpi-default-dev openmpi-devel open-mpi openmpi)
    elseif(NOT SUNDIALS_FOUND)
        ancf_explain(sundials
            "ancf's component sundials needs IDA and ARKODE of SUNDIALS 6.4 or newer, built with KLU, which was not found."
            libsundials-dev sundials-devel sundials sundials)
    else()
        set(ancf_sundials_FOUND TRUE)
    endif()
endmacro()

# PETSc has no CMake package; its pkg-config file leaves out MPI, which the compiler wrapper of MPI knows.
macro(_ancf_find_petsc)
    set(ancf_petsc_FOUND FALSE)
    find_package(PkgConfig QUIET)
    if(PkgConfig_FOUND AND NOT TARGET PkgConfig::ANCF_PETSC)
        pkg_search_module(ANCF_PETSC QUIET IMPORTED_TARGET GLOBAL PETSc petsc)
        if(TARGET PkgConfig::ANCF_PETSC)
            # what it was compiled with is no business of its users
            set_property(TARGET PkgConfig::ANCF_PETSC PROPERTY INTERFACE_COMPILE_OPTIONS)
        endif()
    endif()
    if(NOT TARGET MPI::MPI_CXX)
        find_package(MPI QUIET COMPONENTS CXX)
    endif()
    if(NOT PkgConfig_FOUND)
        ancf_explain(petsc "ancf's component petsc needs pkg-config, which was not found."
            pkg-config pkgconf pkgconf pkg-config)
    elseif(NOT TARGET PkgConfig::ANCF_PETSC)
        ancf_explain(petsc "ancf's component petsc needs PETSc 3.18 or newer with MPI, which pkg-config does not find."
            petsc-dev petsc-openmpi-devel petsc petsc)
    elseif(ANCF_PETSC_VERSION AND ANCF_PETSC_VERSION VERSION_LESS 3.18)
        ancf_explain(petsc "ancf's component petsc needs PETSc 3.18 or newer, found ${ANCF_PETSC_VERSION} in ${ANCF_PETSC_PREFIX}."
            petsc-dev petsc-openmpi-devel petsc petsc)
    elseif(NOT TARGET MPI::MPI_CXX)
        ancf_explain(petsc "ancf's component petsc needs MPI for C++, which was not found."
            mpi-default-dev openmpi-devel open-mpi openmpi)
    else()
        set(ancf_petsc_FOUND TRUE)
    endif()
endmacro()
