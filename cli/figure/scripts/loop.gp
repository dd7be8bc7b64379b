# SPDX-License-Identifier: GPL-3.0-or-later
title = "Cycles of ".it("Q")." under constant ".it("P").", ".it("a")."/".it("b")." = ".a_over_b
caption = "amplitude: ".it("W").", energy per cycle in (".it("f")."θ".it("b").")²/".it("A")
xtext = "displacement by slip / (".it("f")."θ".it("b").")"
ytext = it("Q")."/(".it("fP").")"
stats $rows using 4 nooutput
reach = STATS_max
# dissipated from the first turn, the row 100, to the end: a whole cycle
energies = ""
do for [n=1:words(Q_over_fP)] {
    stats $rows index n - 1 using 6 nooutput
    all = STATS_max
    stats $rows index n - 1 every ::100::100 using 6 nooutput
    energies = energies.sprintf(" %.7g", all - STATS_max)
}
set xrange [-1.05*reach:1.05*reach]
set xtics tic(2.1*reach)
set yrange [-1.1:1.1]
set ytics 0.5
ratio = 0.85
names = Q_over_fP
energy(n) = sprintf("%#.3g", word(energies, n) + 0)
do for [n=1:words(names)] { letters = max(letters, 8 + strlen(energy(n))) }
frame
plot for [n=1:words(names)] $rows index n - 1 using 4:3 with lines linestyle n linewidth 1.3 \
    title word(names, n).": ".it("W")." = ".energy(n)
