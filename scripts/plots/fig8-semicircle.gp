# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fig. 8: the beam bent by an end moment, drawn with its depth, for three meshes of two elements.

file(name, mesh) = sprintf("%s/semicircle-%s-%d.csv", data, name, mesh)
stations = 17  # per element

set multiplot layout 1, 2 title "Bending to a semicircle by an end moment M = π E I / l (Fig. 8)" font ",18"
set size ratio -1
set xrange [-0.07:0.78]
set yrange [-0.07:0.78]
set xtics 0.2
set ytics 0.2
set xlabel "x (m)"
set ylabel "y (m)"
set parametric
set trange [-pi/2:pi/2]
set samples 200

# both faces (corners 0 and 1 of the outline), the nodes on the centre line, the thin limit
do for [element in "cross-section continuum"] {
    if (element eq "continuum") { unset key } else { set key top right Left reverse spacing 1.2 samplen 2.5 }
    set title element eq "continuum" ? "continuum element (Yakoub and Shabana)" : "cross-section element"
    plot cos(t) / pi, (1 + sin(t)) / pi with lines linetype 6 title "thin limit", \
        for [k = 1:3] mesh = int(word("3 6 16", k)) file(element, mesh) using "x0":"y0" with lines linetype k linewidth 1.2 notitle, \
        for [k = 1:3] mesh = int(word("3 6 16", k)) file(element, mesh) using "x1":"y1" with lines linetype k linewidth 1.2 notitle, \
        for [k = 1:3] mesh = int(word("3 6 16", k)) file(element, mesh) using "x":"y" every stations::(stations - 1) with points linetype k pointsize (2.0 - 0.45 * k) notitle, \
        for [k = 1:3] NaN, NaN with linespoints linetype k title sprintf("%s elements", word("3 6 16", k))
}
unset multiplot
