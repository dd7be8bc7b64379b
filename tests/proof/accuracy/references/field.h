/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in ball arithmetic, from the potentials of the pressure and of the shear traction:
 * one is the contact's own, the other a sum of patches. Natural units, but lengths in any. */
#ifndef FIELD_H
#define FIELD_H

#include "references/balls.h"

enum { PATCHES_MAX = 32 };

/* The last patch is the contact; f times the weights times the patches' pressures make the shear
 * traction. */
typedef struct {
    int patches;
    ball_patch patch[PATCHES_MAX];
    arb_struct weight[PATCHES_MAX];
    arb_t a, f, kappa; /* rounding; friction; (1-2nu)^2/3 */
    bool shear_alone;  /* the shear traction without the pressure; for ball_stresses() */
} traction;

/* Without patches, for f and nu. */
void traction_init(traction *t, const arb_t a, const arb_t f, double nu, slong prec);
void traction_add(traction *t, const arb_t half_width, const arb_t weight, slong prec);
void traction_clear(traction *t);

/* sxx, syy, txy at z = x + iy. */
void ball_stresses(arb_t sxx, arb_t syy, arb_t txy, const traction *t, const acb_t z, slong prec);

/* J2 and its derivatives by x and y, y > 0: J2, x, y, xx, xy, yy. As many of them as orders 0,
 * 1, 2 have. */
enum { J2_0, J2_X, J2_Y, J2_XX, J2_XY, J2_YY, J2_COUNT };
void ball_J2(arb_ptr J2, int order, const traction *t, const acb_t z, slong prec);

/* The stationary point of J2 next to z: x and y, and J2 there. False where none is proved.
 * flatness receives the smallest curvature times y^2 over J2, if not NULL. */
bool ball_stationary(arb_t x, arb_t y, arb_t J2, double *flatness, const traction *t, const acb_t z,
                     slong prec);

#endif
