# SPDX-License-Identifier: GPL-3.0-or-later
title = "Shakedown and first yield in sliding, by ".it("a")."/".it("b")."; ν = ".nu
xtext = it("f")
ytext = it("P")."/(".it("bk").")"
caption = "thick: carried pass after pass; thin: first yield"
stats $rows using 5 nooutput
set xrange [0:0.8]
set xtics 0.2
set yrange [0:end_of(STATS_max)]
set ytics tic(STATS_max)
ratio = 0.96
names = a_over_b
frame
plot for [n=1:words(names)] $rows index n - 1 using 2:5 with lines linestyle n linewidth 1.8 title word(names, n), \
    for [n=1:words(names)] $rows index n - 1 using 2:4 with lines linestyle n linewidth 0.6 notitle
