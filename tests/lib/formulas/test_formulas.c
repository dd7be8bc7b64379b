/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paper's formulas and the patches off the centre against their integrals. How accurate they
 * are, proof/accuracy shows. */
#include "claims.h"
#include "formulas/pad.h"
#include "quadrature.h"
#include "rwedge.h"

typedef struct {
    double alpha, at;
} inversion;

/* Eq. (3) with t = sin(tau); the factor makes the kernel 1/(tau - at). */
static double profile_in_tau(double tau, const void *context)
{
    const inversion *c = context;
    const double slope = -fmax(-1, fmin(1, sin(tau) / c->alpha));
    const double half_difference = (tau - c->at) / 2;
    const double ratio =
        fabs(half_difference) < 1e-150 ? 1 : half_difference / sin(half_difference);
    return slope * ratio / cos((tau + c->at) / 2);
}

CLAIM(pressure_is_the_inverted_integral)
{
    for (double alpha = 0.1; alpha < 1; alpha += 0.2)
        for (double x = 0.03; x < 1; x += 0.11) {
            const inversion c = {alpha, asin(x)};
            const double value = principal_value(profile_in_tau, &c, -PI / 2, PI / 2, c.at);
            /* limited by the kinks at +-alpha */
            assert_close(rwedge_pressure(alpha, x), sqrt(1 - x * x) / PI * value, 1e-8);
        }
}

CLAIM(pressure_vanishes_outside)
{
    assert_within(rwedge_pressure(0.3, 1), 0, 0);
    assert_within(rwedge_pressure(0, -1.5), 0, 0);
    assert_within(rwedge_pressure(7, 1e60), 0, 0);
    assert_true(rwedge_pressure(0.3, nextafter(1, 0)) < 0);
    assert_within(rwedge_transition_pressure(1), 0, 0);
    assert_close(rwedge_shear(0, 0, 0.5), -2 / PI * acosh(2), 1e-15); /* nothing sticks */
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

/* ---- Patches off the centre: what they carry ---- */

typedef struct {
    double a;
    rw_patch patch;
} pressed;

/* Along x = m + s sin(v): the load is the mean of 2 s cos(phi) over the rounding, as all that the
 * slope's rise 1/a at x weighs is the load of a sharp wedge there; likewise tilt and moment. */
static double load_of_rise(double x, const void *context)
{
    const pressed *p = context;
    const double inside = (x - p->patch.left) * (p->patch.right - x);
    return inside > 0 ? 2 * sqrt(inside) / (2 * p->a) : 0;
}

static double moment_of_rise(double x, const void *context)
{
    const pressed *p = context;
    return (rw_patch_middle(p->patch) + x) / 2 * load_of_rise(x, context);
}

static double tilt_of_rise(double x, const void *context)
{
    const pressed *p = context;
    const double t = (x - rw_patch_middle(p->patch)) / rw_patch_half_width(p->patch);
    return -2 / PI * asin(fmax(-1, fmin(1, t))) / (2 * p->a);
}

CLAIM(laws_are_means_over_the_rounding)
{
    uint64_t seed = 3;
    for (int i = 0; i < 40; i++) {
        const double a = 0.2 + random_fraction(&seed), middle = 2 * random_fraction(&seed) - 1;
        const double half = fabs(middle) - a + 0.05 + 2 * random_fraction(&seed);
        if (half <= 0.05)
            continue;
        const pressed p = {a, {middle - half, middle + half}};
        const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(a)};
        const rw_pressing is = rw_arcs_pressing(&wedge, p.patch);
        const double ends[] = {fmax(-a, p.patch.left), fmin(a, p.patch.right)};
        assert_close(is.load, integral(load_of_rise, &p, 1, ends), 1e-12);
        assert_within(is.moment, integral(moment_of_rise, &p, 1, ends), 1e-12 * is.load);
        const double beyond = (ends[0] + a) - (a - ends[1]); /* what is held at +-pi/2 */
        assert_within(is.tilt, integral(tilt_of_rise, &p, 1, ends) + beyond / (2 * a), 1e-12);
    }
}

/* A tilt of 1 is a flank on the surface: it has no edges. */
CLAIM(a_flank_on_the_surface_has_no_patch)
{
    const rw_arcs wedge = {.count = 1, .rounding = rw_rounding(1)};
    assert_nan(rw_arcs_patch_of_moment(&wedge, 1e-3, 1e40).left);
}
