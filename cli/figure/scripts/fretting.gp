# SPDX-License-Identifier: GPL-3.0-or-later
title = "Smith–Watson–Topper along the surface"
stats $rows using 1 nooutput prefix "x"
stats $rows using 1:2 nooutput
from = x_min
to = x_max
worst = STATS_max_y
caption = "bar: contact; worst: ".sprintf("%.4g at ", worst).it("x")." = ".said("%.4g", STATS_pos_max_y)
xtext = it("x")
ytext = "SWT parameter"
set xrange [from:to]
set xtics tic_along_x(to - from)
set yrange [-0.06*worst:end_of(1.05*worst)]
set ytics tic(1.05*worst)
ratio = 0.75
# the contact is where there is slip to speak of
left = to
right = from
stats $rows using ($4 == $4 ? (left = min(left, $1), right = max(right, $1)) : 0) nooutput
frame
plot $rows using 1:2 with lines linestyle 1 linewidth 1.3 notitle, \
    [0:4] '+' using (left < right ? bar_x($1, left, right) : NaN):(bar_y($1, 0, -0.03*worst)) \
    with lines linestyle 1 linewidth 0.8 notitle
