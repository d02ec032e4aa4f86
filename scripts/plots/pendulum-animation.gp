# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The pendulum in motion, drawn with its depth; one frame every 0.02 s.

set datafile separator whitespace
set xlabel "x (m)"
set ylabel "y (m)"
set size ratio -1
set xrange [-1.35:1.3]
set yrange [-1.6:0.35]
unset key
set label 1 "" at 0, 0 point pointtype 7 pointsize 1 linecolor rgb "#404040" front

file = data . "/pendulum-frames.polygons"
do for [k = 0:60] {
    set title sprintf("Pendulum (section 5.1), 16 elements: t = %.2f s", 0.02 * k)
    plot file index k using 2:3 with filledcurves closed fillcolor rgb blue linewidth 0.5
}
