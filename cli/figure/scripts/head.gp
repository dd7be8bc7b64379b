# SPDX-License-Identifier: GPL-3.0-or-later
# What every figure begins with. Before it stand terminal, paper and line; after it a variable of the figure and its values,
# as the words of a text, such as a_over_b; $rows; and what the figure says in C.
set encoding utf8
set minussign
set style textbox opaque margins 0.3,0.1 noborder
set tics scale 0.6 nomirror
set format x '%g'
set format y '%g'
set border 3
set rmargin 2
set xlabel offset 0,0.4
set ylabel offset 0.3,0
set y2label offset -0.5,0
set title offset 0,-0.5
set key below center horizontal reverse Left samplen 2.2 width 1
set samples 5 # of '+': the corners of a bar

# What a figure says of itself: its texts; the height of the plot over its width; names of curves, of so many letters more.
title = caption = names = ""
letters = 0

it(text) = "{/:Italic ".text."}"
level_of(height) = height # of what lines of equal height are drawn
max(a, b) = a > b ? a : b
min(a, b) = a < b ? a : b

# A round distance between tics: four to seven of them in a span, mostly. The end of an axis from 0.
decade(span) = 10**floor(log10(span/6.5))
parts(span) = span/6.5/decade(span)
tic(span) = decade(span)*(parts(span) <= 1 ? 1 : parts(span) <= 2 ? 2 : parts(span) <= 5 ? 5 : 10)
half_tic(largest) = 0.5*tic(largest)
end_of(largest) = half_tic(largest)*ceil(largest/half_tic(largest) - 1e-9)

# Along x the numbers of the tics stand side by side: long ones get two or three.
half_decade(span) = 10**floor(log10(span/2))
tic_of_two(span) = half_decade(span)*(span/2 < 2*half_decade(span) ? 1 : span/2 < 5*half_decade(span) ? 2 : 5)
tic_along_x(span) = strlen(sprintf("%g", tic(span))) <= 4 ? tic(span) : tic_of_two(span)

# A number as it is said, with a minus sign, not a hyphen.
said(format, value) = (value < 0 ? "−" : "").sprintf(format, abs(value))

# Lines of equal height, a level at a time: a line of one colour has no joints. A figure that has them says the column of
# `height`, and the step from line to line up to the top.
CONTOURS = "for [i=1:levels] $lines using 1:(abs($3 - i*step) < 0.5*step ? $2 : NaN) ".\
    "with lines linewidth 0.9 linecolor palette frac i/real(levels) notitle"

# The corners of a bar, one after the other.
bar_x(i, from, to) = i == 1 || i == 2 ? to : from
bar_y(i, top, bottom) = i == 2 || i == 3 ? bottom : top

# The palette of Okabe and Ito, which the colour-blind can tell apart, without its yellow, which is too pale on paper. In a
# family colour and dashes both change, so that either tells neighbours apart: 4 and 5 have no common divisor, a pair comes
# again after 20.
colours = "#000000 #0072b2 #d55e00 #009e73 #cc79a7"
vermillion = "#d55e00"
set dashtype 2 (9,4)
set dashtype 3 (3,3)
set dashtype 4 (9,3,2,3)
do for [i=0:19] { set style line i + 1 linewidth 1 dashtype i%4 + 1 linecolor rgb word(colours, i%5 + 1) }
set style line 30 linewidth 0.7 pointtype 2 pointsize 0.35 # crosses
set style line 31 linewidth 1.2 pointtype 6 pointsize 0.7 linecolor rgb vermillion # circles
