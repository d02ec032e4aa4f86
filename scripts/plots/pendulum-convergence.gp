# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Error of the pendulum's tip against the mesh.

set title "Pendulum (section 5.1): convergence of the tip"
set xlabel "number of elements"
set ylabel "largest error at 0.3, 0.5, 0.7, 1 s (m)"
set logscale xy
set xrange [1.7:38]
set xtics (2, 4, 8, 16, 32)
set format y "10^{%L}"
set grid
set key bottom left Left reverse spacing 1.2 samplen 2.5

plot data . "/pendulum-convergence.csv" using 1:2 every ::1 with linespoints linetype 1 title "cross-section (the paper's)", \
    0.3 * x**-2 with lines linetype 6 title "second order"
