/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The second and third derivatives of the potential. */
#ifndef RW_CURVATURE_H
#define RW_CURVATURE_H

#include "potential/potential.h"

/* K = y^2 G'' and L = y^3 G''', which are algebraic. */
typedef struct {
    double K_re, K_im, L_re, L_im;
} rw_curvature;

/* The same as rw_potential_at(), with these derivatives. alpha = 0 or >= 1e-50, x >= 0, y > 0, |z|
 * below 1e8
 * half-widths. */
rw_field rw_potential_with_curvature(const rw_potential *potential, double x, double y,
                                     rw_curvature *curvature);

#endif
