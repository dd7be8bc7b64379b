/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts of other pads than the wedge. A cylinder is a wedge of which only the rounding touches;
 * any other pad is a list of arcs. */
#include "pads/pads.h"

#include "base/domain.h"

enum { MOST_PLACES = 1000 };

/* The contact takes the pad over, which is destroyed where that fails. */
static int32_t create(rw_geometry geometry, double f, rwedge_contact **contact)
{
    const int32_t status = geometry.pad ? rw_contact_create(&geometry, f, contact) : RWEDGE_ENOMEM;
    if (status != RWEDGE_OK)
        rw_pad_destroy(geometry.pad);
    return status;
}

/* ---- A cylinder, and a flat with rounded edges ---- */

int32_t rwedge_contact_create_flat(double a, double R, double A, double f, rwedge_contact **contact)
{
    rw_geometry geometry = {.theta = 1, .a = R, .A = A, .reach = a + R};
    if (!rw_is_magnitude(a) || !rw_is_positive(R) || !rw_is_positive(A) || !rw_is_friction(f) ||
        !rw_is_positive(geometry.reach))
        return RWEDGE_EDOMAIN;
    if (!contact)
        return RWEDGE_ENULL;
    if (a == 0)
        return rw_contact_create(&geometry, f, contact);
    geometry.pad = rw_pad_create(2);
    if (geometry.pad) {
        rw_pad_append(geometry.pad, (rw_arc){-geometry.reach, -a}, 0.5);
        rw_pad_append(geometry.pad, (rw_arc){a, geometry.reach}, 0.5);
    }
    return create(geometry, f, contact);
}

/* ---- Any convex profile ---- */

static bool is_profile(size_t n, const double x[], const double slope[])
{
    if (n < 2 || n > MOST_PLACES)
        return false;
    for (size_t i = 0; i < n; i++) {
        if (!rw_is_signed(x[i]) || !rw_is_signed(slope[i]) || !(fabs(slope[i]) < RW_HALF_PI))
            return false;
        if (i > 0 && !(x[i] >= x[i - 1] && slope[i] >= slope[i - 1]))
            return false;
    }
    return rw_is_positive(slope[n - 1] - slope[0]);
}

static rw_pad *pad_of(size_t n, const double x[], const double slope[], rw_geometry *g)
{
    rw_pad *pad = rw_pad_create(n - 1);
    g->a = HUGE_VAL;
    for (size_t i = 1; pad && i < n; i++) {
        const rw_arc arc = {x[i - 1], x[i]};
        const double weight = (slope[i] - slope[i - 1]) / (slope[n - 1] - slope[0]);
        if (weight == 0)
            continue;
        rw_pad_append(pad, arc, weight);
        g->a = fmin(g->a, rw_arc_half_length(arc) / weight);
    }
    return pad;
}

int32_t rw_profile_geometry(size_t n, const double x[], const double slope[], double A,
                            rw_geometry *geometry)
{
    if (!is_profile(n, x, slope) || !rw_is_positive(A))
        return RWEDGE_EDOMAIN;
    *geometry = (rw_geometry){.theta = (slope[n - 1] - slope[0]) / 2, .A = A};
    if (!rw_is_positive(geometry->theta) || !rw_is_positive(rw_unit_stress(geometry)))
        return RWEDGE_EDOMAIN;
    geometry->middle_slope = slope[0] / 2 + slope[n - 1] / 2;
    geometry->pad = pad_of(n, x, slope, geometry);
    return geometry->pad ? RWEDGE_OK : RWEDGE_ENOMEM;
}

int32_t rwedge_contact_create_profile(size_t n, const double x[], const double slope[], double A,
                                      double f, rwedge_contact **contact)
{
    rw_geometry geometry;
    if (!x || !slope || !contact)
        return RWEDGE_ENULL;
    if (!rw_is_friction(f))
        return RWEDGE_EDOMAIN;
    const int32_t status = rw_profile_geometry(n, x, slope, A, &geometry);
    return status == RWEDGE_OK ? create(geometry, f, contact) : status;
}
