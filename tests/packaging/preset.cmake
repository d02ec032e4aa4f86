# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs ROOT to PREFIX by its preset `install`, on a machine where CMake finds neither what tests, examples and
# benchmarks need nor the third parties of the components.

set(binary "${WORK}/preset")
file(REMOVE_RECURSE "${binary}" "${PREFIX}")
set(absent)
foreach(package Catch2 CLI11 benchmark SuiteSparse SUNDIALS OpenMP Doxygen Python3)
    list(APPEND absent -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
execute_process(
    COMMAND ${CMAKE_COMMAND} --preset install -B "${binary}" -G "${GENERATOR}" -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}
        -DCMAKE_CXX_COMPILER=${COMPILER} ${absent}
    WORKING_DIRECTORY "${ROOT}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install "${binary}" --prefix "${PREFIX}" OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
