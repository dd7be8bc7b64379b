/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The size of a contact with units: its rounding, its half-width and the load that makes it. */
#include "formulas/size.h"

#include "rwedge.h"

/* NaN where a result leaves the domain. */
static double magnitude(double v)
{
    return rw_is_magnitude(v) ? v : NAN;
}

double rwedge_radius(double theta, double a)
{
    return rw_is_angle(theta) && rw_is_magnitude(a) ? magnitude(a / theta) : NAN;
}

double rwedge_rounding(double theta, double R)
{
    return rw_is_angle(theta) && rw_is_magnitude(R) ? magnitude(theta * R) : NAN;
}

/* Eq. (11) for the sharp wedge; with a rounding, from the ratio A P/(theta a). */
double rw_half_width(const rw_geometry *geometry, double P)
{
    static const double SHARP = 0x1p106; /* of the ratio: sharp to the last bit */
    const double length = geometry->A * P / geometry->theta;
    if (geometry->pad)
        return rw_pad_half_width(geometry->pad, length);
    if (geometry->a == 0)
        return length / 2;
    const double ratio = length / geometry->a;
    if (ratio >= SHARP)
        return length / 2;
    if (ratio <= RW_HALF_PI)
        return sqrt(length / RW_HALF_PI) * sqrt(geometry->a);
    return geometry->a / rwedge_a_over_b(ratio);
}

double rwedge_half_width(double theta, double a, double A, double P)
{
    const rw_geometry geometry = {.theta = theta, .a = a, .A = A};
    if (!rw_is_geometry(&geometry) || !rw_is_magnitude(P))
        return NAN;
    const double b = rw_half_width(&geometry, P);
    return P == 0 || rw_is_contact_size(&geometry, b) ? b : NAN;
}

/* A P/(theta b) */
static double load_per_width(double a, double b)
{
    return a < b ? rwedge_load(a / b) : RW_HALF_PI * b / a;
}

double rw_normal_load(const rw_geometry *geometry, double b)
{
    if (b == 0)
        return 0;
    return rw_unit_stress(geometry) * (geometry->pad
                                           ? rw_pressing_of(geometry, (rw_patch){-b, b}).load
                                           : b * load_per_width(geometry->a, b));
}

double rwedge_normal_load(double theta, double a, double A, double b)
{
    const rw_geometry geometry = {.theta = theta, .a = a, .A = A};
    if (!rw_is_geometry(&geometry) || !rw_is_magnitude(b))
        return NAN;
    return b == 0 || rw_is_contact_size(&geometry, b) ? magnitude(rw_normal_load(&geometry, b))
                                                      : NAN;
}

static rw_patch centred(const rw_geometry *g, double P)
{
    const double b = rw_half_width(g, P);
    return (rw_patch){-b, b};
}

rw_patch rw_patch_under_moment(const rw_geometry *g, double P, double M)
{
    const rw_arcs arcs = rw_arcs_of(g);
    return M == 0 && (P == 0 || rw_is_symmetric(g))
               ? centred(g, P)
               : rw_arcs_patch_of_moment(&arcs, rw_as_length(g, P), rw_as_length(g, M));
}

rw_patch rw_patch_under_tilt(const rw_geometry *g, double P, double tilt)
{
    const rw_arcs arcs = rw_arcs_of(g);
    if (tilt == 0 && rw_is_symmetric(g))
        return centred(g, P);
    return fabs(tilt) < 1 ? rw_arcs_patch_of_tilt(&arcs, rw_as_length(g, P), tilt)
                          : (rw_patch){NAN, NAN};
}
