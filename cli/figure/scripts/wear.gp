# SPDX-License-Identifier: GPL-3.0-or-later
title = "Where wear ends"
stats $rows using 1 nooutput prefix "x"
stats $rows using (-$3) nooutput prefix "p"
stats $rows using 2 nooutput prefix "d"
top = 2*p_max
deepest = 1.1*d_max
caption = "below: what is worn off; up to ".sprintf("%.3g", d_max)
xtext = it("x")
ytext = "−".it("p")
set xrange [x_min - 0.05*(x_max - x_min):x_max + 0.05*(x_max - x_min)]
set xtics tic_along_x(x_max - x_min)
set yrange [-0.4*top:top]
set ytics 0,tic(top)
ratio = 0.9
letters = 6
names = "before after depth"
set arrow from graph 0, first 0 to graph 1, first 0 nohead linewidth 0.5
frame
plot $rows using 1:(-$3) with lines linestyle 2 linewidth 1.2 title "pressure before", \
    $rows using 1:($4 < 0 && -$4 < 1.2*top ? -$4 : NaN) with lines linestyle 1 linewidth 1.4 title "after", \
    $rows using 1:(-0.35*top*$2/d_max) with filledcurves y=0 fillcolor rgb vermillion fillstyle solid 0.4 title "worn off"
