# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Compiles every header alone: none may lean on what another one happened to include.

file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/include/ancf/*.hpp)
foreach(component suitesparse sundials petsc)
    if(NOT TARGET ancf::${component})
        list(FILTER headers EXCLUDE REGEX "^ancf/${component}/")
    endif()
endforeach()

set(sources)
foreach(header IN LISTS headers)
    string(REGEX REPLACE "[/.]" "_" stem ${header})
    set(source ${PROJECT_BINARY_DIR}/header-check/${stem}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <${header}>\n#include <${header}>\n")
    list(APPEND sources ${source})
endforeach()
add_library(ancf_header_check OBJECT ${sources})
target_link_libraries(ancf_header_check PRIVATE ancf_development $<$<TARGET_EXISTS:ancf::petsc>:ancf::petsc>)
target_compile_options(ancf_header_check PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
