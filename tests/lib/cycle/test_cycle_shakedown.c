/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounds of the shakedown of a cycle that stays in place. */
#include "histories.h"

enum { LOADS_MAX = 26 };

/* With theta = A = b = 1: P constant, Q = share f P cos(2 pi i/n), after a cycle. */
static rwedge_cycle *shaken(double alpha, double f, double share, size_t n, double *P)
{
    rwedge_contact *contact = NULL;
    rwedge_cycle *cycle = NULL;
    double p[LOADS_MAX], zero[LOADS_MAX] = {0}, q[LOADS_MAX];
    *P = rwedge_normal_load(1, alpha, 1, 1);
    assert_ok(rwedge_contact_create(1, alpha, 1, f, &contact));
    assert_ok(rwedge_contact_load(contact, *P, 0));
    for (size_t i = 0; i < n; i++) {
        p[i] = *P;
        q[i] = share * f * *P * cos(2 * PI * (double)i / (double)n);
        assert_ok(rwedge_contact_load(contact, p[i], q[i]));
    }
    assert_ok(rwedge_cycle_create(contact, n, p, zero, q, zero, &cycle));
    rwedge_contact_destroy(contact);
    return cycle;
}

typedef struct {
    double lower, upper, x, y;
} bounds;

static bounds bounds_of(const rwedge_cycle *cycle, double nu, double k)
{
    bounds b = {0, 0, 0, 0};
    assert_ok(rwedge_cycle_shakedown(cycle, nu, k, &b.lower, &b.upper, &b.x, &b.y));
    return b;
}

/* A prototype in another language, over 17 depths and 146 places of each: coarse where a bound is
 * below the surface, or between the places. */
CLAIM(the_bounds_are_those_of_a_prototype)
{
    static const double CASES[][6] = {/* a/b, f, Q_a/(f P), lower, upper P/(bk), how close */
                                      {1, 0.5, 0.6, 3.9518, 3.9518, 1e-4},
                                      {1, 0.8, 0.9, 2.0167, 2.0167, 1e-4},
                                      {0.25, 0.8, 0.9, 1.4032, 1.4032, 0.015},
                                      {0.25, 0.5, 0.6, 3.820, 4.012, 0.015},
                                      {0.25, 0.3, 0.6, 4.605, 6.687, 0.015}};
    for (int i = 0; i < 5; i++) {
        const double *c = CASES[i];
        double P;
        rwedge_cycle *cycle = shaken(c[0], c[1], c[2], LOADS_MAX, &P);
        const bounds b = bounds_of(cycle, 0.3, 1);
        assert_close(P * b.lower, c[3], c[5]);
        assert_close(P * b.upper, c[4], c[5]);
        assert_true(b.lower <= b.upper);
        if (i < 3) /* the surface governs */
            assert_close(b.lower, b.upper, 1e-5);
        rwedge_cycle_destroy(cycle);
    }
}

/* A linear program over residual stresses that are in equilibrium: tests/proof/melan.py. */
CLAIM(what_mathematical_programming_finds_is_between_the_bounds)
{
    reference rows = reference_open("cycle_shakedown.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell;
        double P;
        rwedge_cycle *cycle = shaken(c[0], c[1], c[2], (size_t)c[4], &P);
        const bounds b = bounds_of(cycle, c[3], 1);
        assert_true(P * b.lower < c[5] * 1.005 && c[5] < P * b.upper * 1.005);
        rwedge_cycle_destroy(cycle);
    }
}

/* ---- By brute force ---- */

enum { WIDE = 241, DEEP = 25 };

static double places[WIDE], stress[3][3 * WIDE];

/* The largest, over the places of a depth, of what a shift of Re D by c leaves, the second part
 * being shifted as it is best: by thirds. */
static double left_by_thirds(double c, double weight)
{
    double most = 0;
    for (int j = 0; j < WIDE; j++) {
        double low = -10, high = 10, at[2];
        while (high - low > 1e-8) {
            for (int side = 0; side < 2; side++) {
                const double shift = low + (1 + side) * (high - low) / 3;
                at[side] = 0;
                for (int i = 0; i < 3; i++) {
                    const double sxx = stress[0][i * WIDE + j], syy = stress[1][i * WIDE + j],
                                 txy = stress[2][i * WIDE + j], d = (syy - sxx) / 2 - c,
                                 s = weight * (sxx + syy) / 2 - shift;
                    at[side] = fmax(at[side], sqrt(d * d + s * s + txy * txy));
                }
            }
            *(at[0] < at[1] ? &high : &low) += at[0] < at[1] ? -(high - low) / 3 : (high - low) / 3;
        }
        most = fmax(most, at[0]);
    }
    return most;
}

