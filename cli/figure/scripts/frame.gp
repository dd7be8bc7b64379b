# SPDX-License-Identifier: GPL-3.0-or-later
# The paper, where a figure has said what it is of. It is as high as the lines of text on it need: gnuplot arranges the names
# of the curves, and keeps the plot's proportion. Paper that is too high or too low costs some white.
if (titled == 0) { title = "" }
lines_of(text) = text eq "" ? 0 : strstrt(text, "\n") == 0 ? 1 : 1 + lines_of(text[strstrt(text, "\n") + 1:*])
longest = 0
do for [name in names] { longest = max(longest, strlen(name)) }
lines = 6 + lines_of(title) + lines_of(caption) + ceil(words(names)*(letters + longest + 7)/36.0)
eval sprintf("set terminal ".terminal, paper, paper*(0.82*ratio + line*lines))
set xlabel xtext.(caption eq "" ? "" : "\n".caption."\n{/*0.4  }") # a low line above the names of the curves
set ylabel ytext
set title title
set tmargin 1 + lines_of(title)
set size ratio ratio
# gnuplot finds the lines of equal height, in a table, which is drawn. What is infinite is high.
if (exists("height")) {
    levels = int(top/step)
    set contour base
    unset surface
    set cntrparam levels incremental step,step,top
    set table $lines
    splot $rows using 1:2:(column(height) == column(height) ? level_of(column(height)) : 2*top) with lines
    unset table
    set palette defined (0 '#9ecae1', 0.5 '#2171b5', 1 '#08306b')
    unset colorbox
}
