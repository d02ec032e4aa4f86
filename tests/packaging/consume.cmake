# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Configures, builds and runs PROGRAM of the project SOURCE as NAME below WORK; with REFUSED, expects its configuration
# to fail with a message that matches; with LINK_REFUSED, its build.

set(binary "${WORK}/${NAME}")
file(REMOVE_RECURSE "${binary}")
execute_process(
    COMMAND ${CMAKE_COMMAND} -S "${SOURCE}" -B "${binary}" -G "${GENERATOR}"
        -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug
        -DCMAKE_CXX_FLAGS_DEBUG=-O0 ${OPTIONS}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(REFUSED)
    string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
    if(result EQUAL 0)
        message(FATAL_ERROR "configured, but should have been refused with: ${REFUSED}")
    elseif(NOT errors MATCHES "${REFUSED}")
        message(FATAL_ERROR "refused, but not with '${REFUSED}':\n${errors}")
    endif()
    message(STATUS "refused as expected: ${errors}")
    return()
endif()
if(NOT result EQUAL 0)
    message(FATAL_ERROR "could not be configured:\n${output}\n${errors}")
endif()
if(LINK_REFUSED)
    execute_process(COMMAND ${CMAKE_COMMAND} --build "${binary}"
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(result EQUAL 0)
        message(FATAL_ERROR "built, but should have been refused with: ${LINK_REFUSED}")
    elseif(NOT "${output}${errors}" MATCHES "${LINK_REFUSED}")
        message(FATAL_ERROR "refused, but not with '${LINK_REFUSED}':\n${output}\n${errors}")
    endif()
    message(STATUS "refused as expected")
    return()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build "${binary}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${binary}/${PROGRAM}" COMMAND_ERROR_IS_FATAL ANY)
