# SPDX-License-Identifier: GPL-3.0-or-later
stats $rows using 2:3 nooutput
at_x = STATS_min_x
at_y = STATS_min_y
title = "Stresses at ".it("x")." = ".said("%.6g", at_x).", ".it("y")." = ".said("%.6g", at_y)
xtext = "load"
ytext = "stress"
stats $rows using 1 nooutput
first = STATS_min
last = STATS_max
top = bottom = 0.0
do for [k=4:7] { if (k != 6) {
    stats $rows using k nooutput
    top = max(top, STATS_max)
    bottom = max(bottom, -STATS_min)
} }
last = last > first ? last : first + 1
x_tic = last - first > 10 ? max(1, tic(last - first)) : 1
margin = 0.05*(top + bottom)
set xrange [first:last]
set xtics x_tic
set yrange [-bottom - margin:top + margin]
set ytics tic(top + bottom)
ratio = 0.75
names = "4 5 7" # the columns
letters = 7
stress(i) = i == 1 ? it("σ")."_x" : i == 2 ? it("σ")."_y" : it("τ")."_x_y"
frame
plot for [n=1:3] $rows using 1:(column(word(names, n) + 0)) with lines linestyle n linewidth 1.3 title stress(n)
