# SPDX-License-Identifier: GPL-3.0-or-later
title = "Lives of tests"
xtext = "predicted life"
ytext = "measured life"
set logscale xy
stats $rows using 2 nooutput prefix "x"
stats $rows using 3 nooutput prefix "y"
least = 10**floor(log10(min(x_min, y_min)))
most = 10**ceil(log10(max(x_max, y_max)))
set xrange [least:most]
set yrange [least:most]
set format x '10^{%T}'
set format y '10^{%T}'
ratio = 1
caption = "dashed: a factor of 2; dotted: of 3"
names = "broken run-out"
letters = 2
runs_out(flag) = flag > 0
frame
plot x with lines linestyle 1 notitle, \
    2*x with lines linestyle 2 linewidth 0.7 notitle, x/2 with lines linestyle 2 linewidth 0.7 notitle, \
    3*x with lines linestyle 3 linewidth 0.7 notitle, x/3 with lines linestyle 3 linewidth 0.7 notitle, \
    $rows using 2:(runs_out($4) ? NaN : $3) with points pointtype 7 pointsize 0.6 linecolor rgb word(colours, 2) title "broken", \
    $rows using 2:(runs_out($4) ? $3 : NaN) with points pointtype 8 pointsize 0.8 linecolor rgb vermillion title "run-out"
