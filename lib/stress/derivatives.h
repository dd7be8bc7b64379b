/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the potential of a patch changes with the place, the rounding and the half-width. */
#ifndef RW_DERIVATIVES_H
#define RW_DERIVATIVES_H

#include "potential/potential.h"

#include <complex.h>

static inline double complex rw_number(double re, double im)
{
    return re + im * I;
}

/* The second and third derivatives K = y^2 G'' and L = y^3 G''', which are algebraic. */
typedef struct {
    double complex K, L;
} rw_curvature;

/* The same as rw_potential_at(), with these derivatives. alpha = 0 or >= 1e-50, x >= 0, y > 0, |z|
 * below 1e8 half-widths. */
rw_field rw_potential_with_curvature(const rw_potential *potential, double x, double y,
                                     rw_curvature *curvature);

/* d/dx of G and of H = y G', by the unit of the points; d/dy follows, as both are made of what is
 * analytic. Not at the edges and at the corners of the rounding: there G' is infinite. */
rw_field rw_potential_by_x(const rw_potential *potential, double x, double y);

/* a d/da of G and H, the half-width being constant. */
rw_field rw_potential_by_rounding(const rw_potential *potential, double x, double y);

/* c d/dc of G and H, the rounding being constant: a flat punch. */
rw_field rw_potential_by_half_width(const rw_potential *potential, double x, double y);

#endif
