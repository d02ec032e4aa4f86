# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The targets of the library. The components name their third parties but do not look for them: an
# export that was made on a machine without SUNDIALS works on one that has it.

add_library(ancf INTERFACE)
target_compile_features(ancf INTERFACE cxx_std_17)
target_include_directories(ancf INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(ancf INTERFACE Eigen3::Eigen)
set_target_properties(ancf PROPERTIES EXPORT_NAME ancf)
add_library(ancf::ancf ALIAS ancf)

add_library(ancf_suitesparse INTERFACE)
target_link_libraries(ancf_suitesparse INTERFACE
    ancf SuiteSparse::CHOLMOD SuiteSparse::KLU SuiteSparse::UMFPACK)
set_target_properties(ancf_suitesparse PROPERTIES EXPORT_NAME suitesparse)

add_library(ancf_sundials INTERFACE)
target_link_libraries(ancf_sundials INTERFACE
    ancf SUNDIALS::ida SUNDIALS::arkode SUNDIALS::nvecserial SUNDIALS::sunmatrixsparse SUNDIALS::sunlinsolklu)
# SUNDIALS 7 keeps SUNContext and SUNLogger in a library of their own.
target_link_libraries(ancf_sundials INTERFACE $<$<TARGET_EXISTS:SUNDIALS::core>:SUNDIALS::core>)
set_target_properties(ancf_sundials PROPERTIES EXPORT_NAME sundials)

# Their own C++ bindings, which MPI has given up, need a library more.
add_library(ancf_petsc INTERFACE)
target_link_libraries(ancf_petsc INTERFACE ancf PkgConfig::ANCF_PETSC MPI::MPI_CXX)
target_compile_definitions(ancf_petsc INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
set_target_properties(ancf_petsc PROPERTIES EXPORT_NAME petsc)

# ancf_use_component(NAME WANTED): makes ancf::NAME usable in this build. WANTED is AUTO (when its third party is
# there), ON (must be there) or OFF.
macro(ancf_use_component name wanted)
    if("${wanted}" STREQUAL "AUTO" OR "${wanted}")
        ancf_find_dependencies(${name})
        if(ancf_${name}_FOUND)
            add_library(ancf::${name} ALIAS ancf_${name})
        elseif("${wanted}" STREQUAL "AUTO")
            message(STATUS "ancf: built without the component ${name}. ${ancf_${name}_MESSAGE}")
        else()
            message(FATAL_ERROR "${ancf_${name}_MESSAGE}")
        endif()
    endif()
endmacro()
