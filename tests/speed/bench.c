/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints times per call, and how they grow with the number of points. Beside them are the times of
 * the plain way: the paper's series, and a search on a grid. Each is processor time, the fastest of
 * several, and all are of one run. So the ratios hold on a busy machine too. This is not a test;
 * test_speed.c is one.
 *
 *     build/tests/speed/bench [--quick] [TERMS]
 *
 * TERMS of the plain series, 60 if not given; --quick stops at 10^5 points. */
#include "plain.h"
#include "rwedge.h"
#include "stopwatch.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 100000, LIMITS = 650, RUNS = 7 };
static const double TURN = 2 * 3.14159265358979323846;
static int terms = PLAIN_TERMS;

/* Points and their stresses, or cases and their elastic limits, for the longest array. */
static double *xs, *ys, *out[3];

static void make_points(long n)
{
    for (long i = 0; i < n; i++) {
        xs[i] = 4 * fmod((double)i * 0.6180339887498949, 1) - 2;
        ys[i] = 2 * fmod((double)i * 0.7548776662466927, 1) + 1e-3;
    }
}

/* ---- Stresses ---- */

static double point_by_point(double c, long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++) {
        double sxx, syy, txy;
        rwedge_stress(0.3, 0.4, c, xs[i], ys[i], &sxx, &syy, &txy);
        sum += sxx + syy + txy;
    }
    return sum;
}

static double one_by_one(long n)
{
    return point_by_point(0, n);
}

static double one_by_one_partial_slip(long n)
{
    return point_by_point(0.4, n);
}

static double in_array(double c, long n)
{
    rwedge_stresses(0.3, 0.4, c, (size_t)n, xs, ys, out[0], out[1], out[2]);
    return out[0][0] + out[2][n - 1];
}

static double as_array(long n)
{
    return in_array(0, n);
}

static double as_array_partial_slip(long n)
{
    return in_array(0.4, n);
}

static double plain_points(long n)
{
    plain_series s;
    double sum = 0;
    plain_coefficients(&s, 0.3, terms);
    for (long i = 0; i < n; i++)
        sum += plain_J2(&s, 0.4, 0.3, xs[i], ys[i]);
    return sum;
}

/* ---- Elastic limits; every call is cold ---- */

/* The paper's table: a/b = 0.1 ... 1, f = 0 ... 0.8. */
static double case_of(long i, double *f)
{
    *f = 0.0125 * (double)(i % (LIMITS / 10));
    return (double)(i % LIMITS / (LIMITS / 10) + 1) / 10;
}

static double limits_one_by_one(long n)
{
    double sum = 0, f;
    for (long i = 0; i < n; i++) {
        const double alpha = case_of(i, &f);
        sum += rwedge_elastic_limit(alpha, f, 0.3);
    }
    return sum;
}

/* The same with both branches, as `rwedge table` writes it. */
static double branches(long n)
{
    double sum = 0, f;
    for (long i = 0; i < n; i++) {
        const double alpha = case_of(i, &f);
        double limit, x, y;
        if (rwedge_subsurface_yield(alpha, f, 0.3, &limit, &x, &y) == RWEDGE_OK)
            sum += limit;
        rwedge_surface_yield(alpha, f, 0.3, &limit, &x);
        sum += limit;
    }
    return sum;
}

/* n cases, each another one, as an array. */
static double limits_in_array(long n)
{
    const long across = (long)ceil(sqrt((double)n));
    for (long i = 0; i < n; i++) {
        out[0][i] = ((double)(i / across) + 1) / (double)across;
        out[1][i] = 0.8 * (double)(i % across) / (double)across;
    }
    rwedge_elastic_limits((size_t)n, out[0], out[1], 0.3, out[2]);
    return out[2][n - 1];
}

static double plain_limits(long n)
{
    double sum = 0;
    for (long j = 0; j < n; j++)
        sum += plain_limit(0.5, 0.05 * (double)j, 0.3, terms);
    return sum;
}

/* ---- Others ---- */

static double inverses(long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += rwedge_a_over_b(1 + 1e-4 * (double)i);
    return sum;
}

static double pressures(long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += rwedge_pressure(0.3, (double)i / (double)n);
    return sum;
}

/* A fretting test: constant P, Q up and down, and each time the stresses at a hundred points. */
static double load_steps(long n)
{
    enum { POINTS_A_STEP = 100 };
    rwedge_contact *contact;
    double sum = 0;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK)
        return NAN;
    rwedge_contact_load(contact, 20000, 0);
    for (long i = 0; i < n; i++) {
        rwedge_contact_load(contact, 20000, 9000 * sin(0.3 * (double)i));
        rwedge_contact_stresses(contact, POINTS_A_STEP, xs, ys, out[0], out[1], out[2]);
        sum += out[0][0];
    }
    rwedge_contact_destroy(contact);
    return sum;
}

