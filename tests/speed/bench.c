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
#include "stopwatch.h"
#include "works.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 100000, RUNS = 7 };

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
    rwedge_contact *contact = new_contact();
    double sum = 0;
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
static double history(double M, double sigma, long n)
{
    rwedge_contact *contact = new_contact();
    make_loads(M, sigma);
    must(rwedge_contact_apply(contact, 20000, M, 0, 0));
    for (int i = 0; i < 2; i++)
        must(rwedge_contact_stress_history(contact, LOADS, steady_P, steady_M, cyclic_Q,
                                           cyclic_sigma, (size_t)(n * i) / LOADS, xs, ys, out[0],
                                           out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][n - 1];
}

static void make_cycles(void)
{
    rwedge_contact *contact = new_contact();
    for (int i = -LOADS; i < LOADS; i++) { /* the first cycle is not yet a closed one */
        const size_t at = (size_t)(i < 0 ? 0 : i) * CYCLES;
        must(rwedge_contact_load(contact, 20000, 9000 * sin(TURN * i / LOADS)));
        must(rwedge_contact_stresses(contact, CYCLES, xs, ys, &cycle[0][at], &cycle[1][at],
                                     &cycle[2][at]));
    }
    rwedge_contact_destroy(contact);
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

static double criterion(double measure, double unused, long n)
{
    (void)unused;
    static double planes[2][CYCLES];
    must(rwedge_criterion_field((int32_t)measure, LOADS, (size_t)n, cycle[0], cycle[1], cycle[2],
                                110000, 0.33, 0, 0.3, 1, out[0], planes[0], planes[1]));
    return out[0][0] + planes[0][n - 1];
}

static double damage(long n)
{
    static double cycles[CYCLES], planes[2][CYCLES];
    must(rwedge_smith_watson_topper_damage_field(LOADS, (size_t)n, cycle[0], cycle[1], cycle[2],
                                                 110000, 0.33, 0, 1000, -0.1, 0.5, -0.6, 0, out[0],
                                                 cycles, planes[0], planes[1]));
    return out[0][0] + cycles[n - 1];
}

/* The same by calls: what one call takes less. */
static double history_by_calls(long n)
{
    rwedge_contact *contact = new_contact();
    rwedge_contact_load(contact, 20000, 0);
    const size_t points = (size_t)n / LOADS;
    for (int i = 0; i < LOADS; i++) {
        rwedge_contact_load(contact, 20000, 9000 * sin(TURN * i / LOADS));
        rwedge_contact_stresses(contact, points, xs, ys, out[0], out[1], out[2]);
    }
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][points - 1];
}

/* ---- Loads without a closed form ---- */

/* The stresses of a third cycle of 48 such loads at n places, and their critical planes. */
static double lagging_cycle(long n)
{
    enum { LAGGING = 48 };
    double P[LAGGING], M[LAGGING] = {0}, Q[LAGGING], sigma[LAGGING];
    static double y[CYCLES]; /* the surface */
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_allow_error(contact, 1e-4));
    must(rwedge_contact_load(contact, 20000, 0));
    for (int i = 0; i < LAGGING; i++) {
        P[i] = 20000;
        Q[i] = 9000 * sin(TURN * i / LAGGING);
        sigma[i] = 2000 * sin(TURN * i / LAGGING - TURN / 8);
    }
    for (int i = 0; i < 3; i++)
        must(rwedge_contact_stress_history(contact, LAGGING, P, M, Q, sigma, i < 2 ? 0 : (size_t)n,
                                           xs, y, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    static double value[CYCLES], angle[CYCLES];
    must(rwedge_smith_watson_topper_field(LAGGING, (size_t)n, out[0], out[1], out[2], 110000, 0.33,
                                          value, angle));
    return value[0];
}

/* ---- What is printed ---- */

static void print_histories(bool quick)
{
    const long loads = quick ? 1000 : 10000;
    printf("\n48 loads whose tension lags, three times, to 1e-4; SWT at 300 places: %.2f s\n",
           300 * fastest((work){.plain = lagging_cycle}, 300, quick ? 1 : 3));
    printf("A noisy log of %ld loads, to 1e-3: %.1f s\n", loads,
           (double)loads * fastest((work){NULL, lagging, 1e-3, 0.03}, loads, 1));
}

static void print_calls(double series, double search)
{
    const struct {
        const char *name;
        work call;
        long n;
        double plain;
    } rows[] = {
        {"stress at a point, full sliding", {NULL, points_one_by_one, 0, 0}, POINTS, series},
        {"stress at a point, partial slip", {NULL, points_one_by_one, 0.4, 0}, POINTS, 2 * series},
        {"stress in an array, full sliding", {NULL, array_of_points, 0, 0}, POINTS, series},
        {"stress in an array, partial slip", {NULL, array_of_points, 0.4, 0}, POINTS, 2 * series},
        {"stress in an array, of a contact", {.plain = points_of_a_wedge}, POINTS, 0},
        {"the same, of a flat pad", {.plain = points_of_a_flat_pad}, POINTS, 0},
        {"of a profile of 100 places", {.plain = points_of_a_profile}, POINTS / 10, 0},
        {"elastic limit, cold", {.plain = limits_one_by_one}, PAPER_LIMITS, search},
        {"both branches, cold", {.plain = branches}, PAPER_LIMITS, search},
        {"half-width from the load", {.plain = inverses}, POINTS, 0},
        {"pressure", {.plain = pressures}, POINTS, 0},
        {"load step and 100 stress points", {.plain = load_steps}, 1000, 0},
        {"yield factor, one load", {NULL, yield_factors, 1, 0}, 100, 0},
        {"yield factor, P and then Q", {NULL, yield_factors, 2, 0}, 100, 0},
        {"yield factor, 251 corners", {NULL, yield_factors, 251, 0}, 1, 0},
        {"load, tension lags, to 1e-3", {NULL, lagging, 1e-3, 0}, 48, 0},
        {"load, tension lags, to 1e-6", {NULL, lagging, 1e-6, 0}, 48, 0},
        {"load of a noisy log, to 1e-3", {NULL, lagging, 1e-3, 0.03}, 48, 0},
        {"load that rocks, to 1e-6", {NULL, rocking, 1e-6, 0}, 12, 0},
        {"load of 100 places, to 1e-3", {NULL, lagging_profile, 1e-3, 0}, 12, 0},
        {"stresses through a cycle, by calls", {.plain = history_by_calls}, LOADS * CYCLES, 0},
        {"stresses through a cycle of Q", {NULL, history, 0, 0}, LOADS * CYCLES, 0},
        {"and of Q and sigma, under M", {NULL, history, 3000, 100}, LOADS * CYCLES, 0},
        {"Smith-Watson-Topper of 40 loads", {.plain = smith_watson_topper}, CYCLES, 0},
        {"Fatemi-Socie of 40 loads", {.plain = fatemi_socie}, CYCLES, 0},
        {"Smith-Watson-Topper, all planes", {NULL, criterion, RWEDGE_MEASURE_SWT, 0}, CYCLES, 0},
        {"Findley of 40 loads", {NULL, criterion, RWEDGE_MEASURE_FINDLEY, 0}, CYCLES, 0},
        {"Crossland of 40 loads", {NULL, criterion, RWEDGE_MEASURE_CROSSLAND, 0}, CYCLES, 0},
        {"damage of 40 loads, by SWT", {.plain = damage}, CYCLES, 0},
    };
    printf("%-34s %12s %12s %12s\n", "ns a call", "this", "plain", "plain / this");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const double time = fastest(rows[i].call, rows[i].n, RUNS);
        printf("%-34s %12.1f", rows[i].name, 1e9 * time);
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

static void print_growth(const char *name, work call, long from, long to, double expected)
{
    printf("%-34s", name);
    for (long n = from; n <= to; n *= 10)
        printf(" %9.1f", 1e9 * fastest(call, n, runs_for(n, expected)));
    printf("\n");
}

static void print_powers(const char *name, int from, int to)
{
    printf("\n%-34s", name);
    for (int k = from; k <= to; k++)
        printf("      10^%d", k);
    printf("\n");
}

int main(int argc, char **argv)
{
    const bool quick = argc > 1 && strcmp(argv[1], "--quick") == 0;
    if (argc > 1 + quick)
        plain_terms = atoi(argv[1 + quick]);
    if (plain_terms < 1 || plain_terms > PLAIN_TERMS_MAX || argc > 2 + quick) {
        fprintf(stderr, "usage: bench [--quick] [TERMS]   1 <= TERMS <= %d\n", PLAIN_TERMS_MAX);
        return 2;
    }
    const long most_points = quick ? 100000 : 10000000, most_limits = quick ? 10000 : 1000000;
    if (!reserve_points(most_points)) {
        fprintf(stderr, "bench: no memory for %ld points\n", most_points);
        release_points();
        return 1;
    }
    make_cycles();
    const double series = fastest((work){.plain = plain_points}, POINTS, RUNS),
                 search = fastest((work){.plain = plain_limits}, 13, quick ? 1 : RUNS);
    print_calls(series, search);
    print_powers("ns a point, points in an array", 3, quick ? 5 : 7);
    print_growth("stress, full sliding", (work){NULL, array_of_points, 0, 0}, 1000, most_points,
                 30e-9);
    print_growth("stress, partial slip", (work){NULL, array_of_points, 0.4, 0}, 1000, most_points,
                 60e-9);
    print_growth("plain series", (work){.plain = plain_points}, 1000, quick ? 100000 : 1000000,
                 series);
    print_powers("ns a limit, limits in an array", 2, quick ? 4 : 6);
    print_growth("elastic limit", (work){.plain = limits_in_array}, 100, most_limits, 6e-6);
    printf("\nThe paper's table of %d elastic limits: %.2f ms; by the plain search: %.0f ms.\n",
           PAPER_LIMITS,
           1e3 * PAPER_LIMITS * fastest((work){.plain = limits_one_by_one}, PAPER_LIMITS, RUNS),
           1e3 * PAPER_LIMITS * search);
    printf("Error of the plain elastic limit at a/b = 0.5, f = 0.6: %.1e\n",
           plain_limit(0.5, 0.6, 0.3, plain_terms) / rwedge_elastic_limit(0.5, 0.6, 0.3) - 1);
    print_histories(quick);
    release_points();
    return 0;
}
