# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Stands for a SUNDIALS that was built without KLU.

set(SUNDIALS_VERSION 6.5.0)
add_library(SUNDIALS::ida INTERFACE IMPORTED)
