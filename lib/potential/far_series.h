/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential far from the contact: G = sum b_n R^(2n+1), R = z - sqrt(z^2-1). */
#ifndef RW_FAR_SERIES_H
#define RW_FAR_SERIES_H

#include "base/domain.h"
#include "potential/potential.h"

/* b_0, A P/(theta b) times 2/pi. */
static inline double rw_first_coefficient(const rw_potential *p)
{
    return p->alpha < 1 ? 2 / RW_PI * (p->phi0_over_alpha + p->c0) : 1 / p->alpha;
}

/* The coefficients b_n, as many as count where |R| is below 1/4. They come from exp(i m phi0) by
 * repeated rotation. Their absolute error is small, which is enough for a sum. Those of
 * rwedge_coefficient() have a small relative error. */
enum { RW_FAR_TERMS = 16 };
void rw_potential_far_coefficients(const rw_potential *potential, double far[RW_FAR_TERMS]);

#endif
