# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The same headers, compiled once: a static library of the definitions and of the usual elements.
#
# ancf_add_compiled(NAME [LAYERS layer...] [ELEMENTS type...]): a static library target. Its units are generated from the
# headers: one for each ANCF_COMPILED_ELEMENT and ANCF_COMPILED_TEMPLATE of a header, one for each layer or part of a
# layer. Of these only the given ones, where some are given; the joints of builders always.
# ancf_add_compiled_component(NAME COMPONENT): another one, NAME_COMPONENT, with the definitions of a component.
# ANCF_SANITIZER_FLAGS: what ANCF_SANITIZE adds to a compilation.

set(ANCF_SANITIZER_FLAGS)
if(ANCF_SANITIZE)
    list(JOIN ANCF_SANITIZE "," sanitizers)
    # At every access of every Eigen expression the last would check what the address sanitizer and Eigen's assertions
    # (on in that build) check too: half of the compile time.
    set(ANCF_SANITIZER_FLAGS -fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer
        -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr)
endif()

# Writes a unit that includes the given files and ends with the given text, and appends its path to the list UNIT_LIST.
function(_ancf_compiled_unit unit_list stem files end)
    set(text "#define ANCF_SOURCE\n")
    foreach(file IN LISTS files)
        string(APPEND text "#include <${file}>\n")
    endforeach()
    set(unit ${PROJECT_BINARY_DIR}/compiled/${stem}.cpp)
    file(CONFIGURE OUTPUT ${unit} CONTENT "${text}${end}" @ONLY)
    set(${unit_list} ${${unit_list}} ${unit} PARENT_SCOPE)
endfunction()

# Sets `sources` to the units of the given layers.
function(_ancf_compiled_layers result)
    set(sources)
    foreach(layer IN LISTS ARGN)
        file(GLOB_RECURSE definitions RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
            ${PROJECT_SOURCE_DIR}/include/ancf/${layer}/*.ipp)
        # Each of them is large, or of one element, which a program without it is spared.
        if(layer MATCHES "^(element|solver|dynamics|suitesparse|sundials|petsc)$")
            foreach(file IN LISTS definitions)
                string(REGEX REPLACE "^ancf/|[.]ipp$" "" stem ${file})
                string(REPLACE "/" "_" stem ${stem})
                _ancf_compiled_unit(sources ${stem} ${file} "")
            endforeach()
        elseif(definitions)
            # Constraints, and springs, which use their points, apart: one unit would take the most memory of all.
            set(constraints ${definitions})
            list(FILTER constraints INCLUDE REGEX "/constraints/|springs[.]")
            list(FILTER definitions EXCLUDE REGEX "/constraints/|springs[.]")
            _ancf_compiled_unit(sources ${layer} "${definitions}" "")
            if(constraints)
                _ancf_compiled_unit(sources ${layer}_constraints "${constraints}" "")
            endif()
        endif()
    endforeach()
    set(${result} ${sources} PARENT_SCOPE)
endfunction()

# Sets RESULT to one unit for each element, or for each of those given and the joints that builders connect members by.
function(_ancf_compiled_elements result)
    set(sources)
    set(names)
    file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/include/ancf/element/*.hpp)
    foreach(header IN LISTS headers)
        file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} lines REGEX "^ANCF_COMPILED_(ELEMENT|TEMPLATE)\\(")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^ANCF_COMPILED_[A-Z]+\\((.*)\\);$" "\\1" element "${line}")
            list(APPEND names "${element}")
            if(ARGN AND NOT element IN_LIST ARGN AND NOT header MATCHES "/joint/")
                continue()
            endif()
            string(MAKE_C_IDENTIFIER "element_${element}" stem)
            set(text "namespace ancf {\n")
            if(line MATCHES "^ANCF_COMPILED_TEMPLATE")
                string(APPEND text "template class ${element};\n")
            endif()
            string(APPEND text "ANCF_ELEMENT_INSTANCE(, ${element});\n}\n")
            _ancf_compiled_unit(sources ${stem} "${header};ancf/model/group_of.hpp" "${text}")
        endforeach()
    endforeach()
    set(unknown ${ARGN})
    list(REMOVE_ITEM unknown ${names})
    if(unknown)
        list(JOIN unknown " and " unknown)
        list(JOIN names "\n  " names)
        message(FATAL_ERROR "The compiled library has no element ${unknown}. It has\n  ${names}")
    endif()
    set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(ancf_add_compiled name)
    cmake_parse_arguments(PARSE_ARGV 1 wanted "" "" "LAYERS;ELEMENTS")
    if(NOT wanted_LAYERS)
        set(wanted_LAYERS section element model assembly solver dynamics output)
    endif()
    _ancf_compiled_layers(layers ${wanted_LAYERS})
    _ancf_compiled_elements(elements ${wanted_ELEMENTS})
    set(sources)
    file(GLOB common RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/ancf/*.ipp)
    _ancf_compiled_unit(sources common "${common}" "namespace ancf::detail {
const char ANCF_LAYOUT = 0;
const char header_only_and_compiled_units_do_not_mix = 0;
template <>
void compiled_for_matrix_and_list<sizeof(Eigen::MatrixXd), sizeof(std::vector<int>)>() {}
}
")
    add_library(${name} STATIC ${sources} ${layers} ${elements})
    target_link_libraries(${name} PUBLIC ancf::ancf)
    target_compile_definitions(${name} PUBLIC ANCF_COMPILED)
    # Reading Eigen is most of the work of a small unit.
    target_precompile_headers(${name} PRIVATE <Eigen/Dense> <Eigen/Sparse> <functional> <memory> <string> <vector>)
    _ancf_compiled_properties(${name})
endfunction()

function(ancf_add_compiled_component library component)
    _ancf_compiled_layers(units ${component})
    add_library(${library}_${component} STATIC ${units})
    target_link_libraries(${library}_${component} PUBLIC ${library} ancf::${component})
    target_precompile_headers(${library}_${component} REUSE_FROM ${library})
    _ancf_compiled_properties(${library}_${component})
endfunction()

# Built when something needs it; usable in shared libraries.
function(_ancf_compiled_properties name)
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXCLUDE_FROM_ALL ON)
    target_compile_options(${name} PRIVATE ${ANCF_SANITIZER_FLAGS})
endfunction()
