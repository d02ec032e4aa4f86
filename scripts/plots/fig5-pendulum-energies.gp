# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fig. 5: energies of the pendulum against time, four elements as in the paper.

set title "Pendulum (section 5.1): energy balance, 4 elements (Fig. 5)"
set xlabel "time (s)"
set ylabel "energy (J)"
set xrange [0:1.2]
set grid
set key outside right center vertical Left reverse spacing 1.3 samplen 2

plot data . "/pendulum-4.csv" using "t":"kinetic" with lines linetype 1 title "kinetic", \
    "" using "t":"strain" with lines linetype 2 title "strain", \
    "" using "t":"potential" with lines linetype 3 title "potential", \
    "" using "t":"total" with lines linetype 4 title "total"
