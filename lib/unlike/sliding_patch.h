/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact of unlike bodies that slides. The shear acts on the pressure: with N = -p,
 *     (1/pi) PV int N/(x - s) ds - mu N = g(x) - delta,
 * mu = -beta f where Q > 0, beta f where Q < 0. N falls to the left edge like the power a = 1/2 -
 * atan(mu)/pi of the distance, to the right one like 1 - a. With mu = 0 all of it is what
 * formulas/arcs.h and potential/ have. */
#ifndef RW_SLIDING_PATCH_H
#define RW_SLIDING_PATCH_H

#include "formulas/arcs.h"
#include "potential/batch.h"
#include "unlike/power_integral.h"

/* Both ways of one pair of bodies: the rules of a and 1 - a. */
typedef struct {
    double mu; /* of Q > 0 */
    rw_power_rule rule[2];
} rw_unlike;

/* mu is finite. */
void rw_unlike_init(rw_unlike *unlike, double mu);

/* One way: 1 where Q > 0, else -1. Where `unlike` is NULL, mu is 0. */
typedef struct {
    const rw_unlike *unlike;
    int way;
} rw_sliding_way;

/* Load, moment and tilt of a patch; units as in formulas/patch.h. */
rw_pressing rw_sliding_pressing(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch);

/* The patch of a load P > 0 and a moment or a tilt; NaN where there is none. */
rw_patch rw_sliding_patch_of_moment(const rw_arcs *arcs, rw_sliding_way slides, double P, double M);
rw_patch rw_sliding_patch_of_tilt(const rw_arcs *arcs, rw_sliding_way slides, double P,
                                  double tilt);

/* The potential of the pressure at n <= RW_BATCH points, as rw_pad_fields() has it. */
void rw_sliding_fields(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, int n,
                       const double x[], const double y[], rw_fields *fields);

/* The pressure at a place of the surface, 0 outside of the patch; not at a kink. */
double rw_sliding_pressure(const rw_arcs *arcs, rw_sliding_way slides, rw_patch patch, double x);

#endif
