/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numerical tools of lib/base/: roots, largest values, quadrature, least squares. */
#include "claims.h"
#include "base/least_squares.h"
#include "base/linear.h"
#include "base/maximum.h"
#include "rwedge.h"
#include "base/root.h"

#include <float.h>

/* ---- Roots ---- */

static double power_less_two(double x, const void *exponent)
{
    return pow(x, *(const double *)exponent) - 2;
}

CLAIM(roots_are_found_to_the_last_bits)
{
    for (double exponent = 1; exponent < 60; exponent += 3.7)
        assert_close(rw_root(power_less_two, &exponent, 0, 3, 0), pow(2, 1 / exponent),
                     4 * DBL_EPSILON);
    const double square = 2;
    assert_close(rw_root(power_less_two, &square, 0, 3, 0.01), sqrt(2), 0.01);
}

static double line(double x, const void *root)
{
    return x - *(const double *)root;
}

CLAIM(a_root_may_be_at_an_end)
{
    const double lo = -1, hi = 0.3;
    assert_true(rw_root(line, &lo, lo, hi, 0) == lo);
    assert_true(rw_root(line, &hi, lo, hi, 0) == hi);
}

static double inverse_of_line(double x, const void *pole)
{
    return 1 / line(x, pole);
}

CLAIM(what_brackets_no_root_is_refused)
{
    const double below = -2, above = 2, lo = -1, hi = 1, not_a_number = NAN;
    assert_nan(rw_root(line, &below, lo, hi, 0));
    assert_nan(rw_root(line, &above, lo, hi, 0));
    assert_nan(rw_root(inverse_of_line, &lo, lo, hi, 0));
    assert_nan(rw_root(inverse_of_line, &hi, lo, hi, 0));
    assert_nan(rw_root(line, &not_a_number, lo, hi, 0));
}

static double line_with_a_hole(double x, const void *root)
{
    return fabs(line(x, root)) < 0.5 ? NAN : line(x, root);
}

/* GSL's handler would end the host. */
CLAIM(a_function_that_is_not_finite_inside_is_refused)
{
    const double root = 0.3;
    assert_nan(rw_root(line_with_a_hole, &root, -1, 2, 0));
}

static double jump(double x, const void *context)
{
    (void)context;
    return x > 0 ? 1 : -1;
}

/* The root is 0, and no error is small beside it. Without an absolute tolerance the search has no
 * end, and gives up. */
CLAIM(a_search_ends)
{
    assert_nan(rw_root(jump, NULL, -1, 2, 0));
    assert_within(rw_root(jump, NULL, -1, 2, 1e-12), 0, 1e-12);
}

/* ---- Largest values ---- */

static double spike(double x, const void *top)
{
    return 2 - sqrt(fabs(line(x, top)) / 4);
}

/* 64 steps, dense at the ends: the widest is 0.05 of the half-length. */
CLAIM(the_largest_value_is_found_to_1e_8_of_the_steps)
{
    double place[RW_SPREAD], value[RW_SPREAD];
    rw_spread_places(-3, 1, place);
    assert_true(place[0] == -3 && place[RW_SPREAD - 1] == 1);
    for (int i = 1; i < RW_SPREAD; i++)
        assert_true(place[i] > place[i - 1] && place[i] - place[i - 1] < 0.1);
    for (double top = -3; top < 1; top += 0.173) {
        const rw_maximum found = rw_largest_value(spike, &top, RW_SPREAD, place, value);
        assert_within(found.x, top, 4e-8 * 0.2); /* of both steps beside it */
        assert_true(found.value == spike(found.x, &top));
    }
}

static double two_tops(double x, const void *second)
{
    return fmax(1 - x * x, 1.001 - 1e3 * pow(line(x, second), 2));
}

