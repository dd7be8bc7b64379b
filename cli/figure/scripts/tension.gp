# SPDX-License-Identifier: GPL-3.0-or-later
title = "Maximum tension in full sliding"
xtext = it("a")."/".it("b")
ytext = it("b")."σ_1/(".it("fP").")"
set xrange [0:1]
set xtics 0.2
set yrange [0.95:1.3]
set ytics 0.05
ratio = 0.72
set label "1, sharp wedge" at 0.03,1.046 front
set label "4/π, Hertz" at 0.965,4/pi right front
frame
plot $rows using 1:2 with lines linestyle 1 linewidth 1.5 notitle
