# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the Debian packages and looks into them. The headers: right dependencies, headers and package files, nothing
# compiled. With COMPILED the other one: the libraries, for this architecture, beside these headers.

file(REMOVE_RECURSE "${WORK}")
execute_process(COMMAND ${CPACK} -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${WORK}"
    WORKING_DIRECTORY "${BUILD}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# Sets `information` and `contents` of the one package that the pattern names.
macro(ancf_open pattern)
    file(GLOB package "${WORK}/${pattern}")
    execute_process(COMMAND ${DPKG_DEB} --info ${package} OUTPUT_VARIABLE information COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${DPKG_DEB} --contents ${package} OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
endmacro()

# ancf_expect(TEXT REGEX...): the text has all of them.
function(ancf_expect text)
    foreach(expected IN LISTS ARGN)
        if(NOT text MATCHES "${expected}")
            message(FATAL_ERROR "the package lacks '${expected}':\n${text}")
        endif()
    endforeach()
endfunction()

ancf_open("libancf-dev_*_all.deb")
ancf_expect("${information}" "Depends: libeigen3-dev" "Recommends: libsuitesparse-dev, libsundials-dev")
ancf_expect("${contents}" usr/include/ancf/ancf.hpp usr/share/cmake/ancf/ancfConfig.cmake
    usr/share/pkgconfig/ancf.pc)
if(contents MATCHES "usr/lib|usr/bin")
    message(FATAL_ERROR "the package holds more than headers:\n${contents}")
endif()

if(COMPILED)
    ancf_open("libancf-compiled-dev_*.deb")
    ancf_expect("${information}" "Depends: libancf-dev \\(= [0-9.]+\\)")
    ancf_expect("${contents}" usr/lib/.*libancf_compiled.a
        usr/lib/.*cmake/ancf_compiled/ancf_compiledConfig.cmake usr/lib/.*pkgconfig/ancf-compiled.pc)
    if(information MATCHES "Architecture: all")
        message(FATAL_ERROR "the compiled package claims to fit every machine:\n${information}")
    endif()
    if(contents MATCHES "usr/include|usr/share/cmake")
        message(FATAL_ERROR "the compiled package repeats the headers' files:\n${contents}")
    endif()
endif()
