# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fig. 6: how far the tip of 2, 4 and 8 elements is from that of 16, against time.

set title "Pendulum (section 5.1): tip of 2, 4, 8 elements against 16 (Fig. 6)"
set xlabel "time (s)"
set ylabel "difference of tip height (m)"
set xrange [0:1.2]
set grid
set key top left Left reverse spacing 1.3 samplen 2

# rows of both files side by side: same times
both(mesh) = sprintf("< paste -d, '%s/pendulum-%d.csv' '%s/pendulum-16.csv' | tail -n +2", data, mesh, data)

plot for [k = 1:3] both(2 ** k) using 1:($3 - $13) with lines linetype k title sprintf("%d elements", 2 ** k)
