/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

#include <float.h>

static const double PI = 3.14159265358979323846;

CLAIM(shear_ratio_matches_reference)
{
    reference table = reference_open("stress_partial_slip.csv");
    while (reference_next(&table))
        assert_close(rwedge_shear_ratio(table.cell[0], table.cell[2]), table.cell[5], 1e-14);
    assert_int_equal(table.row, 600);
}

CLAIM(stick_width_inverts_the_shear_ratio)
{
    uint64_t seed = 7;
    for (int i = 0; i < 20000; i++) {
        const double alpha = pow(10, -8 * random_fraction(&seed)) * (i % 3 == 0 ? 20 : 1);
        const double c = i % 2 == 0 ? random_fraction(&seed) : pow(10, -8 * random_fraction(&seed));
        /* near c = 1 a rounding of Q/(fP) is all that c can be known to; dc = -d(Q/fP)/slope,
         * slope >= 1 there */
        assert_close(rwedge_stick_width(alpha, rwedge_shear_ratio(alpha, c)), c,
                     1e-14 + 2 * DBL_EPSILON / (c * c));
    }
}

/* Where c is lost beside 1 the ratio was sometimes 1 + 2 epsilon, outside the domain of its
 * inverse. */
CLAIM(round_trips_stay_in_the_domain)
{
    uint64_t seed = 13;
    for (int i = 0; i < 20000; i++) {
        const double alpha =
            i % 2 ? random_fraction(&seed) : 1 - pow(10, -12 * random_fraction(&seed));
        const double ratio = rwedge_shear_ratio(alpha, pow(10, -60 * random_fraction(&seed)));
        assert_true(ratio >= 0 && ratio <= 1);
        assert_true(rwedge_stick_width(alpha, ratio) >= 0);
    }
}

CLAIM(stick_zone_has_its_limits)
{
    for (double alpha = 0; alpha < 3; alpha += 0.3) {
        assert_within(rwedge_stick_width(alpha, 0), 1, 0);
        assert_within(rwedge_stick_width(alpha, 1), 0, 0);
        assert_within(rwedge_shear_ratio(alpha, 1), 0, 0);
        assert_close(rwedge_shear_ratio(alpha, 0), 1, DBL_EPSILON);
    }
    /* Mindlin: c/b = sqrt(1 - Q/(fP)) */
    assert_close(rwedge_stick_width(5, 0.36), 0.8, 1e-15);
    /* sharp: the load is linear in the width */
    assert_close(rwedge_stick_width(0, 0.36), 0.64, 1e-15);
    /* 1 - c^2; 1e-7: the rounding of 1 - 1e-9 */
    assert_close(rwedge_shear_ratio(2, 1 - 1e-9), 2e-9 - 1e-18, 1e-7);
    assert_close(rwedge_stick_width(1e-60, 0.36), 0.64, 1e-15);
}

/* Eq. (25) as printed, for c > a. */
CLAIM(shear_ratio_is_equation_25)
{
    const double alpha = 0.25, c = 0.5, omega0 = asin(alpha / c), phi0 = asin(alpha);
    const double corrective = alpha / pow(sin(omega0), 2) * (sin(2 * omega0) / 2 + omega0);
    const double whole = alpha / pow(sin(phi0), 2) * (sin(2 * phi0) / 2 + phi0);
    assert_close(rwedge_shear_ratio(alpha, c), 1 - corrective / whole, 1e-14);
    /* as a boundary-element program has it */
    assert_close(rwedge_shear_ratio(alpha, c), 0.5166107, 1e-7);
}

typedef struct {
    double alpha, c;
} partial_slip;

static double shear_in_phi(double phi, const void *context)
{
    const partial_slip *s = context;
    return rwedge_shear(s->alpha, s->c, sin(phi)) * cos(phi);
}

CLAIM(shear_integrates_to_Q)
{
    for (double alpha = 0; alpha < 1.3; alpha += 0.25)
        for (double c = 0.05; c < 1; c += 0.13) {
            const partial_slip s = {alpha, c};
            const double a = asin(fmin(alpha, 1)), stick = asin(c);
            const double points[] = {0, fmin(a, stick), fmax(a, stick), PI / 2};
            const double Q = -2 * integral(shear_in_phi, &s, 3, points);
            assert_close(Q, rwedge_shear_ratio(alpha, c) * rwedge_load(alpha), 1e-11);
        }
}

/* Eq. (20): slip zones carry f p, the stick zone less. */
CLAIM(shear_is_limited_by_friction)
{
    for (double x = 0.01; x < 1; x += 0.01) {
        const double p = rwedge_pressure(0.25, x), q = rwedge_shear(0.25, 0.5, x);
        if (x > 0.5)
            assert_close(q, p, 0);
        else
            assert_true(q <= 0 && q > p);
        assert_close(rwedge_shear(0.25, 0.5, -x), q, 0);
    }
    assert_close(rwedge_shear(0.25, 0.5, 0.5), rwedge_pressure(0.25, 0.5), 0);
}

/* Eq. (23): for c < a the corrective traction is Cattaneo's and Mindlin's. */
CLAIM(corrective_shear_is_elliptic_inside_the_rounding)
{
    const double alpha = 0.25, c = 1.0 / 6;
    for (double x = 0; x < c; x += 0.01)
        assert_close(rwedge_shear(alpha, c, x),
                     rwedge_pressure(alpha, x) + sqrt(c * c - x * x) / alpha, 1e-14);
}

CLAIM(sharp_wedge_sticks_at_its_apex)
{
    /* two logarithmic infinities, less each other */
    assert_close(rwedge_shear(0, 0.5, 0), -2 / PI * log(2), 1e-15);
    assert_close(rwedge_shear(0, 0.5, 1e-9), -2 / PI * log(2), 1e-15);
    assert_close(rwedge_shear(1e-12, 0.5, 1e-3), rwedge_shear(0, 0.5, 1e-3), 1e-12);
}

CLAIM(the_smallest_tips_slip_like_the_sharp_wedge)
{
    const double lost = 0x1p-52;
    assert_close(rwedge_shear_ratio(1e-60, 1 - lost), lost, 1e-15);
    assert_close(rwedge_shear_ratio(1e-60, 0.25), 0.75, 1e-15);
}

CLAIM(a_stick_zone_too_narrow_to_be_seen_changes_nothing)
{
    assert_close(rwedge_shear(0.5, 1e-59, 0), rwedge_pressure(0.5, 0), 0);
    assert_close(rwedge_shear(0.5, 1e-59, 5e-60), rwedge_pressure(0.5, 0), 1e-15);
}

CLAIM(shear_is_even)
{
    for (double x = 0.05; x < 1.2; x += 0.1)
        assert_close(rwedge_shear(0.3, 0.5, -x), rwedge_shear(0.3, 0.5, x), 0);
}
