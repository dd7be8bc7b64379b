# SPDX-License-Identifier: GPL-3.0-or-later
title = "Elastic limit under a normal load, ν = ".nu
xtext = it("a")."/".it("b")
ytext = it("P")."/(".it("bk").")"
# where the depth jumps, and from which depth: the first curve is of the surface, and begins with the sharp wedge
jump = jump_depth = 0
stats $rows using 1 nooutput
if (STATS_blocks > 1) {
    stats $rows index 0 using 1 nooutput
    records = STATS_records
    stats $rows index 1 every ::0::0 using 1:4 nooutput
    if (records > 1) { jump = STATS_min_x; jump_depth = STATS_min_y }
}
limit = depth = last = NaN # at some a/b
stats $rows using (limit = (limit == limit || $1 < 0.42 ? limit : $3)) nooutput
stats $rows using (depth = (depth == depth || $1 < 0.66 ? depth : $4)) nooutput
stats $rows using (last = (last == last || $1 < 1 ? last : $3)) nooutput
top = ceil(last) > 4 ? ceil(last) : 5
set xrange [0:1]
set xtics 0.2
set yrange [0:top]
set ytics 1
set y2range [0:1]
set y2tics 0.2
set format y2 '%g'
set y2label it("y")."/".it("b")." of the yield point"
set border 11
set rmargin # as wide as it needs
ratio = 0.85
set label "← ".ytext at 0.42,(limit + 0.05*top) right front
set label it("y")."/".it("b")." →" at second 0.66,(depth > 0.2 ? depth - 0.07 : depth + 0.07) front textcolor rgb vermillion
if (jump > 0 && jump < 0.5) {
    set label sprintf("jump at %.4g", jump) at second max(jump + 0.03, 0.08),0.07 front textcolor rgb vermillion
}
if (jump >= 0.5) { set label sprintf("jump at %.4g", jump) at second (jump - 0.03),0.07 right front textcolor rgb vermillion }
frame
plot for [n=0:1] $rows index n using 1:3 with lines linestyle 1 linewidth 1.5 notitle, \
    for [n=0:1] $rows index n using 1:4 axes x1y2 with lines linewidth 1.5 dashtype 2 linecolor rgb vermillion notitle, \
    [0:4] '+' using (jump > 0 ? jump : NaN):($1 > 0 ? jump_depth : 0) every 4 axes x1y2 \
    with lines linewidth 1 dashtype 3 linecolor rgb vermillion notitle
