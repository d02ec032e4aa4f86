# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause

work = "cpu_seconds"
work_title = "processor time (s)"
set yrange [5e-3:20]
load "scripts/plots/work-precision.inc"
