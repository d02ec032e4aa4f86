# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The twisted beam as its torque grows and falls; the section is drawn larger than the length.

set datafile separator whitespace
set zlabel "z (mm)" offset 3, 0 rotate parallel
enlarged = 10.0
millimetre = 1e3
set xrange [0:260]
set yrange [-4 * enlarged:4 * enlarged]
set zrange [-4 * enlarged:4 * enlarged]
set xtics 50 offset -0.6, -0.7
set ytics ("-4" -4 * enlarged, "0" 0, "4" 4 * enlarged) offset 0.4, -0.2
set label 2 "x (mm)" at 130, -4 * enlarged, -4 * enlarged center offset -3, -3
set label 3 "y (mm)" at 260, 0, -4 * enlarged left offset 6.5, -0.8
set ztics ("-4" -4 * enlarged, "0" 0, "4" 4 * enlarged)
set xyplane at -4 * enlarged
set view 65, 25, 2.7
set view equal xyz
unset key
unset colorbox
set pm3d depthorder border linecolor rgb "#303030" linewidth 0.3
set palette defined (0 "#56b4e9", 1 "#0072b2")
set label 1 "section drawn 10 times larger than the length" at screen 0.5, 0.05 center

do for [n = 0:47] {
    k = n <= 24 ? n : 48 - n
    set title sprintf("Twist (section 5.3), five elements: T = %.2f N m", 20.605 * k / 24)
    splot sprintf("%s/twist-%d.grid", data, k) \
        using (millimetre * $1):(enlarged * millimetre * $2):(enlarged * millimetre * $3):4 with pm3d
}
