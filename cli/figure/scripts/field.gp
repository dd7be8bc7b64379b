# SPDX-License-Identifier: GPL-3.0-or-later
stuck = it("c")."/".it("b")." = ".(exists("c_over_b") ? c_over_b : "0")
slips = exists("Q_over_fP") ? it("Q")."/(".it("fP").") = ".Q_over_fP : stuck
title = "√".it("J")."_2 in θ/".it("A").": ".it("a")."/".it("b")." = ".a_over_b.", ".it("f")." = ".f.",\n"
title = title.(f eq "0" ? "" : slips.", ")."ν = ".nu
zones = stick > 0 ? ", black: stick" : f eq "0" ? "" : ", sliding"
caption = "bar: contact".zones.sprintf("; lines: every %.3g", step)
if (yields > 0) { caption = caption.sprintf(";\ncircle: first yield, %.3g", most) }
xtext = it("x")."/".it("b")
ytext = it("y")."/".it("b")
set xrange [-1.5:1.5]
set xtics 0.5
set yrange [1.5:-0.16]
set ytics 0,0.5,1.5
ratio = 1.66/3
height = 6
frame
plot @CONTOURS, \
    [0:4] '+' using (stick > 0 ? bar_x($1, -stick, stick) : NaN):(bar_y($1, -0.09, -0.03)) \
    with filledcurves closed fillstyle solid 1 noborder linecolor rgb '#000000' notitle, \
    [0:4] '+' using (bar_x($1, -1, 1)):(bar_y($1, -0.09, -0.03)) with lines linestyle 1 linewidth 0.8 notitle, \
    [0:4] '+' using (bar_x($1, -1.5, 1.5)):(0) every ::0::1 with lines linestyle 1 notitle, \
    [0:4] '+' using (yields > 0 ? yield_x : NaN):(yield_y) every ::0::0 with points linestyle 31 notitle
