# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Princeton beam: tip displacements against the angle of the load, and an exact beam at some angles.

loads = "4.448 8.896 13.345"
file(load) = sprintf("%s/princeton-%s.csv", data, load)

set multiplot layout 1, 2 title "The Princeton beam: 508 mm of aluminium, 12.4 mm by 3.2 mm" font ",18"
set xrange [0:90]
set xtics 15
set xlabel "angle of the load from the chord (degrees)"
set key top left Left reverse spacing 1.2 samplen 2.5
height(column) = column eq "flapwise" ? 300 : 18  # room for the key above the curves
do for [column in "flapwise chordwise"] {
    set yrange [0:height(column)]
    set ylabel column." displacement of the tip (mm)"
    if (column eq "chordwise") { unset key }
    plot for [k = 1:3] file(word(loads, k)) using "angle":(1e3 * column(column)) smooth csplines linetype k \
             title sprintf("%s N, 16 elements", word(loads, k)), \
         data."/princeton.csv" using "angle":(1e3 * column("reference_".column)) with points linetype 6 pointtype 6 \
             pointsize 1.0 title "geometrically exact beam"
}
unset multiplot
