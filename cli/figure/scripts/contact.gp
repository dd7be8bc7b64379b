# SPDX-License-Identifier: GPL-3.0-or-later
# Bodies and loads. Heights are stretched; in the middle half of the width there is room for the loads above the pad.
title = "A ".pad_name." on a half-plane"
unit = length_unit eq "" ? "" : " ".length_unit
high = 1.35*rise
low = -0.55*rise
ratio = 0.56
xtext = ytext = ""
sticks = stick_left == stick_left
caption = "contact ".said("%.4g", left)." to ".said("%.4g", right).unit
if (sticks) { caption = caption.";\nblack: sticks, ".said("%.4g", stick_left)." to ".said("%.4g", stick_right).unit }
caption = caption.";\ndashed: the pad as it was; heights are stretched"
set border 0
unset xtics
unset ytics
set xrange [-reach:reach]
set yrange [low:high]
set lmargin 1
set rmargin 1
frame
soft = "#59626d"
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0 behind fillcolor rgb "#dde3ea" fillstyle solid 1 noborder
set label 1 "half-plane" at graph 0.02, graph 0.05 left textcolor rgb soft
set label 2 "pad" at first -0.5*reach, first 0.8*high center textcolor rgb soft front
set arrow 1 from first 0, first 0.95*high to first 0, first 0.55*high front linewidth 1.6 head filled size graph 0.02,20
set label 3 it("P")." = ".said("%.4g", P) at first 0.03*reach, first 0.9*high left front
if (Q != 0) {
    set arrow 2 from first (Q > 0 ? -0.28 : 0.28)*reach, first 0.5*high to first (Q > 0 ? -0.06 : 0.06)*reach, first 0.5*high \
        front linewidth 1.6 head filled size graph 0.02,20
    if (Q > 0) { set label 4 it("Q")." = ".said("%.4g", Q) at first -0.3*reach, first 0.5*high right front } else {\
        set label 4 it("Q")." = ".said("%.4g", Q) at first 0.3*reach, first 0.5*high left front }
}
if (M != 0) { set label 5 (M > 0 ? "↻ " : "↺ ").it("M")." = ".said("%.4g", M) at first 0.03*reach, first 0.72*high left front }
if (sigma != 0) {
    set label 6 "σ = ".said("%.4g", sigma) at graph 0.98, graph 0.05 right front
    set arrow 3 from graph (sigma > 0 ? 0.9 : 0.98), graph 0.17 to graph (sigma > 0 ? 0.98 : 0.9), graph 0.17 front linewidth 1.6 \
        head filled size graph 0.02,20
    set arrow 4 from graph (sigma > 0 ? 0.1 : 0.02), graph 0.17 to graph (sigma > 0 ? 0.02 : 0.1), graph 0.17 front linewidth 1.6 \
        head filled size graph 0.02,20
}
if (marked > 0 && marked < reach) {
    set arrow 5 from first 0, first -0.12*rise to first marked, first -0.12*rise front heads filled size graph 0.012,20 linecolor rgb soft
    set label 7 it("a") at first 0.5*marked, first -0.24*rise center front
}
if (theta == theta) { set label 9 "θ" at first 0.9*reach, first 0.18*rise center front }
set arrow 6 from first 0.5*(left + right), first -0.36*rise to first right, first -0.36*rise front heads filled size graph 0.012,20 \
    linecolor rgb soft
set label 8 it("b") at first 0.25*left + 0.75*right, first -0.48*rise center front
plot $rows using 1:2:(high) with filledcurves fillstyle solid 1 noborder linecolor rgb "#eceff3" notitle, \
    $rows using 1:2 with lines linestyle 1 linewidth 1.2 notitle, \
    $rows using 1:3 with lines linestyle 1 linewidth 0.7 dashtype 3 notitle, \
    '+' using (bar_x($0 + 1, -reach, reach)):(0) every ::0::1 with lines linestyle 1 linewidth 0.7 notitle, \
    [0:4] '+' using (sticks ? bar_x($1, stick_left, stick_right) : NaN):(bar_y($1, 0, -0.045*rise)) \
    with filledcurves closed fillstyle solid 1 noborder linecolor rgb '#000000' notitle
