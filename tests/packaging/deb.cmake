# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the Debian package and looks into it: right dependencies, headers and package files, nothing compiled.

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
