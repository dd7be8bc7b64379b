/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bounded inverse, held against t = sqrt(1 - x^2) and x sqrt(1 - x^2), for which it is a
 * logarithm; against the layer of a change of pressure, whose transform is that change; and against
 * full sliding, whose exact pressure is that of the pad and B times the inverse of f times itself.
 */
#include "histories.h"
#include "traction/bounded_inverse.h"
#include "traction/transform.h"
#include "potential/pad_potential.h"
#include "unlike/sliding_patch.h"

typedef double (*curve)(double x);

static void at_each(const double x[], const void *context, double value[])
{
    const curve *f = context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = (*f)(x[i]);
}

static double hertz(double x)
{
    return sqrt(fmax(0, (1 - x) * (1 + x)));
}

static double tilted(double x)
{
    return x * hertz(x);
}

/* PV int ds/(s - x) from -1 to 1 */
static double logarithm(double x)
{
    return log((1 - x) / (1 + x));
}

static rw_bounded_inverse inverse_of(rw_values t, const void *context, size_t breaks,
                                     const double at[], double tolerance)
{
    rw_bounded_inverse inverse;
    const rw_patch patch = {at[0], at[breaks - 1]};
    assert_true(rw_bounded_inverse_create(&inverse, patch, t, context, breaks, at, tolerance));
    return inverse;
}

CLAIM(of_a_root_it_is_a_logarithm)
{
    const double at[] = {-1, 0.3, 1};
    rw_bounded_inverse even = inverse_of(at_each, &(curve){hertz}, 3, at, 1e-10),
                       odd = inverse_of(at_each, &(curve){tilted}, 3, at, 1e-10);
    assert_close(even.moment[0], 2, 1e-9);
    assert_within(even.moment[1], 0, 1e-9);
    assert_close(even.moment[2], 2.0 / 3, 1e-9);
    assert_within(odd.moment[0], 0, 1e-9);
    assert_close(odd.moment[1], 2.0 / 3, 1e-9);
    for (double x = -0.99; x < 1; x += 0.11) {
        const rw_patch patch = even.patch;
        assert_within(rw_bounded_inverse_at(&even, patch, x), hertz(x) * logarithm(x) / PI, 1e-8);
        assert_within(rw_bounded_inverse_at(&odd, patch, x), hertz(x) * (2 + x * logarithm(x)) / PI,
                      1e-8);
        /* of a traction that is as wide as another patch */
        assert_within(rw_bounded_inverse_at(&even, (rw_patch){2, 8}, 5 + 3 * x),
                      hertz(x) * logarithm(x) / PI, 1e-8);
    }
    assert_int_equal(rw_bounded_inverse_at(&even, even.patch, 1.1) == 0, 1);
    rw_bounded_inverse_destroy(&even);
    rw_bounded_inverse_destroy(&odd);
}

/* A patch that has moved to the left. */
static double wider(double x)
{
    return sqrt(fmax(0, (x + 1.1) * (0.9 - x))) - sqrt(fmax(0, (x + 1) * (1 - x)));
}

static void layer_at(const double x[], const void *context, double value[])
{
    const rw_bounded_inverse *inverse = context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = rw_bounded_inverse_at(inverse, inverse->patch, x[i]);
}

/* H[L[t]] = -t + (1/pi) int t/|X|, and the integral of L[t] is that of (s - m) t/|X|. */
CLAIM(the_transform_of_a_layer_is_the_change_of_pressure)
{
    const double at[] = {-1.1, -1, 0.9, 1};
    rw_bounded_inverse inverse = inverse_of(at_each, &(curve){wider}, 4, at, 1e-10);
    rw_traction layer = {0};
    assert_true(rw_traction_fit(&layer, layer_at, &inverse, 4, at, 1e-9, 30));
    for (double x = -1.04; x < 1; x += 0.13)
        assert_within(rw_traction_slope(&layer, x), -wider(x) + inverse.moment[0] / PI, 1e-6);
    const double half = rw_patch_half_width(inverse.patch);
    assert_within(rw_traction_total(&layer), half * inverse.moment[1], 1e-7);
    rw_traction_destroy(&layer);
    rw_bounded_inverse_destroy(&inverse);
}

/* ---- Full sliding ---- */

typedef struct {
    rw_arcs arcs;
    rw_sliding_way slides;
    rw_patch patch;
    double f;
} sliding;

static void friction_at(const double x[], const void *context, double value[])
{
    const sliding *s = context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = -s->f * rw_sliding_pressure(&s->arcs, s->slides, s->patch, x[i]);
}

CLAIM(in_full_sliding_it_gives_the_exact_pressure_load_and_tilt)
{
    static const double FRICTION = 0.5;
    for (double B = -0.2; B < 0.3; B += 0.1) {
        rw_unlike unlike;
        rw_unlike_init(&unlike, B * FRICTION);
        const sliding s = {{1, rw_rounding(1), NULL}, {&unlike, 1}, {-3.2, 2.7}, FRICTION};
        const double at[] = {s.patch.left, -1, 1, s.patch.right};
        const double half = rw_patch_half_width(s.patch), middle = rw_patch_middle(s.patch);
        const rw_pressing exact = rw_sliding_pressing(&s.arcs, s.slides, s.patch),
                          own = rw_arcs_pressing(&s.arcs, s.patch);
        rw_bounded_inverse inverse = inverse_of(friction_at, &s, 4, at, 1e-9);
        const double *I = inverse.moment;
        assert_close(own.load + B * half * I[1], exact.load, 1e-7);
        assert_within(own.tilt + B / PI * I[0], exact.tilt, 1e-7);
        const double more = middle * half * I[1] + half * half * (I[2] - I[0] / 2);
        assert_within(own.moment + B * more, exact.moment, 1e-6);
        for (double u = -0.95; u < 1; u += 0.1) {
            const double x = middle + half * u;
            double pressure;
            rw_pad_pressures(&s.arcs, s.patch, 1, &x, &pressure);
            assert_within(pressure + B * rw_bounded_inverse_at(&inverse, s.patch, x),
                          -rw_sliding_pressure(&s.arcs, s.slides, s.patch, x), 1e-6);
        }
        rw_bounded_inverse_destroy(&inverse);
    }
}
