/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a shear traction t does to the pressure of unlike bodies, but for the factor B:
 *     L[t](x) = |X| (1/pi) PV int t/(|X| (s - x)) ds,   X^2 = (s - left)(s - right),
 * is 0 at both edges of the patch, and its own transform is t and a constant. It is |X| times the
 * slope of a traction, the density t/|X|, which is smooth where t is like a root. */
#ifndef RW_BOUNDED_INVERSE_H
#define RW_BOUNDED_INVERSE_H

#include "formulas/patch.h"
#include "traction/traction.h"

typedef struct {
    rw_patch patch;
    rw_traction density;
    double moment[3]; /* int u^n t/|X| ds, u in half-widths from the middle */
} rw_bounded_inverse;

/* Makes that of a function on a patch, with breaks and tolerance as in rw_traction_fit(). false
 * where memory is short; then there is nothing to destroy. */
bool rw_bounded_inverse_create(rw_bounded_inverse *inverse, rw_patch patch, rw_values t,
                               const void *context, size_t breaks, const double at[],
                               double tolerance);
void rw_bounded_inverse_destroy(rw_bounded_inverse *inverse);

/* Appends to `sum` another traction and `factor` L[t], on a patch; breaks are those of both. false
 * where memory is short. */
bool rw_bounded_inverse_add(rw_traction *sum, const rw_traction *other,
                            const rw_bounded_inverse *inverse, rw_patch patch, double factor,
                            size_t breaks, const double at[], double tolerance);

/* L[t] at a place; of a function that is scaled, with its patch, to another patch. 0 outside. */
double rw_bounded_inverse_at(const rw_bounded_inverse *inverse, rw_patch patch, double x);

#endif
