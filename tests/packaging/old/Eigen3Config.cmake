# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Stands for an Eigen that is too old.

set(Eigen3_VERSION 3.3.9)
add_library(Eigen3::Eigen INTERFACE IMPORTED)
