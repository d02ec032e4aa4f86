# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What ancf's own programs are compiled with. Nothing here reaches a consumer of the library.
#
# ancf_core_development: the headers of the core with the warnings and the sanitizers.
# ancf_development: all components that are there as well; ANCF_WITH_SUITESPARSE and ANCF_WITH_SUNDIALS are 1 or 0.
# ancf_link_petsc(NAME LIBRARY): the component petsc, where it is there, for a program that asks for it; ANCF_WITH_PETSC
# is 1 or 0. Others are spared the loading of its libraries.
# ancf_add_program(NAME LIBRARY SOURCE...): an example or bench program with ancf_development and a compiled library,
# ancf_compiled or ancf_compiled_native.

add_library(ancf_core_development INTERFACE)
target_compile_options(ancf_core_development INTERFACE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra -Wconversion -Wshadow>
    # g++ does not count signs among conversions: Eigen's indices are signed, the sizes of std are not.
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion>
    $<$<CXX_COMPILER_ID:MSVC>:/W4>)
if(ANCF_WARNINGS_AS_ERRORS)
    target_compile_options(ancf_core_development INTERFACE
        $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Werror> $<$<CXX_COMPILER_ID:MSVC>:/WX>)
endif()
target_compile_options(ancf_core_development INTERFACE ${ANCF_SANITIZER_FLAGS})
target_link_options(ancf_core_development INTERFACE ${ANCF_SANITIZER_FLAGS})
target_link_libraries(ancf_core_development INTERFACE ancf::ancf)

add_library(ancf_development INTERFACE)
target_link_libraries(ancf_development INTERFACE ancf_core_development)
foreach(component suitesparse sundials)
    string(TOUPPER ANCF_WITH_${component} definition)
    if(TARGET ancf::${component})
        target_link_libraries(ancf_development INTERFACE ancf::${component})
        target_compile_definitions(ancf_development INTERFACE ${definition}=1)
    else()
        target_compile_definitions(ancf_development INTERFACE ${definition}=0)
    endif()
endforeach()

# Links a program with a compiled library and what of it belongs to the components that are there.
function(ancf_link name library)
    target_link_libraries(${name} PUBLIC ${library} ancf_development)
    foreach(component suitesparse sundials)
        if(TARGET ancf::${component})
            target_link_libraries(${name} PUBLIC ${library}_${component})
        endif()
    endforeach()
endfunction()

function(ancf_link_petsc name library)
    if(TARGET ancf::petsc)
        target_link_libraries(${name} PUBLIC ${library}_petsc)
        target_compile_definitions(${name} PRIVATE ANCF_WITH_PETSC=1)
    else()
        target_compile_definitions(${name} PRIVATE ANCF_WITH_PETSC=0)
    endif()
endfunction()

function(ancf_add_program name library)
    add_executable(${name} ${ARGN})
    ancf_link(${name} ${library})
endfunction()

# ancf_require_package(NAME TARGET FOR DEBIAN FEDORA HOMEBREW CONDA): finds what only the repository's own programs need.
macro(ancf_require_package name target purpose)
    find_package(${name} QUIET CONFIG)
    if(NOT TARGET ${target})
        ancf_explain(${name} "${purpose} need ${name}, which was not found." ${ARGN})
        message(FATAL_ERROR "${ancf_${name}_MESSAGE}")
    endif()
endmacro()

# What runs on several threads where OpenMP is there; serially, with the same results, where it is not.
add_library(ancf_threads INTERFACE)
if(ANCF_WITH_OPENMP)
    find_package(OpenMP QUIET COMPONENTS CXX)
    if(TARGET OpenMP::OpenMP_CXX)
        target_link_libraries(ancf_threads INTERFACE OpenMP::OpenMP_CXX)
    elseif(NOT ANCF_WITH_OPENMP STREQUAL AUTO)
        message(FATAL_ERROR "ANCF_WITH_OPENMP is ON, but the compiler has no OpenMP")
    endif()
endif()

# For sources that take more than 700 MB otherwise: the compiler collects its garbage more often.
function(ancf_compile_in_less_memory)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS
        "$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=20;--param=ggc-min-heapsize=32768>")
endfunction()

# Lets a compiled library take all instructions of this machine and threads: its objects have another layout.
function(ancf_make_native name)
    target_link_libraries(${name} PUBLIC ancf_threads)
    # GCC 12 takes fault with its own AVX-512 header.
    target_compile_options(${name} PUBLIC -march=native
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized;-Wno-array-bounds>")
    # with wide registers
    ancf_compile_in_less_memory(${PROJECT_BINARY_DIR}/compiled/element_ContinuumBeam_3_.cpp)
endfunction()

# For benchmarks.
if(NOT MSVC)
    ancf_add_compiled(ancf_compiled_native)
    ancf_make_native(ancf_compiled_native)
    foreach(component suitesparse sundials petsc)
        if(TARGET ancf::${component})
            ancf_add_compiled_component(ancf_compiled_native ${component})
        endif()
    endforeach()
endif()
