/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the parts of a picture lie: its margins follow from the texts that stand in them. Lengths
 * are in em, the size of the font, from the lower left corner. */
#ifndef CLI_PAGE_H
#define CLI_PAGE_H

#include "drawing.h"

typedef struct {
    double width, height;                            /* of the picture */
    double left, right, bottom, top;                 /* the edges of the plot */
    char title[DRAWING_TEXT], caption[DRAWING_TEXT]; /* in lines */
    int legend_columns;                              /* 0 where there is no legend */
    double legend_step;                              /* from column to column */
} page;

static const double PAGE_LINE = 1.25;  /* from line to line */
static const double PAGE_SAMPLE = 2.2; /* of a curve, in the legend */
static const double PAGE_GAP = 0.4;    /* from there to its name */

page page_of(const drawing *plot);

/* Where the text of the legend's entry i starts; its sample is to the left. */
double page_legend_x(const page *on, int i);
double page_legend_y(const page *on, int i, int entries);

#endif
