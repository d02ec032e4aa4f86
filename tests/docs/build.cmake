# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Configures and builds the documentation of SOURCE below BINARY; a warning of Doxygen is an error. GENERATOR and
# MAKE_PROGRAM are those of this build: another may be missing, or have been used before.

execute_process(COMMAND ${CMAKE_COMMAND} --fresh -S "${SOURCE}" -B "${BINARY}" -G "${GENERATOR}"
    -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -DCMAKE_CXX_COMPILER=${COMPILER} -DANCF_BUILD_TESTS=OFF
    -DANCF_BUILD_EXAMPLES=OFF -DANCF_BUILD_BENCH=OFF -DANCF_BUILD_DOCS=ON OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${BINARY}" --target docs COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages "${BINARY}/docs/html/*.html")
list(LENGTH pages count)
if(count LESS 100)
    message(FATAL_ERROR "only ${count} pages were made")
endif()

# A backtick that is still there was not understood as the mark of code.
file(GLOB pages "${BINARY}/docs/html/md_*.html" "${BINARY}/docs/html/index.html")
foreach(page IN LISTS pages)
    file(STRINGS "${page}" left REGEX "`")
    if(left)
        message(FATAL_ERROR "${page} shows backticks: ${left}")
    endif()
endforeach()
foreach(function solve_statics straight_beam)
    file(STRINGS "${BINARY}/docs/html/namespaceancf.html" found REGEX "${function}")
    if(NOT found)
        message(FATAL_ERROR "the page of namespace ancf lacks ${function}")
    endif()
endforeach()
