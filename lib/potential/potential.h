/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential G(z) = (1/pi) int p(t)/(t-z) dt of a pressure p on |t| < 1. All stresses are
 * made of G and y G'. Natural units: lengths in the half-width of the contact, stresses in
 * theta/A; alpha is the rounding over the half-width. */
#ifndef RW_POTENTIAL_H
#define RW_POTENTIAL_H

#include "base/domain.h"

/* What depends on the contact alone, computed once for any number of points. */
typedef struct {
    double half_width, a;   /* of the patch, and the rounding, in the unit of the points */
    double per_half_width;  /* 1/half_width */
    double alpha;           /* a over half_width */
    double per_alpha;       /* its reciprocal, 0 for the sharp wedge */
    double c0;              /* cos(phi0), phi0 = asin(alpha) */
    double phi0_over_alpha; /* 1 for the sharp wedge */
} rw_potential;

/* G and H = y G' at a point. Im G is the pressure and Re G the slope of the profile where y = 0
 * and |x| < 1. */
typedef struct {
    double G_re, G_im, H_re, H_im;
} rw_field;

static inline rw_field rw_field_multiple(double factor, rw_field a)
{
    return (rw_field){factor * a.G_re, factor * a.G_im, factor * a.H_re, factor * a.H_im};
}

/* The potential of the profile of rounding a >= 0, pressed to the half-width c > 0, both in the
 * unit of the points; a/c finite. It takes a and c, not their quotient: where two of a, c and a
 * point are nearly equal, their difference counts, and a quotient would lose its digits. */
void rw_potential_init(rw_potential *potential, double a, double c);

/* y >= 0. x and y over the half-width are 0 or at least 1e-60 in magnitude, and not both 0 for
 * the sharp wedge. The result is finite. The error of each part is below
 * 8 epsilon max(|G|, 1/(1+|z|)). */
rw_field rw_potential_at(const rw_potential *potential, double x, double y);

/* ---- Far from the contact: G = sum b_n R^(2n+1), R = z - sqrt(z^2-1) ---- */

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
