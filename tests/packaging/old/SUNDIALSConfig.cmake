# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Stands for a SUNDIALS that is too old.

set(SUNDIALS_VERSION 5.8.0)
add_library(SUNDIALS::ida INTERFACE IMPORTED)
add_library(SUNDIALS::arkode INTERFACE IMPORTED)
add_library(SUNDIALS::sunlinsolklu INTERFACE IMPORTED)
