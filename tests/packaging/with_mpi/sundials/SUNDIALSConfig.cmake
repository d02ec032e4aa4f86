# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Stands for a SUNDIALS that was built with MPI: its targets, and where in its file it looks for MPI.

set(SUNDIALS_VERSION 7.1.1)
include(CMakeFindDependencyMacro)
if(NOT TARGET SUNDIALS::core_shared)
    add_library(SUNDIALS::core_shared INTERFACE IMPORTED)
    set_target_properties(SUNDIALS::core_shared PROPERTIES INTERFACE_LINK_LIBRARIES MPI::MPI_C)
    foreach(name core ida arkode nvecserial sunmatrixsparse sunlinsolklu)
        add_library(SUNDIALS::${name} INTERFACE IMPORTED)
        set_target_properties(SUNDIALS::${name} PROPERTIES INTERFACE_LINK_LIBRARIES SUNDIALS::core_shared)
    endforeach()
endif()
if(NOT TARGET MPI::MPI_C)
    find_dependency(MPI)
endif()
foreach(name IN LISTS SUNDIALS_FIND_COMPONENTS)
    set(SUNDIALS_${name}_FOUND TRUE)
endforeach()
