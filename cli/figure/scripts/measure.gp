# SPDX-License-Identifier: GPL-3.0-or-later
# Along the surface (1) or the depth (2), or as contours (0): of what falls by decades at powers of ten above base, or at 1, 2, 5 times
# these.
stats $rows using 1 nooutput prefix "x"
stats $rows using 2 nooutput prefix "y"
stats $rows using 3 nooutput prefix "value"
sticks = stuck_right > stuck_left && stuck_right > x_min && stuck_left < x_max # is to be seen
caption = sprintf("worst: %.4g at", worst).(along == 0 ? "\n" : " ")
caption = caption.it("x")." = ".said("%.4g", worst_x).", ".it("y")." = ".said("%.4g", worst_y)
if (along != 2) { bars = "bar: contact".(sticks ? ", black: always sticks" : "") }
if (along == 0) {
    height = 3
    top = worst
    lines_said = sprintf("lines: every %.3g", step)
    if (lines_a_decade > 0) {
        decades(value) = log10(value) - base
        part(m) = m < 2 ? log10(m)/log10(2) : m < 5 ? 1 + log10(m/2)/log10(2.5) : 2 + log10(m/5)/log10(2)
        lines_of_decades(d) = lines_a_decade == 1 ? d : 3*floor(d) + part(10**(d - floor(d)))
        level_of(value) = value > 0 && decades(value) > 0 ? lines_of_decades(decades(value)) : 0
        top = level_of(worst)
        lines_said = lines_a_decade == 1 ? sprintf("lines: powers of ten from %.0e on", 10**(base + 1)) : \
            sprintf("lines: 1, 2, 5 times powers of ten, from %.2g on", 2*10**base)
    }
    caption = caption.";\n".lines_said.";\n".bars
    xtext = it("x")
    ytext = it("y")
    set yrange [y_max:-0.1*y_max]
    set ytics 0,tic(2*y_max)
    ratio = 1.1*y_max/(x_max - x_min)
    upper = -0.07*y_max
    lower = -0.02*y_max
    along = 1
} else {
    if (along == 1) { caption = caption.";\n".bars }
    xtext = it(along == 1 ? "x" : "y")
    ytext = unit
    bottom = (along == 1 ? -0.06 : 0)*worst + 1.05*min(0, value_min)
    set yrange [bottom:end_of(1.05*worst)]
    set ytics tic(1.05*worst)
    ratio = 0.75
    upper = bottom + 0.045*worst
    lower = bottom + 0.01*worst
}
from = along == 1 ? x_min : 0
to = along == 1 ? x_max : y_max
inside(x) = max(from, min(to, x))
set xrange [from:to]
set xtics tic_along_x(to - from)
frame
BARS = "[0:4] '+' using (sticks && along == 1 ? bar_x($1, inside(stuck_left), inside(stuck_right)) : NaN):(bar_y($1, upper, lower)) ".\
    "with filledcurves closed fillstyle solid 1 noborder linecolor rgb '#000000' notitle, ".\
    "[0:4] '+' using (along == 1 ? bar_x($1, inside(touched_left), inside(touched_right)) : NaN):(bar_y($1, upper, lower)) ".\
    "with lines linestyle 1 linewidth 0.8 notitle"
if (exists("height")) {
    plot @CONTOURS, @BARS, \
        [0:4] '+' using (worst_x):(worst_y) every ::0::0 with points linestyle 31 notitle
} else {
    plot $rows using along:3 with lines linestyle 1 linewidth 1.3 notitle, @BARS
}
