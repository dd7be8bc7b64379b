/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transforms of a traction, held against t = sqrt(1 - x^2) and t = x sqrt(1 - x^2), whose
 * transforms are those of Hertz: Omega = -z + X and 1/2 - z^2 + z X, X = sqrt(z^2 - 1). */
#include "claims.h"
#include "base/complex.h"
#include "traction/transform.h"

#include <float.h>

static const double BREAKS[] = {-1, -0.2, 0.5, 1};

static double hertz(double x)
{
    return sqrt(fmax(0, (1 - x) * (1 + x)));
}

typedef double (*curve)(double x);

static void at_each(const double x[], const void *context, double value[])
{
    const curve *f = context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = (*f)(x[i]);
}

static rw_traction fit(curve f, size_t breaks, const double at[], double tolerance)
{
    rw_traction t = {0};
    assert_true(rw_traction_fit(&t, at_each, &f, breaks, at, tolerance, 0));
    return t;
}

static rw_traction fitted(void)
{
    return fit(hertz, 4, BREAKS, 1e-12);
}

CLAIM(the_traction_is_what_was_fitted)
{
    rw_traction t = fitted();
    for (int i = -50; i <= 50; i++)
        assert_within(rw_traction_at(&t, i / 50.0), hertz(i / 50.0), 1e-12);
    assert_int_equal(rw_traction_at(&t, 1.001) == 0 && rw_traction_at(&t, -1.001) == 0, 1);
    assert_close(rw_traction_total(&t), 1.57079632679489661923, 1e-14);
    rw_traction_destroy(&t);
}

static void values_of(const double x[], const void *context, double value[])
{
    rw_traction_values(context, RW_TERMS, x, value);
}

/* Fits of fits, as the steps of a load make them while a front moves by `step` in each. What the
 * first one lost where its elements meet was carried on beyond that place by each of them: it grew
 * to 0.8. */
static void fit_again_and_again(double step)
{
    enum { FITS = 400 };
    const double tolerance = 1e-9;
    rw_traction t = fit(hertz, 2, (const double[]){-1, 1}, tolerance);
    for (int i = 1; i <= FITS; i++) {
        rw_traction next = {0};
        const double at[] = {-1, 1 - step * i};
        assert_true(rw_traction_fit(&next, values_of, &t, 2, at, tolerance, 30));
        rw_traction_destroy(&t);
        t = next;
    }
    for (int i = 0; i < 500; i++) {
        const double x = -1 + (2 - step * FITS) * i / 500;
        assert_within(rw_traction_at(&t, x), hertz(x), tolerance);
    }
    rw_traction_destroy(&t);
}

CLAIM(fits_of_fits_do_not_drift_apart_where_elements_meet)
{
    fit_again_and_again(1e-3);
    fit_again_and_again(1e-4);
}

CLAIM(the_slope_of_hertz_is_a_line_inside_and_falls_off_outside)
{
    rw_traction t = fitted();
    for (int i = -300; i <= 300; i++) {
        const double x = i / 100.0;
        const double X = fabs(x) > 1 ? copysign(sqrt(x * x - 1), x) : 0;
        assert_within(rw_traction_slope(&t, x), -x + X, 1e-9);
    }
    assert_close(rw_traction_slope(&t, 1e6), -0.5e-6, 1e-10);
    rw_traction_destroy(&t);
}

/* -(1/pi) int sqrt(1 - s^2) ln|s - x| ds = -(x^2 - 1/2 - ln 2)/2 inside. */
CLAIM(the_displacement_of_hertz_is_a_parabola)
{
    rw_traction t = fitted();
    for (int i = -40; i <= 40; i++) {
        const double x = i / 40.0;
        assert_within(rw_traction_displacement(&t, x), -(x * x - 0.5 - RW_LN2) / 2, 2e-8);
    }
    rw_traction_destroy(&t);
}

static rw_complex root(double x, double y)
{
    const rw_complex right = rw_complex_root((rw_complex){x - 1, y}),
                     left = rw_complex_root((rw_complex){x + 1, y});
    return rw_product(right, left);
}

CLAIM(the_field_of_hertz_is_its_potential)
{
    rw_traction t = fitted();
    const double x[] = {0.3, -1.01, 0.5, 2, 0.4, 0, -0.2, 7},
                 y[] = {0.2, 1e-3, 1e-6, 3, 1e-12, 50, 0.1, 1};
    rw_fields fields;
    rw_traction_fields(&t, 8, x, y, &fields);
    for (int i = 0; i < 8; i++) {
        const rw_complex X = root(x[i], y[i]);
        const rw_complex z_over_X = rw_quotient((rw_complex){x[i], y[i]}, X);
        const rw_field field = rw_field_in(&fields, i);
        assert_within(field.G_re, X.re - x[i], 1e-12);
        assert_within(field.G_im, X.im - y[i], 1e-12);
        assert_within(field.H_re, y[i] * (z_over_X.re - 1), 1e-10);
        assert_within(field.H_im, y[i] * z_over_X.im, 1e-10);
    }
    rw_traction_destroy(&t);
}

