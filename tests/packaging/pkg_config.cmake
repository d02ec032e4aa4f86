# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Compiles and runs the core consumer with the flags of pkg-config alone.

set(ENV{PKG_CONFIG_PATH} "${PREFIX}/share/pkgconfig:$ENV{PKG_CONFIG_PATH}")
execute_process(COMMAND ${PKG_CONFIG} --modversion ancf OUTPUT_VARIABLE found
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT found STREQUAL VERSION)
    message(FATAL_ERROR "pkg-config says version ${found}, the project is ${VERSION}")
endif()
execute_process(COMMAND ${PKG_CONFIG} --cflags ancf OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
set(program "${WORK}/pkg_config_consumer")
execute_process(COMMAND ${COMPILER} -std=c++17 ${flags} "${SOURCE}/main.cpp" "${SOURCE}/other.cpp" -o "${program}"
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${program}" COMMAND_ERROR_IS_FATAL ANY)
