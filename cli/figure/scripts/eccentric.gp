# SPDX-License-Identifier: GPL-3.0-or-later
title = "Shear traction with bulk tension,\n".it("a")."/".it("b")." = ".a_over_b.", ".it("Q")."/(".it("fP").") = ".Q_over_fP
caption = "bars: stick zones; thin line: friction's limit"
xtext = it("x")."/".it("b")
ytext = "−".it("qA")."π/(".it("f")."θ)"
stats $rows using 3 nooutput
top = STATS_max
bottom = max(0, -STATS_min)
step = 0.05*(top + bottom)
names = sigma_over_max
letters = 17
set xrange [-1:1]
set xtics 0.5
set yrange [-bottom - step*(words(names) + 1):end_of(1.05*top)]
set ytics tic(1.05*top)
ratio = 0.9
frame
plot $limit using 1:2 with lines linestyle 1 linewidth 0.5 notitle, \
    for [n=1:words(names)] $rows index n - 1 using 2:3 with lines linestyle n linewidth 1.4 \
    title "π".it("b")."σ/(4".it("Q").") = ".word(names, n), \
    for [n=1:words(names)] $rows index n - 1 using (0.5*($4 + $5)):(-bottom - step*(n + 0.25)):4:5: \
    (-bottom - step*(n + 0.5)):(-bottom - step*n) every ::0::0 with boxxyerror linestyle n linewidth 1.4 fillstyle empty notitle
