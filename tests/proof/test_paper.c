/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the paper says of its results, and the errors in its print: E1 ... E9 of lib/README.md. For
 * each the corrected form is shown to be right. If the printed form says something definite, it is
 * shown to be wrong. */
#include "claims.h"
#include "quadrature.h"
#include "rwedge.h"

#include <complex.h>
#include <float.h>

static void yield_at(double alpha, double f, double *limit, double *x, double *y)
{
    assert_ok(rwedge_yield_point(alpha, f, 0.3, limit, x, y));
}

static double J2_at(double alpha, double f, double c, double x, double y)
{
    double sxx, syy, txy;
    assert_ok(rwedge_stress(alpha, f, c, x, y, &sxx, &syy, &txy));
    const double difference = (sxx - syy) / 2, mean = (sxx + syy) / 2;
    return difference * difference + txy * txy + 0.16 / 3 * mean * mean;
}

/* Sec. 5.1: "P/(bk) is about 3 ... about 60 % of the Hertzian case" at a/b = 0.1; depth 0.7 b
 * for Hertz. */
CLAIM(a_tenth_of_rounding_keeps_sixty_percent_of_the_strength)
{
    double tenth, hertz, x, y;
    yield_at(0.1, 0, &tenth, &x, &y);
    assert_within(tenth, 3, 0.02);
    assert_close(y, 0.1732, 1e-3);
    yield_at(1, 0, &hertz, &x, &y);
    assert_close(hertz, 4.880036, 1e-6);
    assert_within(y, 0.7, 0.01);
    assert_within(x, 0, 0);
    assert_within(tenth / hertz, 0.6, 0.015);
}

/* Sec. 5.1: the strength is always lower than Hertz', and falls with the tip. */
CLAIM(strength_falls_with_the_tip)
{
    for (double alpha = 0.1; alpha < 0.95; alpha += 0.1)
        assert_true(rwedge_elastic_limit(alpha, 0, 0.3) <
                    rwedge_elastic_limit(alpha + 0.1, 0, 0.3));
}

/* Sec. 5.2: subsurface for "small coefficients of friction, less than about 0.3"; the cusp is at
 * smaller f for smaller tips. */
CLAIM(cusps_of_figure_4)
{
    const double cusp[][2] = {{1, 0.262826}, {0.5, 0.2367}, {0.1, 0.1548}};
    for (int i = 0; i < 3; i++) {
        const double f = rwedge_critical_friction(cusp[i][0], 0.3), h = 1e-4;
        assert_within(f, cusp[i][1], 6e-5);
        const double before = rwedge_elastic_limit(cusp[i][0], f - h, 0.3),
                     at = rwedge_elastic_limit(cusp[i][0], f, 0.3),
                     after = rwedge_elastic_limit(cusp[i][0], f + h, 0.3);
        assert_true((at - after) > 2 * (before - at)); /* a kink: it falls abruptly from there */
    }
}

/* Sec. 5.2: with friction the difference between Hertz and the rounded wedge decreases. */
CLAIM(friction_evens_out_the_tips)
{
    for (double alpha = 0.1; alpha < 0.95; alpha += 0.2) {
        const double without =
            rwedge_elastic_limit(1, 0, 0.3) - rwedge_elastic_limit(alpha, 0, 0.3);
        const double with =
            rwedge_elastic_limit(1, 0.8, 0.3) - rwedge_elastic_limit(alpha, 0.8, 0.3);
        assert_true(with < without && with > 0);
    }
}

/* Eq. (38): 1 and 4/pi; "the variation is only 21 %". */
CLAIM(tension_between_sharp_and_hertz)
{
    assert_close(rwedge_max_tension(0), 1, 0);
    assert_close(rwedge_max_tension(1), 4 / PI, DBL_EPSILON);
    assert_within(1 - rwedge_max_tension(0) / rwedge_max_tension(1), 0.21, 0.005);
    for (double alpha = 0; alpha < 1; alpha += 0.05)
        assert_true(rwedge_max_tension(alpha) < rwedge_max_tension(alpha + 0.05));
}

