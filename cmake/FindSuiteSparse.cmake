# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes SuiteSparse::CHOLMOD, SuiteSparse::KLU and SuiteSparse::UMFPACK, whatever the version.
#
# SuiteSparse 7 brings CMake packages of these names, which need the language C; they are taken when
# it is enabled. SuiteSparse 5 brings none: header and shared library are looked for. Components:
# CHOLMOD, KLU, UMFPACK. Sets SuiteSparse_FOUND and SuiteSparse_VERSION.

include(FindPackageHandleStandardArgs)

get_property(_ancf_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT SuiteSparse_FIND_COMPONENTS)
    set(SuiteSparse_FIND_COMPONENTS CHOLMOD KLU UMFPACK)
endif()

foreach(_ancf_part IN LISTS SuiteSparse_FIND_COMPONENTS)
    string(TOLOWER ${_ancf_part} _ancf_lower)
    if(NOT TARGET SuiteSparse::${_ancf_part} AND "C" IN_LIST _ancf_languages)
        find_package(${_ancf_part} CONFIG QUIET)
    endif()
    if(NOT TARGET SuiteSparse::${_ancf_part})
        find_path(SuiteSparse_${_ancf_part}_INCLUDE_DIR ${_ancf_lower}.h PATH_SUFFIXES suitesparse)
        find_library(SuiteSparse_${_ancf_part}_LIBRARY NAMES ${_ancf_lower})
        mark_as_advanced(SuiteSparse_${_ancf_part}_INCLUDE_DIR SuiteSparse_${_ancf_part}_LIBRARY)
        if(SuiteSparse_${_ancf_part}_INCLUDE_DIR AND SuiteSparse_${_ancf_part}_LIBRARY)
            add_library(SuiteSparse::${_ancf_part} UNKNOWN IMPORTED)
            set_target_properties(SuiteSparse::${_ancf_part} PROPERTIES
                IMPORTED_LOCATION "${SuiteSparse_${_ancf_part}_LIBRARY}"
                INTERFACE_INCLUDE_DIRECTORIES "${SuiteSparse_${_ancf_part}_INCLUDE_DIR}")
        endif()
    endif()
    if(TARGET SuiteSparse::${_ancf_part})
        set(SuiteSparse_${_ancf_part}_FOUND TRUE)
    endif()
endforeach()

find_path(SuiteSparse_config_INCLUDE_DIR SuiteSparse_config.h PATH_SUFFIXES suitesparse)
mark_as_advanced(SuiteSparse_config_INCLUDE_DIR)
if(SuiteSparse_config_INCLUDE_DIR)
    set(_ancf_numbers)
    foreach(_ancf_part MAIN SUB SUBSUB)
        file(STRINGS "${SuiteSparse_config_INCLUDE_DIR}/SuiteSparse_config.h" _ancf_line
            REGEX "^#define SUITESPARSE_${_ancf_part}_VERSION[ \t]+[0-9]+")
        string(REGEX MATCH "[0-9]+$" _ancf_number "${_ancf_line}")
        list(APPEND _ancf_numbers "${_ancf_number}")
    endforeach()
    list(JOIN _ancf_numbers "." SuiteSparse_VERSION)
endif()

find_package_handle_standard_args(SuiteSparse
    REQUIRED_VARS SuiteSparse_config_INCLUDE_DIR
    VERSION_VAR SuiteSparse_VERSION
    HANDLE_COMPONENTS)

unset(_ancf_languages)
unset(_ancf_part)
unset(_ancf_lower)
unset(_ancf_line)
unset(_ancf_number)
unset(_ancf_numbers)