/* ---- Cycles of loads ---- */

/* Stresses at points through a cycle of a fretting test. */
enum { CYCLES = 1000, LOADS = 40 };
static double cycle[3][LOADS * CYCLES];

/* Q and sigma of the cycle, in phase. */
static double cyclic_Q[LOADS], cyclic_sigma[LOADS], steady_P[LOADS], steady_M[LOADS];

static void make_loads(double M, double sigma)
{
    for (int i = 0; i < LOADS; i++) {
        steady_P[i] = 20000;
        steady_M[i] = M;
        cyclic_Q[i] = 9000 * sin(TURN * i / LOADS);
        cyclic_sigma[i] = sigma * sin(TURN * i / LOADS);
    }
}

/* The same in one call, a point and load counted as one. */
static double history(long n, double M, double sigma)
{
    rwedge_contact *contact;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK)
        return NAN;
    make_loads(M, sigma);
    int32_t status = rwedge_contact_apply(contact, 20000, M, 0, 0);
    for (int i = 0; i < 2 && status == RWEDGE_OK; i++)
        status = rwedge_contact_stress_history(contact, LOADS, steady_P, steady_M, cyclic_Q,
                                               cyclic_sigma, (size_t)(n * i) / LOADS, xs, ys,
                                               out[0], out[1], out[2]);
    rwedge_contact_destroy(contact);
    return status == RWEDGE_OK ? out[0][0] + out[2][n - 1] : NAN;
}

static double centred_history(long n)
{
    return history(n, 0, 0);
}

static double history_off_centre(long n)
{
    return history(n, 3000, 100);
}

static bool make_cycles(void)
{
    rwedge_contact *contact;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK)
        return false;
    bool made = true;
    for (int i = -LOADS; i < LOADS && made; i++) { /* the first cycle is not yet a closed one */
        const size_t at = (size_t)(i < 0 ? 0 : i) * CYCLES;
        made = rwedge_contact_load(contact, 20000, 9000 * sin(TURN * i / LOADS)) == RWEDGE_OK &&
               rwedge_contact_stresses(contact, CYCLES, xs, ys, &cycle[0][at], &cycle[1][at],
                                       &cycle[2][at]) == RWEDGE_OK;
    }
    rwedge_contact_destroy(contact);
    return made;
}

static double smith_watson_topper(long n)
{
    rwedge_smith_watson_topper_field(LOADS, (size_t)n, cycle[0], cycle[1], cycle[2], 110000, 0.33,
                                     out[0], out[1]);
    return out[0][0] + out[1][n - 1];
}

static double fatemi_socie(long n)
{
    rwedge_fatemi_socie_field(LOADS, (size_t)n, cycle[0], cycle[1], cycle[2], 110000, 0.33, 0.001,
                              out[0], out[1]);
    return out[0][0] + out[1][n - 1];
}

/* The same by calls: what one call takes less. */
static double history_by_calls(long n)
{
    rwedge_contact *contact;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK)
        return NAN;
    rwedge_contact_load(contact, 20000, 0);
    const size_t points = (size_t)n / LOADS;
    for (int i = 0; i < LOADS; i++) {
        rwedge_contact_load(contact, 20000, 9000 * sin(TURN * i / LOADS));
        rwedge_contact_stresses(contact, points, xs, ys, out[0], out[1], out[2]);
    }
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][points - 1];
}

