/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the domains of single arguments do not say, of the functions of which it is known
 * exactly. */
#include "parts.h"

#include <math.h>
#include <string.h>

static bool is_positive(double v)
{
    return isfinite(v) && v >= 1e-60 && v <= 1e60;
}

/* What the header's first page says of whatever has a size. */
static bool is_magnitude(double v)
{
    return v == 0 || is_positive(v);
}

/* Here and below: in long double, which neither overflows nor raises anything on the way. */
static long double share(double E, double nu)
{
    return isinf(E) ? 0 : 2 * (1 - (long double)nu) * (1 + (long double)nu) / E;
}

static bool has_compliance(const double v[])
{
    const long double A = share(v[0], v[1]) + share(v[2], v[3]);
    return A >= 1e-60 && A <= 1e60;
}

static bool has_radius(const double v[])
{
    return is_magnitude(v[1] / v[0]);
}

static bool has_rounding(const double v[])
{
    return is_magnitude(v[1] * v[0]);
}

static bool has_a_over_b(const double v[])
{
    return v[0] < 1 ? v[0] >= 1.5708e-120 : v[0] <= 2e60;
}

/* Whether a contact of that size is in the domain. */
static bool is_size(double a, double b)
{
    return is_positive(b) && is_magnitude(a / b);
}

/* v: theta, a, A, P. */
static bool has_half_width(const double v[])
{
    const double a = v[1], length = v[2] * v[3] / v[0];
    if (length == 0)
        return true;
    if (length < 1.57 * a)
        return is_size(a, sqrt(length / 1.57079632679489662 * a));
    return is_size(a, length < 1e30 * a ? a / rwedge_a_over_b(length / a) : length / 2);
}

/* v: theta, a, A, b. */
static bool has_load(const double v[])
{
    const double a = v[1], b = v[3], width = v[0] / v[2] * b;
    if (b == 0)
        return true;
    return is_size(a, b) && is_magnitude(width * rwedge_load(a / b));
}

static bool is_not_sharp(const double v[])
{
    return v[0] > 0;
}

static bool is_not_apex_of_surface(const double v[])
{
    return v[0] > 0 || v[1] != 0;
}

static bool is_not_apex_of_shear(const double v[])
{
    return v[0] > 0 || v[1] > 0 || v[2] != 0;
}

static bool is_not_apex(const double v[])
{
    return v[0] > 0 || v[3] != 0 || v[4] != 0;
}

/* v: alpha, f, c, the x of the points, and their y. */
static bool are_not_the_apex(const double v[])
{
    bool are = true;
    for (int i = 0; i < array_size; i++)
        are = are && (v[0] > 0 || v[3 + i] != 0 || v[3 + array_size + i] != 0);
    return are;
}

/* v: theta, a, A, f. theta/A is the unit of its stresses. */
static bool has_unit_of_stress(const double v[])
{
    return is_positive(v[0] / v[2]);
}

static const struct {
    const char *name;
    together_claim *is_inside;
} together[] = {
    {"compliance", has_compliance},  {"dundurs_beta", has_compliance},
    {"a_over_b", has_a_over_b},      {"pressure", is_not_apex_of_surface},
    {"peak_pressure", is_not_sharp}, {"transition_pressure", is_not_sharp},
    {"shear", is_not_apex_of_shear}, {"stress", is_not_apex},
    {"stresses", are_not_the_apex},  {"radius", has_radius},
    {"rounding", has_rounding},      {"half_width", has_half_width},
    {"normal_load", has_load},       {"contact_create", has_unit_of_stress},
};

together_claim *claim_about(const char *name)
{
    for (size_t i = 0; i < sizeof together / sizeof together[0]; i++)
        if (strcmp(together[i].name, name) == 0)
            return together[i].is_inside;
    return NULL;
}
