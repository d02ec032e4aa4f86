# SPDX-FileCopyrightText: 2026 The ancf authors
# SPDX-License-Identifier: BSD-3-Clause
#
# What all figures share. Colours tell apart for the colour-blind too (Okabe and Ito).

set encoding utf8
set datafile separator ","
set border linecolor rgb "#404040"
set grid linecolor rgb "#d8d8d8" linetype 1 linewidth 0.6
set key noenhanced
set tics nomirror

blue = "#0072b2"; orange = "#d55e00"; green = "#009e73"; purple = "#aa4499"; grey = "#808080"; yellow = "#e69f00"
set linetype 1 linecolor rgb blue   linewidth 2 pointtype 7  pointsize 1.1
set linetype 2 linecolor rgb orange linewidth 2 pointtype 5  pointsize 1.0
set linetype 3 linecolor rgb green  linewidth 2 pointtype 9  pointsize 1.2
set linetype 4 linecolor rgb purple linewidth 2 pointtype 13 pointsize 1.3
set linetype 5 linecolor rgb yellow linewidth 2 pointtype 11 pointsize 1.2
set linetype 6 linecolor rgb grey   linewidth 1.5 dashtype 2
