# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the build tree into STAGING and moves it to PREFIX.

file(REMOVE_RECURSE "${STAGING}" "${PREFIX}")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${STAGING}" OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${STAGING}" "${PREFIX}")
file(GLOB_RECURSE texts "${PREFIX}/share/cmake/*.cmake" "${PREFIX}/share/pkgconfig/*.pc")
list(LENGTH texts count)
if(count LESS 8)
    message(FATAL_ERROR "only ${count} package files installed below ${PREFIX}/share")
endif()
foreach(text IN LISTS texts)
    file(READ "${text}" content)
    foreach(path "${STAGING}" "${BUILD}")
        string(FIND "${content}" "${path}" place)
        if(NOT place EQUAL -1)
            message(FATAL_ERROR "${text} cannot be moved: it names ${path}")
        endif()
    endforeach()
endforeach()
