# SPDX-License-Identifier: GPL-3.0-or-later
title = "Pressure and shear traction"
unit = stress_unit eq "" ? "" : " in ".stress_unit
sticks = stick_left == stick_left
caption = rubs == 0 ? "" : sticks ? "bar: contact, black: sticks; thin: friction's limit" : "bar: contact; it slides, so shear is friction's limit"
xtext = it("x").(length_unit eq "" ? "" : " in ".length_unit)
ytext = "traction".unit
stats $rows using 2 nooutput prefix "p"
stats $rows using 3 nooutput prefix "q"
stats $rows using 4 nooutput prefix "most"
side = q_max > -q_min ? 1 : -1
bottom = (side > 0 ? 0 : -1.05*most_max) - 0.1*p_max
set xrange [left - 0.1*(right - left):right + 0.1*(right - left)]
set xtics tic_along_x(1.2*(right - left))
set yrange [bottom:end_of(1.05*p_max)]
set ytics tic(1.05*p_max - bottom)
names = rubs == 0 ? "pressure" : "pressure shear"
ratio = 0.75
frame
plot $rows using 1:2 with lines linestyle 1 linewidth 1.4 title "pressure", \
    $rows using 1:(rubs == 0 ? NaN : $3) with lines linestyle 3 dashtype 1 linewidth 1.4 title (rubs == 0 ? "" : "shear "), \
    $rows using 1:(rubs == 0 ? NaN : side*$4) with lines linestyle 1 linewidth 0.4 notitle, \
    [0:4] '+' using (bar_x($1, left, right)):(bar_y($1, bottom + 0.06*p_max, bottom + 0.01*p_max)) \
    with lines linestyle 1 linewidth 0.8 notitle, \
    [0:4] '+' using (sticks ? bar_x($1, stick_left, stick_right) : NaN):(bar_y($1, bottom + 0.06*p_max, bottom + 0.01*p_max)) \
    with filledcurves closed fillstyle solid 1 noborder linecolor rgb '#000000' notitle
