# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fig. 7: height of the pendulum's tip against time, 2 and 16 elements.

set title "Pendulum (section 5.1): height of the tip (Fig. 7)"
set xlabel "time (s)"
set ylabel "y (m)"
set xrange [0:1.2]
set grid
set key top center Left reverse spacing 1.3 samplen 2.5

plot data . "/pendulum-2.csv" using "t":"y" with lines linetype 2 dashtype 2 title "2 elements", \
    data . "/pendulum-16.csv" using "t":"y" with lines linetype 1 title "16 elements"
