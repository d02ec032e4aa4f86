# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The lattice as the forces at its top grow and fall.

load 'scripts/plots/lattice.inc'
do for [n = 0:47] {
    k = n <= 24 ? n : 48 - n
    set label 1 sprintf("%d N at each joint of the top", 200 * k) at screen 0.5, 0.03 center
    splot sprintf("%s/lattice-%d.csv", data, k) with lines linecolor rgb blue linewidth 1.5
}
