/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of curves, put where they can be read. Until then the legend of a curve has its name. */
#ifndef CLI_NAMES_H
#define CLI_NAMES_H

#include "drawing.h"

/* Each on its curve, clear of other curves, marks and labels. Where one finds no such place, all
 * stay in the legend. */
void names_on_curves(drawing *on);

/* Each on its curve where no other line runs through it, the last curve first; the others have
 * none. */
void names_where_free(drawing *on);

/* The labels from the first on stand above each other, in the order of the points they belong to
 * and as near to them as their height allows. A thin line leads from each to its point at x. */
void names_beside(drawing *on, int first, double x);

#endif
