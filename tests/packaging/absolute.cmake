# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs ROOT with one folder that is absolute, apart from the prefix, below DESTDIR: pkg-config must lead to the
# headers.

set(binary "${WORK}/absolute")
set(ENV{DESTDIR} "${WORK}/absolute folders")
foreach(folder INCLUDEDIR DATADIR)
    file(REMOVE_RECURSE "${binary}" "$ENV{DESTDIR}")
    execute_process(
        COMMAND ${CMAKE_COMMAND} --preset install -B "${binary}" -G "${GENERATOR}" -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}
            -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_INSTALL_PREFIX=/prefix -DCMAKE_INSTALL_${folder}=/apart/here
        WORKING_DIRECTORY "${ROOT}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${CMAKE_COMMAND} --install "${binary}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    set(ENV{PKG_CONFIG_PATH} "$ENV{DESTDIR}/prefix/share/pkgconfig:$ENV{DESTDIR}/apart/here/pkgconfig")
    execute_process(COMMAND ${PKG_CONFIG} --variable=includedir ancf OUTPUT_VARIABLE found
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE "\\ " " " found "${found}")
    # from the file's own place, or absolute
    if(NOT EXISTS "${found}/ancf/ancf.hpp" AND NOT EXISTS "$ENV{DESTDIR}${found}/ancf/ancf.hpp")
        message(FATAL_ERROR "absolute ${folder}: pkg-config leads to ${found}, where no ancf/ancf.hpp is")
    endif()
endforeach()
