# SPDX-License-Identifier: GPL-3.0-or-later
# Along the surface (1) or the depth (2), or as contours (0).
stats $rows using 1 nooutput prefix "x"
stats $rows using 2 nooutput prefix "y"
stats $rows using 3 nooutput prefix "value"
caption = sprintf("worst: %.4g at", worst).(along == 0 ? "\n" : " ")
caption = caption.it("x")." = ".said("%.4g", worst_x).", ".it("y")." = ".said("%.4g", worst_y)
if (along == 0) {
    height = 3
    top = worst
    caption = caption.sprintf(";\nlines: every %.3g", step)
    xtext = it("x")
    ytext = it("y")
    set yrange [y_max:0]
    set ytics tic_along_x(y_max)
    ratio = y_max/(x_max - x_min)
    along = 1
} else {
    xtext = it(along == 1 ? "x" : "y")
    ytext = unit
    set yrange [1.05*min(0, value_min):end_of(1.05*worst)]
    set ytics tic(1.05*worst)
    ratio = 0.75
}
from = along == 1 ? x_min : 0
to = along == 1 ? x_max : y_max
set xrange [from:to]
set xtics tic_along_x(to - from)
frame
if (exists("height")) {
    plot @CONTOURS
} else {
    plot $rows using along:3 with lines linestyle 1 linewidth 1.3 notitle
}
