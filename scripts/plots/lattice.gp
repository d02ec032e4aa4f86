# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The lattice at rest and twisted.

load 'scripts/plots/lattice.inc'
set multiplot layout 1, 2
set label 1 "at rest" at screen 0.25, 0.03 center
splot sprintf("%s/lattice-0.csv", data) with lines linecolor rgb blue linewidth 1.5
set label 1 "4800 N at each joint of the top" at screen 0.75, 0.03 center
splot sprintf("%s/lattice-24.csv", data) with lines linecolor rgb blue linewidth 1.5
unset multiplot
