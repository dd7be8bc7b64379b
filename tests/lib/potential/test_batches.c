/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An array of points is evaluated in batches, with vector instructions if the processor has them.
 * The bits are those of the points one by one, for every length, and for every mixture of points;
 * nothing is written behind the last. No exception is raised on which a host may trap. */
#include "claims.h"
#include "potential/eccentric.h"
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
    double sxx[N + 1], syy[N + 1], txy[N + 1], alone[3];
    sxx[n] = syy[n] = txy[n] = 7;
    feclearexcept(FE_ALL_EXCEPT);
    assert_ok(rwedge_stresses(alpha, 0.4, c, n, x, y, sxx, syy, txy));
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    if (raised)
        fail_msg("a/b = %g, c/b = %g, %zu points: exceptions %x", alpha, c, n, (unsigned)raised);
    assert_true(sxx[n] == 7 && syy[n] == 7 && txy[n] == 7);
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

static const struct {
    double a;
    rw_patch patch;
} patches[] = {{0, {-0.8, 1.2}}, {0.3, {-0.8, 1.2}},  {0.3, {-0.2, 1.8}},
               {3, {-0.8, 1.2}}, {1e-9, {-0.7, 0.9}}, {1, {-0.95, 1.001}}};

CLAIM(batches_off_the_centre_have_the_bits_of_their_points)
{
    double x[N], y[N];
    make_points(x, y, 1, 0.3, 1.2);
    for (size_t i = 0; i < COUNT(patches); i++) {
        rw_eccentric potential;
        rw_eccentric_init_arc(&potential, rw_rounding(patches[i].a), patches[i].patch);
        for (int n = 1; n <= RW_BATCH; n += 7) {
            rw_fields fields;
            rw_eccentric_fields(&potential, n, x + n, y + n, &fields);
            for (int k = 0; k < n; k++) {
                const rw_field alone = rw_eccentric_at(&potential, x[n + k], y[n + k]),
                               of_batch = rw_field_in(&fields, k);
                assert_memory_equal(&alone, &of_batch, sizeof alone);
            }
        }
    }
}
