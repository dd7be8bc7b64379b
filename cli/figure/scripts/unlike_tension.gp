# SPDX-License-Identifier: GPL-3.0-or-later
title = "Maximum tension of unlike bodies, by ".it("βf")
xtext = it("a")."/".it("b")
ytext = it("b")."σ_1/(".it("fP").")"
caption = "thick: rotation held; thin: free"
stats $rows using 3 nooutput
highest = STATS_max
lowest = STATS_min
stats $rows using 4 nooutput
highest = max(highest, STATS_max)
lowest = min(lowest, STATS_min)
set xrange [0:1]
set xtics 0.2
step = tic(highest - lowest)
set yrange [step*floor(lowest/step):step*ceil(highest/step)]
set ytics step
ratio = 0.96
names = beta_f
frame
plot for [n=1:words(names)] $rows index n - 1 using 1:3 with lines linestyle n linewidth 1.8 title word(names, n), \
    for [n=1:words(names)] $rows index n - 1 using 1:4 with lines linestyle n linewidth 0.6 notitle
