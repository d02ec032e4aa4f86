# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Stands for an MPI on every machine. Like CMake's own module it makes a target for each enabled language.

get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
foreach(language C CXX)
    if(language IN_LIST languages AND NOT TARGET MPI::MPI_${language})
        add_library(MPI::MPI_${language} INTERFACE IMPORTED)
        set_target_properties(MPI::MPI_${language} PROPERTIES INTERFACE_COMPILE_DEFINITIONS FOUND_MPI_${language})
    endif()
endforeach()
set(MPI_FOUND TRUE)
