# SPDX-License-Identifier: GPL-3.0-or-later
title = "Limit of unlike bodies, by ".it("βf")."; ".it("a")."/".it("b")." = ".a_over_b.", ν = ".nu
xtext = it("f")
ytext = "change of ".it("P")."/(".it("bk")."), %"
caption = "thick: rotation held; thin: free"
change(limit, similar) = 100*(limit/similar - 1)
stats $rows using (change($6, $5)) nooutput
highest = STATS_max
lowest = STATS_min
stats $rows using (change($7, $5)) nooutput
highest = max(highest, STATS_max)
lowest = min(lowest, STATS_min)
step = tic(highest - lowest + 1e-6)
set xrange [0:0.8]
set xtics 0.2
set yrange [step*floor(lowest/step):step*ceil((highest + 1e-6)/step)]
set ytics step
ratio = 0.96
names = beta_f
frame
plot for [n=1:words(names)] $rows index n - 1 using 3:(change($6, $5)) with lines linestyle n linewidth 1.8 title word(names, n), \
    for [n=1:words(names)] $rows index n - 1 using 3:(change($7, $5)) with lines linestyle n linewidth 0.6 notitle
