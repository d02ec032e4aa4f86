# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause

work = "linear_solves"
work_title = "linear solves"
set yrange [4e2:4e5]
load "scripts/plots/work-precision.inc"
