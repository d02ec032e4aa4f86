# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Processor time of every run against its error, by element; the line joins the runs that no other is as
# cheap and as exact as, where a run counts with the largest error of those of its family that are at least as fine.
# A case that was not run is left out.

cases = "model2 semicircle bend45 twist pendulum link"
titles = "'Model II' semicircle '45-degree bend' twist pendulum 'link pendulum'"
errors = "'relative error of the tip' 'relative error of the tip' 'relative error of the tip' 'error of the angle (rad)' 'error of the tip (m)' 'error of the tip (m)'"
elements = "cross-section cross-section-geodesic cross-section-pointwise continuum torsion cable cross-section-quintic planar planar-continuum planar-cable"
rows(scene, element) = sprintf("< awk -F, 'NR == 1 || ($1 == \"%s\" && $2 == \"%s\")' '%s/speed_runs.csv'", scene, element, data)
front(scene) = sprintf("< awk -F, 'NR == 1 || $1 == \"%s\"' '%s/speed_front.csv'", scene, data)

set multiplot layout 2, 3 title "Processor time against error" font ",18"
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xtics 100
set grid
set key top right Left reverse spacing 1.0 samplen 0.6 font ",9"
point(j) = j < 8 ? 6 : 4
colour(j) = (j - 1) % 7 + 1
do for [k = 1:words(cases)] {
    scene = word(cases, k)
    if (int(system(sprintf("grep -c '^%s,' '%s/speed_runs.csv' || true", scene, data))) == 0) { continue }
    set title word(titles, k)
    set xlabel word(errors, k)
    set ylabel "processor time (ms)"
    # the bend has room for what all pictures need
    if (scene eq "bend45") { set key; set yrange [* : 1e4] } else { unset key; set yrange [* : *] }
    named = scene eq "bend45" ? words(elements) : 0
    plot for [j = 1:words(elements)] rows(scene, word(elements, j)) using "error":"cpu_ms" with points pointtype point(j) pointsize 0.5 linecolor colour(j) notitle, \
        front(scene) using "error":"cpu_ms" with lines linecolor rgb "black" linewidth 1.5 notitle, \
        for [j = 1:named] keyentry with points pointtype point(j) pointsize 0.8 linecolor colour(j) title word(elements, j), \
        for [j = 1:(named > 0 ? 1 : 0)] keyentry with lines linecolor rgb "black" linewidth 1.5 title "no run is as good in both"
}
unset multiplot