/* Sec. 5.3: full sliding is "likely" the worst: J2 at its yield point and around is lower in
 * partial slip. */
CLAIM(sliding_is_weaker_than_partial_slip)
{
    for (double alpha = 0.2; alpha < 1.1; alpha += 0.4)
        for (double f = 0.1; f < 0.8; f += 0.3) {
            const double largest = pow(rwedge_load(alpha) / rwedge_elastic_limit(alpha, f, 0.3), 2);
            for (double c = 0.1; c < 1; c += 0.3)
                for (double x = -1.2; x <= 1.2; x += 0.02)
                    for (double y = 0; y < 1; y += 0.02)
                        assert_true(J2_at(alpha, f, c, x, y) <= largest * (1 + 1e-13));
        }
}

CLAIM(E1_the_signs_of_the_sharp_series_alternate)
{
    rwedge_series *series;
    assert_ok(rwedge_series_create(0, 4001, &series));
    double printed = 0;
    const double x = 0.6, t = acos(x);
    for (int n = 0; n <= 2000; n++)
        printed -= 4 / (PI * (2 * n + 1)) * sin((2 * n + 1) * t);
    const double closed = -2 / PI * acosh(1 / x); /* Eq. (14) */
    assert_close(rwedge_series_pressure(series, x), closed, 1e-3);
    assert_true(fabs(printed - closed) > 0.1); /* the printed sum is the constant -1 */
    assert_close(printed, -1, 1e-3);
    rwedge_series_destroy(series);
}

CLAIM(E2_powers_of_i_on_the_axis)
{
    const double y = 0.7;
    const double complex R = I * (y - sqrt(y * y + 1));
    for (int n = 1; n < 8; n++) {
        const double complex corrected = cpow(I, n) * pow(y - sqrt(y * y + 1), n);
        const double complex printed = I * pow(y - sqrt(y * y + 1), n);
        assert_within(cabs(cpow(R, n) - corrected), 0, 1e-15);
        if (n % 4 != 1)
            assert_true(cabs(cpow(R, n) - printed) > 1e-3);
    }
    /* and the library's series on the axis uses R itself: s = 2 Re Phi */
    rwedge_series *series;
    double re, im, sxx, syy, txy;
    assert_ok(rwedge_series_create(0.5, 199, &series));
    assert_ok(rwedge_series_potential(series, 0.3, 0, y, &re, &im));
    assert_ok(rwedge_stress(0.5, 0.3, 0, 0, y, &sxx, &syy, &txy));
    assert_close(2 * re, (sxx + syy) / 2, 1e-13);
    rwedge_series_destroy(series);
}

CLAIM(E3_R_has_an_imaginary_part_on_the_contact)
{
    const double x = 0.4, above = 1e-9;
    const double complex z = x + I * above, R = z - csqrt(z - 1) * csqrt(z + 1);
    for (int n = 1; n < 6; n++) {
        const double T = cos(n * acos(x)), U = sin(n * acos(x)); /* sqrt(1-x^2) U_(n-1) */
        assert_within(cabs(cpow(R, n) - (T - I * U)), 0, 1e-7);
        assert_true(cabs(cpow(R, n) - T) > 0.1);
    }
}

static double corrective(double t, void *unused)
{
    (void)unused;
    return -sqrt(1 - t * t) / (t + 3); /* q*(t)/(t - z) at z = -3, with b_0 = 1 */
}

CLAIM(E4_the_corrective_potential_is_real_on_the_axis_outside)
{
    const double points[] = {-1, 1}, z = -3;
    /* -(1/2) b_0 R(z), R = z - sgn(z) sqrt(z^2-1) */
    const double series = -0.5 * (z + sqrt(z * z - 1));
    const double value = integral(corrective, NULL, 1, points);
    assert_close(-value / (2 * PI), series, 1e-12);
    assert_true(cabs(-value / (2 * PI * I) - series) > 0.1);
}

