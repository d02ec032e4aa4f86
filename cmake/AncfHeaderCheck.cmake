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

# Most of the time goes into Eigen. Where warnings are errors it is compiled in each, since GCC 12 warns inside a
# precompiled Eigen. Otherwise the headers that reach it get it precompiled: this hides nothing from them. Headers that
# include no other one of those stand in `plain`.
set(plain ${headers})
set(with_eigen)
set(found ancf/types.hpp)
while(found AND NOT ANCF_WARNINGS_AS_ERRORS)
    list(JOIN found "|" names)
    set(found)
    foreach(header IN LISTS plain)
        file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} reaching REGEX "^#include <(Eigen/.*|${names})>")
        if(reaching)
            list(APPEND found ${header})
        endif()
    endforeach()
    list(APPEND with_eigen ${found})
    if(found)
        list(REMOVE_ITEM plain ${found})
    endif()
endwhile()
foreach(kind plain with_eigen)
    list(TRANSFORM ${kind} REPLACE "[/.]" "_")
    list(TRANSFORM ${kind} PREPEND ${PROJECT_BINARY_DIR}/header-check/)
    list(TRANSFORM ${kind} APPEND .cpp)
endforeach()
foreach(header IN LISTS headers)
    string(REGEX REPLACE "[/.]" "_" stem ${header})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/header-check/${stem}.cpp
        CONTENT "#include <${header}>\n#include <${header}>\n")
endforeach()
ancf_compile_in_less_memory(${PROJECT_BINARY_DIR}/header-check/ancf_ancf_hpp.cpp)
add_custom_target(ancf_header_check)
foreach(kind plain with_eigen)
    if(${kind})
        set(name ancf_header_check_${kind})
        add_library(${name} OBJECT ${${kind}})
        add_dependencies(ancf_header_check ${name})
        target_link_libraries(${name} PRIVATE ancf_development $<$<TARGET_EXISTS:ancf::petsc>:ancf::petsc>)
        target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
    endif()
endforeach()
if(with_eigen)
    target_precompile_headers(ancf_header_check_with_eigen PRIVATE <Eigen/Core>)
endif()