/* The edges of slip zones may lie so close together: a point was not moved off such an edge. */
CLAIM(the_slope_at_the_ends_of_a_narrow_element_is_finite)
{
    for (double width = 1e-6; width > 1e-10; width /= 10) {
        const double breaks[] = {-1, 0.38, 0.38 + width, 1};
        rw_traction t = fit(hertz, 4, breaks, 1e-12);
        for (size_t i = 0; i < t.count; i++)
            assert_within(rw_traction_slope(&t, t.elements[i].low), -t.elements[i].low, 1e-5);
        rw_traction_destroy(&t);
    }
}

CLAIM(a_part_of_a_traction_has_its_values_and_ends_where_it_was_cut)
{
    rw_traction t = fitted(), part = {0};
    assert_true(rw_traction_append_part(&part, &t, -0.43, 0.77));
    assert_true(part.elements[0].low == -0.43 && part.elements[part.count - 1].high == 0.77);
    for (int i = 0; i <= 24; i++) {
        const double x = -0.43 + 1.2 * i / 24;
        assert_within(rw_traction_at(&part, x), rw_traction_at(&t, x), 1e-14);
    }
    assert_true(rw_traction_at(&part, -0.44) == 0 && rw_traction_at(&part, 0.78) == 0);
    rw_traction_destroy(&part);
    rw_traction_destroy(&t);
}

static double cubic(double x)
{
    return 1 + x * (2 + x * (3 + x));
}

static double bent(double x)
{
    return cubic(x) + fmax(0, x - 0.5);
}

CLAIM(elements_are_joined_where_one_fits_them)
{
    enum { PLACES = 9 };
    double breaks[PLACES];
    for (int i = 0; i < PLACES; i++)
        breaks[i] = i / 8.0 - 0.25;
    const curve functions[] = {cubic, bent};
    for (int i = 0; i < 2; i++) {
        rw_traction t = fit(functions[i], PLACES, breaks, 1e-9);
        assert_int_equal(t.count, 2 * (PLACES - 1));
        rw_traction_simplify(&t, 1e-9);
        assert_int_equal(t.count, 1 + i); /* the bend stays */
        for (int k = 0; k <= 20; k++) {
            const double x = -0.249 + 0.998 * k / 20;
            assert_within(rw_traction_at(&t, x), functions[i](x), 1e-12);
        }
        rw_traction_destroy(&t);
    }
}

static double bent_at_the_end(double x)
{
    return cubic(x) + fmax(0, x - 0.9999);
}

/* The slip of a contact that grew by small steps was wrong by hundredths: no place of the joint
 * element lay in the short one. */
CLAIM(a_short_element_is_not_lost_in_a_long_one)
{
    const double breaks[] = {-1, 0.9999, 1};
    rw_traction t = fit(bent_at_the_end, 3, breaks, 1e-9);
    rw_traction_simplify(&t, 1e-9);
    assert_within(rw_traction_at(&t, 1), bent_at_the_end(1), 1e-9);
    rw_traction_destroy(&t);
}

/* Over twenty doubles, from 0 to 1. */
static double steep(double x)
{
    return (x - 0.5) / (10 * DBL_EPSILON);
}

/* The slip of places new in contact became thousands of elements, narrower than a double tells
 * apart, and a load took 7 s. */
CLAIM(elements_are_not_narrower_than_rounding)
{
    const double breaks[] = {0.5, 0.5 + 10 * DBL_EPSILON};
    rw_traction t = fit(steep, 2, breaks, 1e-6);
    assert_int_equal(t.count, 2);
    assert_within(rw_traction_at(&t, 0.5 + 5 * DBL_EPSILON), 0.5, 0.1);
    rw_traction_destroy(&t);
}

/* A place may be the end of an element to rounding. */
static double one(double x)
{
    return 1 + 0 * x;
}

/* Two elements meet in the middle, each of which has its own rounding of that place. */
CLAIM(no_place_is_lost_between_elements)
{
    for (int i = 0; i < 1000; i++) {
        const double at[] = {-1 - 0.0071 * i, 1.3 + 0.0037 * i}, middle = at[0] / 2 + at[1] / 2;
        rw_traction t = fit(one, 2, at, 1e-12);
        double x = middle - 4 * DBL_EPSILON;
        while (x < middle + 4 * DBL_EPSILON) {
            assert_within(rw_traction_at(&t, x), 1, 1e-12);
            x = nextafter(x, 2);
        }
        rw_traction_destroy(&t);
    }
}

CLAIM(the_root_of_zero_is_zero)
{
    const rw_complex root = rw_complex_root((rw_complex){0, 0});
    assert_true(root.re == 0 && root.im == 0);
}
