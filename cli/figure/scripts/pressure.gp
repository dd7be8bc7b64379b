# SPDX-License-Identifier: GPL-3.0-or-later
title = "Contact pressure, by ".it("a")."/".it("b")
xtext = it("x")."/".it("b")
ytext = "−".it("pA")."π/θ"
stats $rows using ($1 == 0 ? 10 : $3) nooutput # an infinite peak is cut, at least so high
top = STATS_max
set xrange [-1:1]
set xtics 0.5
set yrange [0:end_of(top)]
set ytics tic(top)
ratio = 0.85
names = a_over_b
frame
plot for [n=1:words(names)] $rows index n - 1 using 2:3 with lines linestyle n title word(names, n)
