# SPDX-License-Identifier: GPL-3.0-or-later
title = "Von Mises stress below the contact".(stress_unit eq "" ? "" : ", ".stress_unit)
unit = length_unit eq "" ? "" : " in ".length_unit
sticks = stick_left == stick_left
caption = "bar: contact".(sticks ? ", black: sticks" : "").sprintf("; lines: every %.3g", step)
if (hardest_x == hardest_x) { caption = caption.sprintf(";\ncircle: the largest, %.4g", top) }
xtext = it("x").unit
ytext = it("y").unit
set xrange [0.5*(left + right) - 1.6*half:0.5*(left + right) + 1.6*half]
set yrange [1.5*half:-0.16*half]
set xtics tic_along_x(3.2*half)
set ytics 0,tic(1.5*half)
ratio = 1.66/3.2
height = 6
frame
plot @CONTOURS, \
    [0:4] '+' using (sticks ? bar_x($1, stick_left, stick_right) : NaN):(bar_y($1, -0.09*half, -0.03*half)) \
    with filledcurves closed fillstyle solid 1 noborder linecolor rgb '#000000' notitle, \
    [0:4] '+' using (bar_x($1, left, right)):(bar_y($1, -0.09*half, -0.03*half)) with lines linestyle 1 linewidth 0.8 notitle, \
    [0:4] '+' using (bar_x($1, left - half, right + half)):(0) every ::0::1 with lines linestyle 1 notitle, \
    [0:4] '+' using (hardest_x):(hardest_y) every ::0::0 with points linestyle 31 notitle
