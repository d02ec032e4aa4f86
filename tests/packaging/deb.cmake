# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the Debian packages and looks into them. The headers: right dependencies, headers and package files, nothing
# compiled. With COMPILED the other one: the libraries, for this architecture, beside these headers.

file(REMOVE_RECURSE "${WORK}")
execute_process(COMMAND ${CPACK} -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${WORK}"
    WORKING_DIRECTORY "${BUILD}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package "${WORK}/libancf-dev_*_all.deb")
execute_process(COMMAND ${DPKG_DEB} --info ${package} OUTPUT_VARIABLE information
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${DPKG_DEB} --contents ${package} OUTPUT_VARIABLE contents
    COMMAND_ERROR_IS_FATAL ANY)
foreach(expected "Depends: libeigen3-dev" "Recommends: libsuitesparse-dev, libsundials-dev")
    if(NOT information MATCHES "${expected}")
        message(FATAL_ERROR "the package lacks '${expected}':\n${information}")
    endif()
endforeach()
foreach(expected usr/include/ancf/ancf.hpp usr/share/cmake/ancf/ancfConfig.cmake
        usr/share/pkgconfig/ancf.pc)
    if(NOT contents MATCHES "${expected}")
        message(FATAL_ERROR "the package lacks ${expected}:\n${contents}")
    endif()
endforeach()
if(contents MATCHES "usr/lib|usr/bin")
    message(FATAL_ERROR "the package holds more than headers:\n${contents}")
endif()

if(NOT COMPILED)
    return()
endif()
file(GLOB package "${WORK}/libancf-compiled-dev_*.deb")
execute_process(COMMAND ${DPKG_DEB} --info ${package} OUTPUT_VARIABLE information
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${DPKG_DEB} --contents ${package} OUTPUT_VARIABLE contents
    COMMAND_ERROR_IS_FATAL ANY)
if(NOT information MATCHES "Depends: libancf-dev \\(= [0-9.]+\\)")
    message(FATAL_ERROR "the compiled package does not depend on its headers:\n${information}")
endif()
if(information MATCHES "Architecture: all")
    message(FATAL_ERROR "the compiled package claims to fit every machine:\n${information}")
endif()
foreach(expected libancf_compiled.a cmake/ancf_compiled/ancf_compiledConfig.cmake pkgconfig/ancf-compiled.pc)
    if(NOT contents MATCHES "usr/lib/.*${expected}")
        message(FATAL_ERROR "the compiled package lacks ${expected}:\n${contents}")
    endif()
endforeach()
if(contents MATCHES "usr/include|usr/share/cmake")
    message(FATAL_ERROR "the compiled package repeats the headers' files:\n${contents}")
endif()