CLAIM(the_lower_bound_is_that_of_a_search_by_thirds)
{
    const double nu = 0.3, weight = (1 - 2 * nu) / sqrt(3);
    double P, most = 0;
    rwedge_cycle *cycle = shaken(0.5, 0.3, 0.7, 3, &P);
    for (int j = 0; j < WIDE; j++)
        places[j] = 1.2 * sin(PI / 2 * (2. * j / (WIDE - 1) - 1));
    for (int k = 0; k < DEEP; k++) {
        double y[WIDE], low = -3, high = 3;
        for (int j = 0; j < WIDE; j++)
            y[j] = k == 0 ? 0 : 0.02 * pow(1.2, k - 1);
        assert_ok(
            rwedge_cycle_stresses(cycle, 3, WIDE, places, y, stress[0], stress[1], stress[2]));
        while (high - low > 1e-5) {
            const double third = (high - low) / 3;
            if (left_by_thirds(low + third, weight) < left_by_thirds(high - third, weight))
                high -= third;
            else
                low += third;
        }
        most = fmax(most, left_by_thirds(low, weight));
    }
    const bounds b = bounds_of(cycle, nu, 1);
    assert_true(1 / b.lower > most * (1 - 1e-5) && 1 / b.lower < most * (1 + 5e-3));
    rwedge_cycle_destroy(cycle);
}

/* ---- What must hold ---- */

/* The factor without residual stress is below the lower bound. */
CLAIM(the_lower_bound_is_not_below_first_yield)
{
    uint64_t seed = 3;
    for (int i = 0; i < 4; i++) {
        const double alpha = 0.2 + 0.8 * random_fraction(&seed),
                     f = 0.2 + 0.6 * random_fraction(&seed),
                     share = 0.3 + 0.6 * random_fraction(&seed);
        double P, least = HUGE_VAL, factor, x, y;
        rwedge_cycle *cycle = shaken(alpha, f, share, 2, &P);
        rwedge_contact *contact = NULL;
        assert_ok(rwedge_contact_create(1, alpha, 1, f, &contact));
        assert_ok(rwedge_contact_load(contact, P, 0));
        for (int k = 0; k < 4; k++) {
            assert_ok(rwedge_contact_load(contact, P, (k % 2 ? -1 : 1) * share * f * P));
            assert_ok(rwedge_contact_yield_factor(contact, 0.3, 1, &factor, &x, &y));
            least = k < 2 ? HUGE_VAL : fmin(least, factor);
        }
        const bounds b = bounds_of(cycle, 0.3, 1), twice = bounds_of(cycle, 0.3, 2);
        assert_true(b.lower >= least * (1 - 1e-6) && b.upper >= b.lower);
        assert_close(twice.lower, 2 * b.lower, 1e-9);
        assert_close(twice.upper, 2 * b.upper, 1e-9);
        rwedge_cycle_destroy(cycle);
        rwedge_contact_destroy(contact);
    }
}

CLAIM(a_cycle_without_contact_or_at_a_sharp_apex_has_no_bounds)
{
    double P, lower = 7, upper = 7, x = 7, y = 7;
    const double zero[2] = {0}, one[2] = {1, 1};
    rwedge_contact *contact = NULL;
    rwedge_cycle *apart = NULL, *sharp = NULL, *cycle = shaken(0.5, 0.3, 0.7, 2, &P);
    assert_ok(rwedge_contact_create(0.1, 0, 1, 0.3, &contact));
    assert_ok(rwedge_cycle_create(contact, 2, zero, zero, zero, zero, &apart));
    assert_ok(rwedge_cycle_create(contact, 2, one, zero, zero, zero, &sharp));
    assert_int_equal(rwedge_cycle_shakedown(apart, 0.3, 1, &lower, &upper, &x, &y), RWEDGE_EABSENT);
    assert_int_equal(rwedge_cycle_shakedown(sharp, 0.3, 1, &lower, &upper, &x, &y), RWEDGE_EABSENT);
    assert_int_equal(rwedge_cycle_shakedown(cycle, 0.6, 1, &lower, &upper, &x, &y), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_shakedown(cycle, 0.3, 0, &lower, &upper, &x, &y), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_shakedown(cycle, 0.3, 1, NULL, &upper, &x, &y), RWEDGE_ENULL);
    assert_true(lower == 7 && upper == 7 && x == 7 && y == 7);
    rwedge_cycle_destroy(apart);
    rwedge_cycle_destroy(sharp);
    rwedge_cycle_destroy(cycle);
    rwedge_contact_destroy(contact);
}
