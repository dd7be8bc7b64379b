/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The geometry of a contact with units, and its size under a load. */
#ifndef RW_SIZE_H
#define RW_SIZE_H

#include "base/domain.h"
#include "formulas/arcs.h"

typedef struct {
    double theta, a, A; /* a of a pad: where it is curved most, the slope changes by theta over a */
    rw_pad *pad;        /* NULL for the wedge */
    double reach;       /* as far as the profile is known, from the centre; 0 where all of it is */
    double middle_slope; /* of the pad as it was given: between its outermost slopes */
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

static inline rw_arcs rw_arcs_of(const rw_geometry *g)
{
    return (rw_arcs){g->pad ? g->pad->count : 1, rw_rounding(g->a), g->pad};
}

/* Whether a patch without moment is in the middle. */
static inline bool rw_is_symmetric(const rw_geometry *g)
{
    return !g->pad || g->pad->is_symmetric;
}

/* Whether the pressure is infinite there. */
static inline bool rw_is_kink(const rw_geometry *g, double x)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return rw_arcs_have_kink(&arcs, x);
}

/* What a patch carries, and how fast its edges move. */
static inline rw_pressing rw_pressing_of(const rw_geometry *g, rw_patch patch)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return rw_arcs_pressing(&arcs, patch);
}

static inline rw_edge_rates rw_edge_rates_of(const rw_geometry *g, rw_patch patch)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return rw_arcs_edge_rates(&arcs, patch);
}

/* The height of a symmetric profile above its middle, over theta. */
static inline double rw_height(const rw_geometry *g, double x)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return rw_arcs_height(&arcs, x);
}

/* The height of any profile, over theta, up to a constant. */
static inline double rw_profile_height(const rw_geometry *g, double x)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return rw_arcs_shape(&arcs, x);
}

#endif
