/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry of a contact with units, and its size under a load. */
#ifndef RW_SIZE_H
#define RW_SIZE_H

#include "base/domain.h"
#include "formulas/patch.h"

typedef struct {
    double theta, a, A;
} rw_geometry;

static inline bool rw_is_angle(double theta)
{
    return rw_is_positive(theta) && theta < RW_HALF_PI;
}

static inline bool rw_is_geometry(const rw_geometry *g)
{
    return rw_is_angle(g->theta) && rw_is_magnitude(g->a) && rw_is_positive(g->A);
}

/* Whether a contact of the half-width b > 0 has all lengths in the domain, in natural units too. */
static inline bool rw_is_contact_size(const rw_geometry *g, double b)
{
    return rw_is_positive(b) && rw_is_magnitude(g->a / b);
}

/* The unit of stress. */
static inline double rw_unit_stress(const rw_geometry *g)
{
    return g->theta / g->A;
}

/* P A/theta, a length; M A/theta, one squared. */
static inline double rw_as_length(const rw_geometry *g, double P)
{
    return P * (g->A / g->theta);
}

/* Half-width under the load P >= 0, and the load of a half-width b >= 0. Argument and result may
 * be too small for the domain, as the patches inside a contact are. */
double rw_half_width(const rw_geometry *geometry, double P);
double rw_normal_load(const rw_geometry *geometry, double b);

/* The patch of a load P >= 0 and a moment M, or a tilt in theta, which are 0 where P is. NaN where
 * the tilt is 1. */
rw_patch rw_patch_under_moment(const rw_geometry *geometry, double P, double M);
rw_patch rw_patch_under_tilt(const rw_geometry *geometry, double P, double tilt);

#endif
