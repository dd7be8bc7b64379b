# SPDX-License-Identifier: GPL-3.0-or-later
title = "Shear traction in partial slip, ".it("a")."/".it("b")." = ".a_over_b
xtext = it("x")."/".it("b")
ytext = "−".it("qA")."π/(".it("f")."θ)"
# an infinite peak is cut, at least so high; the kinks at the stick zones are to be seen
stats $rows using ($1 == 0 && a_over_b + 0 == 0 ? 10 : 1.02*$3) nooutput
top = STATS_max
set xrange [-1:1]
set xtics 0.5
set yrange [0:end_of(top)]
set ytics tic(top)
ratio = 0.8
ratios = it("c")."/".it("b")." = "
names = c_over_b
letters = 10
do for [c in names] { if (c eq "0") { caption = ratios."0 is full sliding: the pressure, −".it("pA")."π/θ" } }
frame
plot for [n=1:words(names)] $rows index n - 1 using 2:3 with lines linestyle n linewidth 1.4 title ratios.word(names, n)
