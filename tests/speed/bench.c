/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Times of the library's calls, in one run.
 *
 *     bench [NAME]     prints the times of the rows whose names begin so, and beside them how many
 *                      times longer others take that the test compares with
 *     bench --test     fails where such a ratio is too small
 *
 * Each time is of the processor, the fastest of several; a busy machine disturbs both sides of a
 * ratio alike, and one good attempt of several is enough. A loop that is no longer made of vector
 * instructions fails every attempt, and so does a search that takes twice the steps. */
#include "works.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { RUNS = 4, ATTEMPTS = 9, SKIPPED = 77 };

/* The slow one takes at least so many times as long as the fast one. Where the library has vectors
 * of four numbers; `by_two` with those of two, which every x86-64 has. */
static const struct {
    int fast, slow;
    double least, by_two; /* 0: the same */
} ratios[] = {
    {ARRAY, SERIES, 4.8, 3.2},      /* seen: 8.4, with two 4.3, without vectors 2.7 */
    {ARRAY_SLIP, SERIES, 2.8, 1.7}, /* 4.8, 2.3 */
    {ARRAY, POINT, 2.5, 1.8},       /* 5.2, by gcc 16 3.1; 2.4; 1.5 */
    {ARRAY_SLIP, POINT_SLIP, 2.5, 1.7},
    {POINT, SERIES, 1, 0},         /* 1.8 */
    {FLAT_PAD, WEDGE, 1 / 2.8, 0}, /* 0.44 */
    {PROFILE, WEDGE, 1 / 50.0, 0}, /* 0.027 */
    {LONG_ARRAY, ARRAY, 0.6, 0},   /* it grows linearly */
    {MANY_LIMITS, LIMIT, 0.7, 0},  /* so does this */
    {LIMIT, SEARCH, 200, 0},       /* 280 */
    {YIELD_TWO, TWO_CORNERS, 1e-4, 0} /* 10000 points. 1.6e-4, once 0.5e-4 */,
    {YIELD_MANY, MANY_CORNERS, 4e-5, 0},            /* 9e-5, once 1.4e-6 */
    {YIELD_OFF_CENTRE, MANY_OFF_CENTRE, 2.5e-5, 0}, /* 5e-5, once 2.4e-6 */
    {LAG, POINT, 1.1e-4, 0},       /* 1.5e-4; 0.8e-4 with a pressure computed anew at each place */
    {NOISY_LOG, POINT, 3.5e-5, 0}, /* 5e-5; 2e-5 */
    {MANY_LOADS, LOADS, 0.12, 0},  /* 0.5; 0.06 where each load goes through all of the memory */
    {CYCLE, CYCLE_BY_CALLS, 1 / 1.2, 0},         /* 2 */
    {SHRINKING, SHRINKING_BY_CALLS, 1 / 1.2, 0}, /* 15; 0.04 where each notes all of the memory */
    {SWT_PLANES, SWT, 0.3, 0}, /* 0.5; 0.06 where all arcs are searched for what is above them */
};
enum { RATIOS = sizeof ratios / sizeof ratios[0] };

static volatile double sink; /* keeps the work from being optimised away */

/* In seconds, of one of the n. */
static double time_of(int row)
{
    const work *w = &works[row];
    double best = HUGE_VAL;
    for (int run = 0; run < RUNS; run++) {
        const clock_t start = clock();
        sink = w->call(w);
        best = fmin(best, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    return best / (double)w->n;
}

static bool has_long_vectors(void)
{
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32)
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

static bool holds(int i)
{
    const double least =
        has_long_vectors() || ratios[i].by_two == 0 ? ratios[i].least : ratios[i].by_two;
    double best = 0;
    for (int attempt = 0; attempt < ATTEMPTS && best < least; attempt++)
        best = fmax(best, time_of(ratios[i].slow) / time_of(ratios[i].fast));
    printf("%s%s / %s: %.2g, at least %.2g\n", best < least ? "FAILED: " : "",
           works[ratios[i].slow].name, works[ratios[i].fast].name, best, least);
    return best >= least;
}

static int test(void)
{
    int broken = 0;
    if (!OPTIMISED_BUILD) { /* as CMake says */
        printf("SKIPPED: this is not a release build\n");
        return SKIPPED;
    }
    for (int i = 0; i < RATIOS; i++)
        broken += !holds(i);
    return broken > 0;
}

static void print_times(const char *name)
{
    printf("%-36s %13s   %s\n", "", "ns a call", "times as long");
    for (int row = 0; row < WORKS; row++) {
        if (strncmp(works[row].name, name, strlen(name)) != 0)
            continue;
        const double seconds = time_of(row);
        printf("%-36s %13.1f", works[row].name, 1e9 * seconds);
        for (int i = 0; i < RATIOS; i++)
            if (ratios[i].fast == row)
                printf("   %s %.3g", works[ratios[i].slow].name, time_of(ratios[i].slow) / seconds);
        printf("\n");
        fflush(stdout);
    }
}

int main(int argc, char **argv)
{
    int status = 1;
    if (!reserve_places())
        fprintf(stderr, "bench: no memory\n");
    else if (argc > 1 && strcmp(argv[1], "--test") == 0)
        status = test();
    else {
        print_times(argc > 1 ? argv[1] : "");
        status = 0;
    }
    release_places();
    return status;
}
