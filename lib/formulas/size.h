/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dimensional geometry of a contact, and its law. */
#ifndef RW_SIZE_H
#define RW_SIZE_H

#include "base/domain.h"
#include "base/scaled.h"

typedef struct {
    double theta, a, A;
} rw_geometry;

static inline bool rw_is_angle(double theta)
{
    return isfinite(theta) && theta > 0 && theta < RW_HALF_PI;
}

static inline bool rw_is_geometry(const rw_geometry *g)
{
    return rw_is_angle(g->theta) && rw_is_nonnegative(g->a) && rw_is_nonnegative(g->A) && g->A > 0;
}

/* theta/A */
static inline rw_scaled rw_unit_stress(const rw_geometry *g)
{
    return rw_scaled_over(rw_scaled_from(g->theta), rw_scaled_from(g->A));
}

/* Half-width under the load P >= 0. */
double rw_half_width(const rw_geometry *geometry, double P);

/* Load of the half-width b > 0, which may be no double where the load is one. */
double rw_normal_load(const rw_geometry *geometry, rw_scaled b);

#endif
