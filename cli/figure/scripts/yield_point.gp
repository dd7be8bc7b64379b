# SPDX-License-Identifier: GPL-3.0-or-later
title = "Subsurface yield point, by ".it("a")."/".it("b")."; ν = ".nu
caption = "crosses: every 0.0125 in ".it("f").";\ncircles: jump to the surface"
xtext = it("x")."/".it("b")
ytext = it("y")."/".it("b")
surface = ";\nalways at the surface: ".it("a")."/".it("b")." = "
do for [i=1:words(missing)] {
    caption = caption.(i == 1 ? surface : i%3 == 1 ? ",\n" : ", ").word(a_over_b, word(missing, i) + 0)
}
stats $rows using 4:5 nooutput
down = end_of(1.02*STATS_max_y)
right = max(1.05*STATS_max_x, down)
set xrange [0:end_of(right)]
set xtics tic(right)
set yrange [down:0]
set ytics tic(1.02*STATS_max_y)
ratio = down/end_of(right)
do for [i in drawn] { names = names." ".word(a_over_b, i + 0) }
frame
plot for [i=1:words(drawn)] $rows index i - 1 using 4:5 with lines linestyle word(drawn, i) + 0 title word(names, i), \
    for [i=1:words(drawn)] $rows index i - 1 using (strcol(6) eq "step" ? $4 : NaN):5 with points linestyle 30 \
    linecolor rgb word(colours, (word(drawn, i) - 1)%5 + 1) notitle, \
    for [i=1:words(drawn)] $rows index i - 1 using (strcol(6) eq "jump" ? $4 : NaN):5 with points linestyle 31 notitle
