# SPDX-License-Identifier: GPL-3.0-or-later
title = "Range of ".it("K")." over the length of a crack"
xtext = "length of the crack"
ytext = "Δ".it("K")
stats $rows using 1 nooutput prefix "x"
set logscale xy
set xrange [x_min:x_max]
set autoscale yfix
ratio = 0.75
caption = arrest > 0 ? "dotted: where it stops, ".sprintf("%.4g", arrest) : ""
names = "mode_I locked_faces free_faces threshold"
letters = 4
if (arrest > 0) { set arrow from arrest, graph 0 to arrest, graph 1 nohead dashtype 3 linewidth 0.8 }
said_name(n) = n == 1 ? "mode I" : n == 2 ? "locked faces" : n == 3 ? "free faces" : "threshold"
drawn(n) = n < 4 || has_threshold > 0
frame
plot for [n=1:4] $rows using 1:(drawn(n) ? column(n + 1) : NaN) with lines linestyle n linewidth 1.4 \
    title drawn(n) ? said_name(n) : ""
