# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Time per element of one Newton iteration against the number of elements, one thread, rule "paper".

rows = sprintf("< awk -F, 'NR == 1 || ($2 == \"paper\" && $4 == 1 && $5 == \"block-tridiagonal\")' '%s/assembly_solve.csv'", data)
set logscale x
set format x "10^{%L}"
set yrange [0:]
set grid
set key top left
set xlabel "elements"
set ylabel "microseconds per element"
plot rows using "elements":(1e3 * ($7 + $8 + $9) / $1) with linespoints linetype 1 title "one Newton iteration", \
    rows using "elements":(1e3 * $7 / $1) with linespoints linetype 2 title "assembly", \
    rows using "elements":(1e3 * $8 / $1) with linespoints linetype 3 title "factorisation", \
    rows using "elements":(1e3 * $9 / $1) with linespoints linetype 4 title "solution"
