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
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { RUNS = 4, ATTEMPTS = 9, SKIPPED = 77 };

/* The slow one takes at least so many times as long as the fast one. Where the library has vectors
 * of four numbers; `by_two` with those of two, which every x86-64 has. */
static const struct {
    const char *fast, *slow;
    double least, by_two; /* 0: the same */
} ratios[] = {
    /* seen: with vectors of eight numbers 15, without vectors 3.8 */
    {"stress in an array, full sliding", "stress by the series of 60 terms", 6.4, 4.3},
    /* 9, 1.9 */
    {"stress in an array, partial slip", "stress by the series of 60 terms", 3.7, 2.3},
    /* 5.2, by gcc 16 3.1; 2.4; 1.5 */
    {"stress in an array, full sliding", "stress at a point, full sliding", 2.5, 1.8},
    {"stress in an array, partial slip", "stress at a point, partial slip", 2.5, 1.7},
    /* 2.6 */
    {"stress at a point, full sliding", "stress by the series of 60 terms", 1.3, 0},
    /* 0.44, where the processor has faster vectors 0.31; 0.027, 0.02 */
    {"stress in an array, of a flat pad", "stress after P and then Q", 1 / 4.5, 0},
    {"stress in an array, 99 arcs", "stress after P and then Q", 1 / 75.0, 0},
    /* unlike bodies. 0.24, with shorter vectors 0.3; 0.22; 0.23; 0.3 */
    {"stress in an array, unlike bodies", "stress in an array, of a contact", 1 / 8.0, 0},
    {"stress at a point, unlike bodies", "stress at a point, of a contact", 1 / 8.0, 0},
    {"yield factor, unlike bodies", "yield factor, sliding", 1 / 8.0, 0},
    {"shakedown factor, unlike bodies", "shakedown factor, sliding", 1 / 8.0, 0},
    /* 0.2: a search, as a yield factor is */
    {"elastic limit, unlike bodies", "yield factor, sliding", 1 / 8.0, 0},
    /* 4: two roots */
    {"largest tension, unlike bodies", "elastic limit, cold", 1, 0},
    /* they grow linearly */
    {"stress in an array of 10^6", "stress in an array, full sliding", 0.6, 0},
    {"elastic limit, 2600 of them", "elastic limit, cold", 0.7, 0},
    /* 0.024, 0.02 */
    {"elastic limit, cold", "stress at a point, full sliding", 1 / 85.0, 0},
    /* 1/15, with vectors of four numbers 1/20, of two 1/30 */
    {"shakedown limit", "elastic limit, cold", 1 / 30.0, 1 / 36.0},
    /* 10000 points. 1.6e-4, 1.2e-4, once 0.5e-4; 9e-5, once 1.4e-6; 5e-5, once 2.4e-6 */
    {"yield factor, P and then Q", "stress after P and then Q", 8e-5, 0},
    {"yield factor, 250 corners", "stress, 250 corners", 4e-5, 0},
    {"yield factor, off the centre", "stress, 250 corners off the centre", 2.5e-5, 0},
    /* 1.2e-3, with vectors of two 8e-4; 5e-4, 3e-4 */
    {"load, tension lags, to 1e-3", "stress at a point, full sliding", 7e-4, 5e-4},
    {"load of a noisy log, to 1e-3", "stress at a point, full sliding", 2.7e-4, 2e-4},
    /* 0.5; 0.06 where each load goes through all of the memory */
    {"load that grows, of 40000", "load that grows, of 2000", 0.12, 0},
    /* 0.1; 0.03 where each place adds up all elements */
    {"stresses of a computed state", "stress in an array, of a contact", 0.06, 0},
    {"the same, along the surface", "stress in an array, of a contact", 0.06, 0},
    /* 2 */
    {"stresses through a cycle of Q", "stresses through a cycle, by calls", 1 / 1.2, 0},
    /* 15; 0.04 where each notes all of the memory */
    {"2 points, 2000 corners, in one call", "2 points, 2000 corners, by calls", 1 / 1.2, 0},
    /* 0.9; 0.75 where sums of 18 rows end beside whole vectors. The rest: weights, and the sums */
    {"K of those cracks", "stresses on the lines of cracks", 1 / 1.2, 0},
    /* 0.5; 0.1 without the inverse of the openings */
    {"K of those cracks, faces press", "K of those cracks", 0.15, 0},
    /* 0.4; 4e-4 */
    {"bounds of a cycle's shakedown", "yield factor, off the centre", 0.15, 0},
    {"end of wear", "stress at a point, full sliding", 1.5e-4, 0},
    /* 0.5; 0.06 where all arcs are searched for what is above them */
    {"Smith-Watson-Topper, all planes", "Smith-Watson-Topper of 40 loads", 0.3, 0},
    /* 0.3; 0.02 where most places are searched over the sphere */
    {"Findley of 40 loads", "Smith-Watson-Topper, all planes", 0.08, 0},
};
enum { RATIOS = sizeof ratios / sizeof ratios[0] };

static volatile double sink; /* keeps the work from being optimised away */

static const work *named(const char *name)
{
    for (size_t i = 0; i < works_count; i++)
        if (strcmp(works[i].name, name) == 0)
            return &works[i];
    fprintf(stderr, "bench: no row \"%s\"\n", name);
    exit(1);
}

/* In seconds, of one of the n. */
static double time_of(const work *w)
{
    double best = HUGE_VAL;
    for (int run = 0; run < RUNS; run++) {
        const clock_t start = clock();
        sink = w->call(w);
        best = fmin(best, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    return best / (double)w->n;
}

/* How many times longer the slow one takes. */
static double ratio(int i)
{
    return time_of(named(ratios[i].slow)) / time_of(named(ratios[i].fast));
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
        best = fmax(best, ratio(i));
    printf("%s%s / %s: %.2g, at least %.2g\n", best < least ? "FAILED: " : "", ratios[i].slow,
           ratios[i].fast, best, least);
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
    for (const work *w = works; w < works + works_count; w++) {
        if (strncmp(w->name, name, strlen(name)) != 0)
            continue;
        printf("%-36s %13.1f", w->name, 1e9 * time_of(w));
        for (int i = 0; i < RATIOS; i++)
            if (strcmp(ratios[i].fast, w->name) == 0)
                printf("   %s %.3g", ratios[i].slow, ratio(i));
        printf("\n");
        fflush(stdout);
    }
}

int main(int argc, char **argv)
{
    set_places();
    if (argc > 1 && strcmp(argv[1], "--test") == 0)
        return test();
    print_times(argc > 1 ? argv[1] : "");
    return 0;
}
