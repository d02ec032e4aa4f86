# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Compiles SOURCE, which must fail and say every text that its comments `expected:` hold; then with ANCF_CONFORMING,
# which must succeed. COMPILER and FLAGS (a list) say how.

set(command ${COMPILER} -std=c++17 -fsyntax-only ${FLAGS} ${SOURCE})
execute_process(COMMAND ${command} -DANCF_CONFORMING RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "types that miss nothing are refused:\n${errors}")
endif()
execute_process(COMMAND ${command} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result EQUAL 0)
    message(FATAL_ERROR "types that miss everything are accepted")
endif()
file(STRINGS ${SOURCE} lines REGEX "// expected: ")
set(count 0)
foreach(line IN LISTS lines)
    string(REGEX REPLACE "^.*// expected: " "" text "${line}")
    string(FIND "${errors}" "${text}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "the compiler does not say '${text}':\n${errors}")
    endif()
    math(EXPR count "${count} + 1")
endforeach()
if(count LESS 8)
    message(FATAL_ERROR "only ${count} messages looked for")
endif()
message(STATUS "${count} messages found")
