# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Table 1: distance of the tip from the Green-strain limit of Model II, over the length, against the mesh.

limit_x = 1.784108719196
limit_y = 0.821973318973
length = 2.0
error(x, y) = sqrt((x - limit_x)**2 + (y - limit_y)**2) / length
file(name) = data . "/convergence-" . name . ".csv"

set title "Cantilever, Model II (Table 1): convergence of the tip position"
set xlabel "number of elements"
set ylabel "error / L"
set logscale xy
set xrange [0.9:72]
set yrange [1e-9:2]
set xtics (1, 2, 4, 8, 16, 32, 64)
set format y "10^{%L}"
set key bottom left reverse Left spacing 1.2 samplen 2.5

plot file("continuum") using 3:(error($8, $9)) every ::1 with linespoints linetype 2 title "continuum, diagonal material", \
    file("continuum-enhanced") using 3:(error($8, $9)) every ::1 with linespoints linetype 5 title "continuum, enhanced", \
    file("cross-section-pointwise") using 3:(error($8, $9)) every ::1 with linespoints linetype 3 title "cross-section, pointwise shear", \
    file("cross-section") using 3:(error($8, $9)) every ::1 with linespoints linetype 1 title "cross-section (the paper's)", \
    file("mixed") using 3:(error($8, $9)) every ::1 with linespoints linetype 4 title "cross-section, mixed rule", \
    (x > 5 && x < 40 ? 2.2e-2 * (x / 5.0)**-4 : 1/0) with lines linetype 6 title "fourth order"
