# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The double pendulum in space: centre lines every tenth of a second and the path of its tip.

set title "Double pendulum: every 0.1 s from rest to 1 s, and the path of its tip"
set zlabel "y (m)" rotate parallel
set view 70, 50, 1.7
set view equal xyz
set xrange [-1.5:1]
set yrange [-0.5:1]
set zrange [-1.6:0]
set xyplane at -1.6
set xtics -1.5, 0.5, 0.5 offset -0.5, -0.5
set ytics 0, 0.5, 1 offset 0.5, -0.4
set ztics 0.4
set label 1 "x (m)" at -0.25, -0.5, -1.6 right offset -2.5, -2
set label 2 "z (m)" at 1, 0.25, -1.6 left offset 2, -2
set grid
set palette defined (0 "#0072b2", 0.5 "#009e73", 1 "#d55e00")
set cbrange [0:1]
set colorbox user origin screen 0.88, 0.3 size screen 0.022, 0.42
set cblabel "time (s)"
unset key

# a new data set where the time or the beam changes, so that lines do not become a surface
lines = sprintf("< awk -F, 'NR > 1 { if ($1 != t || $2 != beam) print \"\\n\"; t = $1; beam = $2; print $1 \",\" $4 \",\" $5 \",\" $6 }' '%s/double-pendulum-shapes.csv'", data)

splot lines using 2:4:3:1 with lines linewidth 3 linecolor palette, \
    data . "/double-pendulum.csv" using "x":"z":"y" with lines linetype 6
