/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An array of points is evaluated in batches, with vector instructions if the processor has them.
 * The bits are those of the points one by one, for every length, for every mixture of points, and
 * in place. No exception is raised on which a host may trap. */
#include "claims.h"
#include "rwedge.h"

#include <fenv.h>
#include <float.h>
#include <string.h>

enum { N = 331 };
static const double alphas[] = {0, 1e-60, 1e-40, 1e-12, 0.2, 0.7071067811865476, 1 - DBL_EPSILON,
                                1, 3,     1e60};
static const double stick_zones[] = {0, 1e-60, 1e-40, 1e-9, 0.2, 0.4, 1 - DBL_EPSILON, 1};
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static double power_of_ten(double from, double to, uint64_t *seed)
{
    return pow(10, from + (to - from) * random_fraction(seed));
}

/* Points of all kinds: inside, on the surface, next to a corner or an edge, at the apex, remote. */
static void make_points(double x[], double y[], int mixture, double alpha, double c)
{
    uint64_t seed = 17;
    const double corner[] = {alpha, c, 1, 0};
    for (int i = 0; i < N; i++) {
        x[i] = 6 * random_fraction(&seed) - 3;
        y[i] = 3 * random_fraction(&seed);
        const double kind = mixture * random_fraction(&seed);
        if (kind > 0.8 && kind < 1) {
            x[i] = corner[i % 4] + power_of_ten(-17, 0, &seed);
            y[i] = power_of_ten(-17, 0, &seed);
        } else if (kind > 1 && kind < 1.2) {
            y[i] = 0;
        } else if (kind > 1.7) {
            x[i] = -power_of_ten(-59.9, 59.9, &seed);
            y[i] = power_of_ten(-59.9, 59.9, &seed);
        }
    }
}

