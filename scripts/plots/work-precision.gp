# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Processor time of every integrator against its error, scene by scene.

scenes = "plane space stiff link double frame"
titles = "'planar rubber pendulum' 'rubber pendulum in space' 'planar, E times 100' 'planar, on a massless link' 'double pendulum with a hinge' 'frame of three members'"
methods = "'Radau 3' 'Radau 5' 'generalized-alpha fixed' 'generalized-alpha adaptive' 'energy-momentum' 'IDA index 3' 'explicit ARK436' 'explicit Fehlberg'"
colours = "blue blue orange orange purple green grey grey"
rows(scene, method) = sprintf("< awk -F, 'NR == 1 || ($1 == \"%s\" && $3 == \"%s\" && $15 == \"converged\")' '%s/work_precision.csv'", scene, method, data)
count(scene, method) = int(system(sprintf("grep -c '^%s,[0-9]*,%s,.*,converged$' '%s/work_precision.csv' || true", scene, method, data)))
colour(j) = value(word(colours, j))
point(j) = j % 2 == 0 ? 6 : 7
dash(j) = j == 2 || j == 4 || j == 8 ? 2 : 1

set multiplot layout 2, 3 title "Work against precision, 8 elements" font ",18"
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xrange [2e-7:1e-2]
set grid
set xlabel "largest error of the tip (m)"
set ylabel "processor time (ms)"
set key top right Left reverse spacing 1.0 samplen 2.5 font ",10"
do for [k = 1:words(scenes)] {
    set title word(titles, k)
    # one picture has room for what all of them need
    named = word(scenes, k) eq "double" ? words(methods) : 0
    if (named > 0) { set key; set yrange [* : 1e5] } else { unset key; set yrange [* : *] }
    plot for [j = 1:words(methods)] (count(word(scenes, k), word(methods, j)) > 0 ? rows(word(scenes, k), word(methods, j)) : "< printf 'error,cpu_ms\n1,1\n'") \
        using "error":"cpu_ms" with linespoints linecolor rgb colour(j) dashtype dash(j) linewidth 1.5 pointtype point(j) pointsize 0.5 notitle, \
        for [j = 1:named] keyentry with linespoints linecolor rgb colour(j) dashtype dash(j) linewidth 1.5 pointtype point(j) pointsize 0.5 title word(methods, j)
}
unset multiplot