/* At the places the lower top is the higher one. */
CLAIM(of_tops_nearly_as_high_the_highest_is_found)
{
    const double place[] = {-1, 0, 1, 1.995, 3}, second = 2;
    double value[5];
    const rw_maximum found = rw_largest_value(two_tops, &second, 5, place, value);
    assert_true(value[1] > value[3]);
    assert_within(found.x, second, 1e-8);
    assert_close(found.value, 1.001, 1e-14);
}

static double even(double x, const void *value)
{
    (void)x;
    return *(const double *)value;
}

CLAIM(the_first_of_equal_values_counts)
{
    const double place[] = {-2, 0, 2}, zero = 0, one = 1;
    double value[3];
    assert_true(rw_largest_value(even, &zero, 3, place, value).x == -2);
    assert_true(rw_largest_value(even, &one, 1, place, value).x == -2);
}

/* ---- Quadrature ---- */

static double power(double x, const void *exponent)
{
    return pow(x, *(const int *)exponent);
}

/* The square of Legendre's polynomial, by its recurrence; its integral over [-1, 1] is 2/(2n+1). */
static double squared_legendre(double x, const void *degree)
{
    double before = 1, P = x;
    for (int n = 2; n <= *(const int *)degree; n++) {
        const double next = ((2 * n - 1) * x * P - (n - 1) * before) / n;
        before = P;
        P = next;
    }
    return P * P;
}

/* The nodes are the zeros of P_16: the rule sees nothing of its square, whose degree is the
 * first that is not exact. */
CLAIM(the_rule_is_exact_to_degree_31)
{
    for (int degree = 0; degree <= 31; degree++) {
        assert_close(rw_integral(power, &degree, 0, 1), 1.0 / (degree + 1), 4 * DBL_EPSILON);
        assert_close(rw_integral(power, &degree, 1, 2), (ldexp(1, degree + 1) - 1) / (degree + 1),
                     32 * DBL_EPSILON);
    }
    for (int n = 1; n <= 16; n++)
        assert_within(rw_integral(squared_legendre, &n, -1, 1), n < 16 ? 2.0 / (2 * n + 1) : 0,
                      1e-15);
}

/* ---- Least squares ---- */

enum { ROWS = 12 };

/* The points are those of a parabola, moved by +-1 in a pattern that is orthogonal to it. */
CLAIM(a_parabola_is_fitted)
{
    double A[3 * ROWS], v[ROWS];
    for (int i = 0; i < ROWS; i++) {
        const double x = i < 4 ? -1 : i < 8 ? 0 : 1;
        A[i] = 1;
        A[ROWS + i] = x;
        A[2 * ROWS + i] = x * x;
        v[i] = 3 - 2 * x + 5 * x * x + (i % 2 ? 1 : -1);
    }
    assert_ok(rw_least_squares(ROWS, 3, A, v));
    assert_close(v[0], 3, 1e-14);
    assert_close(v[1], -2, 1e-14);
    assert_close(v[2], 5, 1e-14);
}

/* Two columns under an angle have the condition number cot(angle/2). */
CLAIM(columns_that_are_nearly_one_are_refused)
{
    for (double angle = 0.1; angle > 1e-15; angle /= 10) {
        double A[4] = {1, 0, cos(angle), sin(angle)}, v[2] = {1, PI};
        const int32_t status = rw_least_squares(2, 2, A, v);
        assert_int_equal(status, 2 / angle < 1 / sqrt(DBL_EPSILON) ? RWEDGE_OK : RWEDGE_ERANK);
    }
}

/* ---- Linear equations ---- */

CLAIM(a_matrix_that_has_no_solution_is_refused)
{
    double b[] = {1, 1}, singular[] = {1, 2, 2, 4}, endless[] = {HUGE_VAL}, small[] = {1e-300},
           large[] = {1e300}, indefinite[] = {1, 2, 2, 1};
    assert_false(rw_solve(2, 1, singular, b));
    assert_false(rw_solve(1, 1, endless, b));
    assert_false(rw_solve(1, 1, small, large));
    assert_false(rw_cholesky(2, indefinite));
}