static bool same_bits(const double *a, const double *b, size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

static void assert_alike(double alpha, double c, size_t n, const double x[], const double y[])
{
    double sxx[N], syy[N], txy[N], alone[3];
    feclearexcept(FE_ALL_EXCEPT);
    assert_ok(rwedge_stresses(alpha, 0.4, c, n, x, y, sxx, syy, txy));
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    if (raised)
        fail_msg("a/b = %g, c/b = %g, %zu points: exceptions %x", alpha, c, n, (unsigned)raised);
    for (size_t i = 0; i < n; i++) {
        assert_ok(rwedge_stress(alpha, 0.4, c, x[i], y[i], &alone[0], &alone[1], &alone[2]));
        if (!same_bits(&alone[0], &sxx[i], 1) || !same_bits(&alone[1], &syy[i], 1) ||
            !same_bits(&alone[2], &txy[i], 1))
            fail_msg("a/b = %g, c/b = %g, point %zu of %zu, (%a, %a): in the array %a %a %a, alone "
                     "%a %a %a",
                     alpha, c, i, n, x[i], y[i], sxx[i], syy[i], txy[i], alone[0], alone[1],
                     alone[2]);
    }
}

CLAIM(batches_have_the_bits_of_their_points)
{
    double x[N], y[N];
    for (size_t i = 0; i < COUNT(alphas); i++)
        for (size_t j = 0; j < COUNT(stick_zones); j++)
            for (int mixture = 1; mixture <= 2; mixture++) {
                make_points(x, y, mixture, alphas[i], stick_zones[j]);
                assert_alike(alphas[i], stick_zones[j], N, x, y);
            }
}

CLAIM(every_length_is_filled)
{
    double x[N], y[N];
    make_points(x, y, 2, 0.2, 0.4);
    for (size_t n = 1; n <= 140; n++)
        assert_alike(0.2, 0.4, n, x + n, y + n);
}

/* Nothing is written behind the last point. */
CLAIM(neighbours_are_left_alone)
{
    double x[N], y[N], s[3][N];
    make_points(x, y, 1, 0.2, 0.4);
    for (size_t n = 1; n < 140; n++) {
        for (int k = 0; k < 3; k++)
            s[k][n] = 7;
        assert_ok(rwedge_stresses(0.2, 0.4, 0.4, n, x, y, s[0], s[1], s[2]));
        assert_true(s[0][n] == 7 && s[1][n] == 7 && s[2][n] == 7);
    }
}

CLAIM(outputs_may_be_the_inputs)
{
    double x[N], y[N], s[3][N];
    make_points(x, y, 2, 0.2, 0.4);
    assert_ok(rwedge_stresses(0.2, 0.4, 0.4, N, x, y, s[0], s[1], s[2]));
    double txy[N];
    assert_ok(rwedge_stresses(0.2, 0.4, 0.4, N, x, y, y, x, txy));
    assert_true(same_bits(y, s[0], N) && same_bits(x, s[1], N) && same_bits(txy, s[2], N));
}

/* Of the same size as the inputs: one load at many points, many loads at one. */
CLAIM(outputs_of_a_contact_may_be_the_inputs)
{
    enum { M = 5 };
    double P[M] = {2000, 2100, 2000, 1900, 2000}, moment[M] = {0}, Q[M] = {-600, 0, 300, -100, 50};
    const double sigma[M] = {0};
    double x[M] = {-0.4, -0.2, 0, 0.1, 0.3}, y[M] = {0, 0.1, 0.2, 0, 1}, at = 0.1, deep = 0.3;
    double s[3][M], txy[M];
    rwedge_contact *contact = NULL, *twin = NULL;
    assert_ok(rwedge_contact_create(0.01, 0.5, 1.8e-5, 0.6, &contact));
    assert_ok(rwedge_contact_load(contact, 2000, 0));
    assert_ok(rwedge_contact_load(contact, 2000, 300));
    assert_ok(rwedge_contact_copy(contact, &twin));

    assert_ok(rwedge_contact_tractions(contact, M, x, s[0], s[1]));
    memcpy(txy, x, sizeof x);
    assert_ok(rwedge_contact_tractions(contact, M, txy, s[2], txy));
    assert_true(same_bits(s[2], s[0], M) && same_bits(txy, s[1], M));
    assert_ok(rwedge_contact_slip(contact, M, x, s[0]));
    memcpy(txy, x, sizeof x);
    assert_ok(rwedge_contact_slip(contact, M, txy, txy));
    assert_true(same_bits(txy, s[0], M));

    assert_ok(rwedge_contact_stress_history(contact, M, P, moment, Q, sigma, 1, &at, &deep, s[0],
                                            s[1], s[2]));
    assert_ok(
        rwedge_contact_stress_history(twin, M, P, moment, Q, sigma, 1, &at, &deep, Q, P, moment));
    assert_true(same_bits(Q, s[0], M) && same_bits(P, s[1], M) && same_bits(moment, s[2], M));
    const double load = 2100, none = 0;
    assert_ok(rwedge_contact_stress_history(contact, 1, &load, &none, &none, &none, M, x, y, s[0],
                                            s[1], s[2]));
    assert_ok(
        rwedge_contact_stress_history(twin, 1, &load, &none, &none, &none, M, x, y, y, x, txy));
    assert_true(same_bits(y, s[0], M) && same_bits(x, s[1], M) && same_bits(txy, s[2], M));
    rwedge_contact_destroy(twin);
    rwedge_contact_destroy(contact);
}

CLAIM(outputs_of_measures_may_be_the_inputs)
{
    enum { POINTS = 4 };
    double sxx[POINTS] = {100, -50, 0, 1}, syy[POINTS] = {-20, 10, 3, 0},
           txy[POINTS] = {5, 9, 0, 2};
    double value[POINTS], angle[POINTS];
    double(*const columns[])[POINTS] = {&sxx, &syy, &txy};
    for (int k = 0; k < 3; k++) {
        double before[POINTS];
        memcpy(before, *columns[k], sizeof before);
        assert_ok(
            rwedge_smith_watson_topper_field(1, POINTS, sxx, syy, txy, 2e5, 0.3, value, angle));
        assert_ok(rwedge_smith_watson_topper_field(1, POINTS, sxx, syy, txy, 2e5, 0.3, *columns[k],
                                                   angle));
        assert_true(same_bits(*columns[k], value, POINTS));
        memcpy(*columns[k], before, sizeof before);
        assert_ok(
            rwedge_fatemi_socie_field(1, POINTS, sxx, syy, txy, 2e5, 0.3, 1e-3, value, angle));
        assert_ok(rwedge_fatemi_socie_field(1, POINTS, sxx, syy, txy, 2e5, 0.3, 1e-3, value,
                                            *columns[k]));
        assert_true(same_bits(*columns[k], angle, POINTS));
        memcpy(*columns[k], before, sizeof before);
    }
}

CLAIM(elastic_limits_are_those_of_single_calls)
{
    double alpha[N], f[N], limit[N];
    uint64_t seed = 23;
    for (int i = 0; i < N; i++) {
        alpha[i] = i % 3 ? 1.2 * random_fraction(&seed) : power_of_ten(-14, 0, &seed);
        f[i] = i % 5 ? random_fraction(&seed) : 0;
    }
    assert_ok(rwedge_elastic_limits(N, alpha, f, 0.3, limit));
    for (int i = 0; i < N; i++) {
        const double alone = rwedge_elastic_limit(alpha[i], f[i], 0.3);
        assert_true(same_bits(&alone, &limit[i], 1));
    }
}

CLAIM(no_points_need_no_arrays)
{
    assert_ok(rwedge_stresses(0.2, 0.4, 0.3, 0, NULL, NULL, NULL, NULL, NULL));
    assert_ok(rwedge_elastic_limits(0, NULL, NULL, 0.3, NULL));
}
