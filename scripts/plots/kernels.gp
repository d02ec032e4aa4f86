# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Time of energy, force and tangent of one element: as most users compile, and for this machine by one, four and eight lanes.

set style data histogram
set style histogram clustered gap 1
set style fill solid border rgb "white"
set boxwidth 1.0
set yrange [0:]
set grid ytics
set key top left Left reverse
set xtics rotate by -35 noenhanced
set ylabel "microseconds per element"
set key autotitle columnheader
plot data."/kernels_bars.csv" using ($2 / 1e3):xtic(1) linecolor rgb grey, "" using ($3 / 1e3) linecolor rgb blue, \
    "" using ($4 / 1e3) linecolor rgb green, "" using ($5 / 1e3) linecolor rgb orange
