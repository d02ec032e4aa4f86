# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Configures and builds the documentation of SOURCE below BINARY; a warning of Doxygen is an error.

execute_process(COMMAND ${CMAKE_COMMAND} -S "${SOURCE}" -B "${BINARY}" -DANCF_BUILD_TESTS=OFF -DANCF_BUILD_EXAMPLES=OFF
    -DANCF_BUILD_BENCH=OFF -DANCF_BUILD_DOCS=ON OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${BINARY}" --target docs COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages "${BINARY}/docs/html/*.html")
list(LENGTH pages count)
if(count LESS 100)
    message(FATAL_ERROR "only ${count} pages were made")
endif()
