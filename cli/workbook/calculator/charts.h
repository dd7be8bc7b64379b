/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The calculator's pictures: a sketch, and Figs. 3, 4 and 6 of the paper, with its case in them. */
#ifndef CLI_CHARTS_H
#define CLI_CHARTS_H

#include "sheet/xlsx.h"

/* The height of the figures. */
enum { FIGURE_ROWS = 22 };

/* The contact with the letters in it, as the inputs name them. */
void draw_sketch(xlsx *book, int row, int column);

/* The factor of the verdict as a bar, with a line where it yields. */
void draw_bar(xlsx *book, int row, int column);

/* The figures stand side by side, from the first column on. */
void draw_figures(xlsx *book, int row);

#endif
