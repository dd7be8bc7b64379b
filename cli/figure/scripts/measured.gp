# SPDX-License-Identifier: GPL-3.0-or-later
title = "A measured loop"
xtext = "displacement"
ytext = it("Q")
stats $rows using 1:2 nooutput
x_margin = 0.05*(STATS_max_x - STATS_min_x)
y_margin = 0.08*(STATS_max_y - STATS_min_y)
set xrange [STATS_min_x - x_margin:STATS_max_x + x_margin]
set xtics tic_along_x(1.1*(STATS_max_x - STATS_min_x))
set yrange [STATS_min_y - y_margin:STATS_max_y + y_margin]
set ytics tic(STATS_max_y - STATS_min_y)
ratio = 0.85
caption = (f == f) ? sprintf("%s = %.4g, compliance %.4g", it("f"), f, compliance) : sprintf("a line, compliance %.4g", compliance)
names = "measured fitted"
letters = 2
frame
plot $rows using 1:2 with points pointtype 7 pointsize 0.25 linecolor rgb word(colours, 2) title "measured", \
    $rows using 1:3 with lines linestyle 1 linewidth 1.2 title "fitted"
