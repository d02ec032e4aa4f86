# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The same headers, compiled once: a static library of the definitions and of the usual elements.
#
# ancf_add_compiled(NAME [COMPONENT name]...): a static library target. Its units are generated from the headers: one for
# each element that a header declares `extern template`, one for each layer or part of a layer.

# Writes a unit that includes the given files and ends with the given line, and appends it to `sources`.
macro(_ancf_compiled_unit stem files line)
    set(text "#define ANCF_SOURCE\n")
    foreach(file ${files})
        string(APPEND text "#include <${file}>\n")
    endforeach()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/compiled/${stem}.cpp CONTENT "${text}${line}" @ONLY)
    list(APPEND sources ${PROJECT_BINARY_DIR}/compiled/${stem}.cpp)
endmacro()

# Sets `sources` to the units of the given layers.
function(_ancf_compiled_layers result)
    set(sources)
    foreach(layer IN LISTS ARGN)
        file(GLOB_RECURSE definitions RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
            ${PROJECT_SOURCE_DIR}/include/ancf/${layer}/*.ipp)
        if(layer MATCHES "^(solver|dynamics|suitesparse|sundials)$") # each of them is large
            foreach(file IN LISTS definitions)
                string(REGEX REPLACE "^ancf/|[.]ipp$" "" stem ${file})
                string(REPLACE "/" "_" stem ${stem})
                _ancf_compiled_unit(${stem} ${file} "")
            endforeach()
        elseif(definitions)
            _ancf_compiled_unit(${layer} "${definitions}" "")
        endif()
    endforeach()
    set(${result} ${sources} PARENT_SCOPE)
endfunction()

# Sets RESULT to one unit for each element.
function(_ancf_compiled_elements result)
    set(sources)
    file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/include/ancf/element/*.hpp)
    foreach(header IN LISTS headers)
        file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} lines
            REGEX "^extern template (class [^;]*|std::unique_ptr<ElementGroup> detail::make_group<[A-Za-z]*>\\(\\))")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^extern template (class |.*make_group<)|(>\\(\\))?;?$" "" element "${line}")
            if(NOT element)
                continue()
            endif()
            string(MAKE_C_IDENTIFIER "element_${element}" stem)
            set(text "namespace ancf {\n")
            if(line MATCHES " class ")
                string(APPEND text "template class ${element};\n")
            endif()
            string(APPEND text "template std::unique_ptr<ElementGroup> detail::make_group<${element}>();\n}\n")
            _ancf_compiled_unit(${stem} "${header};ancf/model/element_group.hpp" "${text}")
        endforeach()
    endforeach()
    set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(ancf_add_compiled name)
    _ancf_compiled_layers(layers section element model assembly solver dynamics output)
    _ancf_compiled_elements(elements)
    set(sources)
    file(GLOB common RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/ancf/*.ipp)
    _ancf_compiled_unit(common "${common}" "")
    add_library(${name} STATIC ${sources} ${layers} ${elements})
    target_link_libraries(${name} PUBLIC ancf::ancf)
    target_compile_definitions(${name} PUBLIC ANCF_COMPILED)
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
endfunction()
