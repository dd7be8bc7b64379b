/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The memory diagram of a load history in balls: the path T(s), T = Q/f, whose slopes D weight
 * the patches of shear traction (lib/README.md, "Load histories"). Loads closer than 2^-(prec/2)
 * of each other count as equal: what that leaves out is of the order of its square root. */
#ifndef MEMORY_H
#define MEMORY_H

#include "references/balls.h"

enum { CORNERS_MAX = 30 };

/* Corner 0 is the origin; ratio is the slope D of the path from the corner before. */
typedef struct {
    arb_t load, shear, ratio;
} corner;

typedef struct {
    int count;
    corner corners[CORNERS_MAX];
} path;

void path_init(path *p); /* of a contact without load */
void path_copy(path *copy, const path *p);
void path_clear(path *p);

/* In a straight line to (load, shear). */
void path_advance(path *p, const arb_t load, const arb_t shear, slong prec);

/* The shear where the path has that load. */
void path_shear(arb_t shear, const path *p, const arb_t load, slong prec);

/* -1, 0, 1; 0 for what is below 2^-(prec/2) of the scale. */
int sign_beside(const arb_t value, const arb_t scale, slong prec);

#endif
