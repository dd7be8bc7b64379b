# SPDX-License-Identifier: GPL-3.0-or-later
title = "Elastic limit in full sliding, by ".it("a")."/".it("b")."; ν = ".nu
xtext = it("f")
ytext = it("P")."/(".it("bk").")"
stats $rows using 4 nooutput
set xrange [0:0.8]
set xtics 0.2
set yrange [0:end_of(STATS_max)]
set ytics tic(STATS_max)
ratio = 0.96
names = a_over_b
frame
plot for [n=1:words(names)] $rows index n - 1 using 2:4 with lines linestyle n title word(names, n)
