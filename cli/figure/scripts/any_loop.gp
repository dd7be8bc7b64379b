# SPDX-License-Identifier: GPL-3.0-or-later
title = it("Q")." through the history of loads"
xtext = "displacement by slip"
ytext = it("Q")
stats $rows using 6:4 nooutput
left = max(0, -STATS_min_x)
right = max(0, STATS_max_x)
bottom = max(0, -STATS_min_y)
top = max(0, STATS_max_y)
if (top + bottom == 0) { top = 1.0 } # Q stays 0 while a tension moves the bodies
x_margin = 0.05*(right + left)
y_margin = 0.05*(top + bottom)
set xrange [-left - x_margin:right + x_margin]
set xtics tic_along_x(1.1*(right + left))
set yrange [-bottom - y_margin:top + y_margin]
set ytics tic(top + bottom)
ratio = 0.85
frame
plot $rows using 6:4 with lines linestyle 1 linewidth 1.2 notitle
