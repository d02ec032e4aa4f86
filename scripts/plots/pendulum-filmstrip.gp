# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The pendulum every tenth of a second, drawn with its depth.

set datafile separator whitespace
set title "Pendulum (section 5.1): every 0.1 s from rest to 1.2 s, 16 elements"
set xlabel "x (m)"
set ylabel "y (m)"
set size ratio -1
set xrange [-1.35:1.3]
set yrange [-1.6:0.35]
set palette defined (0 "#0072b2", 0.5 "#009e73", 1 "#d55e00")
set cbrange [0:1.2]
set cblabel "time (s)"
unset key
set style fill transparent solid 0.45 border
set label 1 "" at 0, 0 point pointtype 7 pointsize 1 linecolor rgb "#404040" front

# one polygon for every time, in the colour of its time
file = data . "/pendulum-shapes.polygons"
plot for [k = 0:12] file index k using 2:3 with filledcurves closed fillcolor palette cb (0.1 * k) linewidth 0.5 dashtype solid, \
    NaN linecolor palette