/* The yield factor of a contact that remembers as many reversals, each smaller than all before. */
static double yield_factors(int corners, long n)
{
    rwedge_contact *contact;
    double sum = 0, factor = NAN;
    if (rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact) != RWEDGE_OK)
        return NAN;
    rwedge_contact_load(contact, 20000, 0);
    for (int i = 1; i < corners; i++)
        rwedge_contact_load(contact, 20000,
                            (i % 2 ? 0.9 : -0.9) * 12000 * (1 - i / (corners + 1.0)));
    for (long i = 0; i < n; i++) {
        rwedge_contact_yield_factor(contact, 0.3, 100, &factor, NULL, NULL);
        sum += factor;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

static double yield_factors_of_one_load(long n)
{
    return yield_factors(1, n);
}

static double yield_factors_of_two(long n)
{
    return yield_factors(2, n);
}

static double yield_factors_of_251(long n)
{
    return yield_factors(251, n);
}

/* ---- What is printed ---- */

static void print_calls(double series, double search)
{
    const struct {
        const char *what;
        work call;
        long n;
        double plain;
    } rows[] = {
        {"stress at a point, full sliding", one_by_one, POINTS, series},
        {"stress at a point, partial slip", one_by_one_partial_slip, POINTS, 2 * series},
        {"stress in an array, full sliding", as_array, POINTS, series},
        {"stress in an array, partial slip", as_array_partial_slip, POINTS, 2 * series},
        {"elastic limit, cold", limits_one_by_one, LIMITS, search},
        {"both branches, cold", branches, LIMITS, search},
        {"half-width from the load", inverses, POINTS, 0},
        {"pressure", pressures, POINTS, 0},
        {"load step and 100 stress points", load_steps, 1000, 0},
        {"yield factor, one load", yield_factors_of_one_load, 100, 0},
        {"yield factor, P and then Q", yield_factors_of_two, 100, 0},
        {"yield factor, 251 corners", yield_factors_of_251, 1, 0},
        {"stresses through a cycle, by calls", history_by_calls, LOADS * CYCLES, 0},
        {"stresses through a cycle of Q", centred_history, LOADS * CYCLES, 0},
        {"and of Q and sigma, under M", history_off_centre, LOADS * CYCLES, 0},
        {"Smith-Watson-Topper of 40 loads", smith_watson_topper, CYCLES, 0},
        {"Fatemi-Socie of 40 loads", fatemi_socie, CYCLES, 0},
    };
    printf("%-34s %12s %12s %12s\n", "ns a call", "this", "plain", "plain / this");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const double time = fastest(rows[i].call, rows[i].n, RUNS);
        printf("%-34s %12.1f", rows[i].what, 1e9 * time);
        if (rows[i].plain > 0)
            printf(" %12.1f %12.1f", 1e9 * rows[i].plain, rows[i].plain / time);
        printf("\n");
    }
}

/* A few runs of a second at most. */
static int runs_for(long n, double expected)
{
    const double each = (double)n * expected;
    return each > 0.5 ? 1 : each > 0.1 ? 3 : RUNS;
}

static void print_growth(const char *what, work call, long from, long to, double expected)
{
    printf("%-34s", what);
    for (long n = from; n <= to; n *= 10)
        printf(" %9.1f", 1e9 * fastest(call, n, runs_for(n, expected)));
    printf("\n");
}

static void print_powers(const char *what, int from, int to)
{
    printf("\n%-34s", what);
    for (int k = from; k <= to; k++)
        printf("      10^%d", k);
    printf("\n");
}

static bool reserve(size_t n)
{
    double **arrays[] = {&xs, &ys, &out[0], &out[1], &out[2]};
    bool reserved = true;
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        reserved = (*arrays[i] = malloc(n * sizeof **arrays[i])) != NULL && reserved;
    return reserved;
}

static void release(void)
{
    free(xs);
    free(ys);
    for (int i = 0; i < 3; i++)
        free(out[i]);
}

int main(int argc, char **argv)
{
    const bool quick = argc > 1 && strcmp(argv[1], "--quick") == 0;
    if (argc > 1 + quick)
        terms = atoi(argv[1 + quick]);
    if (terms < 1 || terms > PLAIN_TERMS_MAX || argc > 2 + quick) {
        fprintf(stderr, "usage: bench [--quick] [TERMS]   1 <= TERMS <= %d\n", PLAIN_TERMS_MAX);
        return 2;
    }
    const long most_points = quick ? 100000 : 10000000, most_limits = quick ? 10000 : 1000000;
    if (!reserve((size_t)most_points)) {
        fprintf(stderr, "bench: no memory for %ld points\n", most_points);
        release();
        return 1;
    }
    make_points(most_points);
    if (!make_cycles()) {
        fprintf(stderr, "bench: no cycle of loads\n");
        release();
        return 1;
    }
    const double series = fastest(plain_points, POINTS, RUNS),
                 search = fastest(plain_limits, 13, quick ? 1 : RUNS);
    print_calls(series, search);
    print_powers("ns a point, points in an array", 3, quick ? 5 : 7);
    print_growth("stress, full sliding", as_array, 1000, most_points, 30e-9);
    print_growth("stress, partial slip", as_array_partial_slip, 1000, most_points, 60e-9);
    print_growth("plain series", plain_points, 1000, quick ? 100000 : 1000000, series);
    print_powers("ns a limit, limits in an array", 2, quick ? 4 : 6);
    print_growth("elastic limit", limits_in_array, 100, most_limits, 6e-6);
    printf("\nThe paper's table of %d elastic limits: %.2f ms; by the plain search: %.0f ms.\n",
           LIMITS, 1e3 * LIMITS * fastest(limits_one_by_one, LIMITS, RUNS), 1e3 * LIMITS * search);
    printf("Error of the plain elastic limit at a/b = 0.5, f = 0.6: %.1e\n",
           plain_limit(0.5, 0.6, 0.3, terms) / rwedge_elastic_limit(0.5, 0.6, 0.3) - 1);
    release();
    return 0;
}
