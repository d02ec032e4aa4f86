# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# How far the total energy of the pendulum is from zero, where it begins, by integrator; four elements.

integrators = "ida-index3 ida-ggl generalized-alpha energy"

set title "Pendulum (section 5.1): total energy, 4 elements"
set xlabel "time (s)"
set ylabel "|kinetic + strain + potential energy| (J)"
set xrange [0:1.2]
set logscale y
set yrange [1e-14:1e-2]
set format y "10^{%L}"
set grid
set key at graph 0.97, 0.52 Left reverse spacing 1.3 samplen 2.5

plot for [k = 1:4] data . "/pendulum-" . word(integrators, k) . ".csv" using "t":(column("t") > 0 ? abs(column("total")) : NaN) \
    with lines linetype k linewidth 1.5 title word(integrators, k)