CLAIM(E5_E6_a_is_the_contact_half_width)
{
    /* E5: at the trailing edge of a contact with a/b = 0.2, sigma is 2 f theta/A: times b/(fP),
     * not a/(fP) */
    double sxx, syy, txy;
    const double alpha = 0.2, f = 0.4;
    assert_ok(rwedge_stress(alpha, f, 0, -1, 0, &sxx, &syy, &txy));
    const double by_b = sxx / (f * rwedge_load(alpha)), by_a = alpha * by_b;
    assert_close(by_b, rwedge_max_tension(alpha), 1e-14);
    assert_true(by_b >= 1 && by_b <= 4 / PI && by_a < 1);
    /* E6: below the sharp wedge |sx - sy| = 4 theta b/(pi A sqrt(y^2 + b^2)) */
    for (double y = 0.1; y < 3; y += 0.4) {
        assert_ok(rwedge_stress(0, 0, 0, 0, y, &sxx, &syy, &txy));
        assert_close(fabs(sxx - syy), 4 / (PI * sqrt(y * y + 1)), 1e-14);
    }
}

typedef struct {
    double alpha, c, x;
} slip_case;

static double shear_at(double t, void *context)
{
    const slip_case *s = context;
    return rwedge_shear(s->alpha, s->c, t);
}

/* E7: q opposes the slip in the slip zones; in the stick zone there is none. Eq. (17): the
 * relative displacement's gradient is (1/pi) int q/(x-t) dt. */
CLAIM(E7_slip_is_where_the_tractions_are_limited)
{
    for (double x = 0.05; x < 1; x += 0.1) {
        const slip_case s = {1, 0.5, x};
        const double gradient = -principal_value(shear_at, &s, -1, 1, x) / PI;
        if (x < 0.5)
            assert_within(gradient, 0, 1e-6);
        else
            /* from 0 at the stick zone the displacement has one sign: that of q < 0 */
            assert_true(gradient < -1e-3);
    }
}

/* E8: (A5) with the moduli as corrected gives (A7) = Eq. (8); as printed it does not. */
CLAIM(E8_moduli_of_the_appendix)
{
    const double alpha = 0.3, x = 0.7, phi = asin(x), phi0 = asin(alpha);
    const double rest = -2 * phi0 * cos(phi) / sin(phi0) -
                        sin(phi) / sin(phi0) * log(fabs(sin(phi - phi0) / sin(phi + phi0)));
    const double corrected = log(fabs(tan((phi + phi0) / 2)) * fabs(tan((phi - phi0) / 2)));
    const double printed = log(fabs(sin((phi + phi0) / 2) / cos((phi - phi0) / 2)) *
                               fabs(cos((phi + phi0) / 2) / sin((phi - phi0) / 2)));
    assert_close((corrected + rest) / PI, rwedge_pressure(alpha, x), 1e-14);
    assert_true(fabs((printed + rest) / PI - rwedge_pressure(alpha, x)) > 0.1);
    assert_true(fabs((-printed + rest) / PI - rwedge_pressure(alpha, x)) > 0.1);
}

/* E9: with q = f p the tension is at x = -b, and the yield point moves to x > 0, towards the
 * leading edge. */
CLAIM(E9_the_yield_point_moves_to_the_leading_edge)
{
    for (double alpha = 0.1; alpha < 1.05; alpha += 0.1) {
        double limit, x, y, before = 0;
        for (double f = 0.0125; f < rwedge_critical_friction(alpha, 0.3); f += 0.0125) {
            yield_at(alpha, f, &limit, &x, &y);
            assert_true(x > before && y > 0);
            before = x;
        }
        yield_at(alpha, 0.1, &limit, &x, &y);
        assert_true(J2_at(alpha, 0.1, 0, x, y) > 1.01 * J2_at(alpha, 0.1, 0, -x, y));
    }
}
