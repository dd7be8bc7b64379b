/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Higher derivatives of the potential of a contact of half-width 1, which are algebraic, in ball
 * arithmetic. */
#ifndef CURVATURE_H
#define CURVATURE_H

#include "ball_potential.h"

typedef struct {
    acb_t second, third, fourth; /* G'', G''', G'''' */
} curvature;

void curvature_init(curvature *k);
void curvature_clear(curvature *k);

/* alpha > 0; over all of the ball z, which is not to contain ±1 and ±alpha. */
void curvature_enclose(curvature *k, const ball_patch *patch, const acb_t z, slong prec);

#endif
