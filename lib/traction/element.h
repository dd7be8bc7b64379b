/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one element does near it, in closed form of its two poles zeta and -zeta (transform.h), or
 * by Gauss's rule, which is as accurate far from the element or from a pole. */
#ifndef RW_ELEMENT_H
#define RW_ELEMENT_H

#include "base/complex.h"
#include "traction/places.h"
#include "traction/traction.h"

/* Let v be on the ellipse about -1 and 1 whose half-axes have the sum rho. There the forward
 * recurrence of Legendre's functions loses digits like rho^(2k), and Gauss's rule errs by
 * rho^(-2n). At rho = 2, where these are the half-axes, both errors are 1e-9 of the traction. */
#define RW_NEAR_POLE_ALONG 1.25
#define RW_NEAR_POLE_ACROSS 0.75

static inline bool rw_is_near_pole(rw_complex v)
{
    const double along = v.re * (1 / RW_NEAR_POLE_ALONG), across = v.im * (1 / RW_NEAR_POLE_ACROSS);
    return along * along + across * across < 1;
}

static inline rw_complex rw_pole_place(const rw_element *e, rw_complex zeta)
{
    const double per_half = 2 / (e->last - e->first);
    return (rw_complex){(zeta.re - e->first) * per_half - 1, zeta.im * per_half};
}

/* Neither pole is near, whichever part of its square-root element this is. */
static inline bool rw_is_far_from_element(const rw_element *e, double x, double y)
{
    const double middle = e->low / 2 + e->high / 2, length = e->high - e->low;
    return fabs(x - middle) > 0.8 * length || y > 0.8 * length;
}

/* The side of its end on which an element lies. */
static inline double rw_side_of(const rw_element *e)
{
    return e->scale < 0 ? -1 : 1;
}

/* Q_0 = ln((v+1)/(v-1))/2; its real part is the principal value where v is real. */
RW_INLINE rw_complex rw_first_function(rw_complex v)
{
    const double up = v.re + 1, down = v.re - 1, square = v.im * v.im;
    return (rw_complex){
        rw_log_of_quotient(up * up + square + DBL_MIN, down * down + square + DBL_MIN) / 4,
        rw_angle(up * down + square, v.im * (down - up)) / 2};
}

/* Adds Omega and y Omega' of an element at places, on the surface Omega alone, whose imaginary part
 * and y Omega' are then not to be read. */
void rw_add_element(const rw_element *element, const rw_places *places, const double x[],
                    const double y[], rw_fields *sum);

#endif
