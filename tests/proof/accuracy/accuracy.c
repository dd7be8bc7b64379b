/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The accuracy of every function of the library: certified errors at random arguments, as a
 * table in Markdown.
 *
 *     accuracy [calls [seed [function]]]
 *
 * The exit status is 1 if an error exceeds what the header promises. If the header promises
 * nothing, the bound of the row counts. The figures depend only on calls and seed. */
#include <float.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "rows/rows.h"

enum { BLOCK = 64, THREADS_MAX = 64 };

static const row *const SECTIONS[] = {
    LAW_ROWS,       STICK_ROWS,           STRESS_ROWS,  STRENGTH_ROWS, DESIGN_ROWS, HISTORY_ROWS,
    ECCENTRIC_ROWS, ECCENTRIC_FIELD_ROWS, MEASURE_ROWS, PLANE_ROWS,    LIFE_ROWS,   SERIES_ROWS};

/* ---- Measuring: the threads take blocks of calls ---- */

typedef struct {
    const row *claim;
    uint64_t seed;
    size_t count, next;
    pthread_mutex_t lock;
    double *errors;
} work;

static size_t take_block(work *w)
{
    pthread_mutex_lock(&w->lock);
    const size_t begin = w->next;
    w->next += BLOCK;
    pthread_mutex_unlock(&w->lock);
    return begin;
}

static void *take_part(void *context)
{
    work *w = context;
    for (size_t begin; (begin = take_block(w)) < w->count;)
        for (size_t i = begin; i < begin + BLOCK && i < w->count; i++) {
            probe call;
            w->errors[i] = probe_error(w->claim, w->seed, i, &call);
            probe_release(&call);
        }
    flint_cleanup();
    return NULL;
}

static size_t count_processors(void)
{
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online > THREADS_MAX ? THREADS_MAX : (size_t)online;
}

static void measure(work *w)
{
    pthread_t threads[THREADS_MAX];
    size_t started = 0;
    while (started + 1 < count_processors() &&
           pthread_create(&threads[started], NULL, take_part, w) == 0)
        started++;
    take_part(w);
    while (started-- > 0)
        pthread_join(threads[started], NULL);
}

/* ---- Reporting ---- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_call(FILE *stream, const probe *call, const char *format)
{
    for (int i = 0; i < call->arguments; i++) {
        fprintf(stream, "%s%s=", i ? " " : "", call->name[i]);
        fprintf(stream, format, call->value[i]);
    }
}

/* What reproduces a call: all digits, and the loads of a history. */
static void print_breach(const row *claim, const probe *call, double error)
{
    fprintf(stderr, "%s: error %.3g, bound %.3g at ", claim->function, error, claim->promised);
    print_call(stderr, call, "%.17g");
    for (int i = 0; i < call->loads; i++)
        fprintf(stderr, " (%.17g, %.17g)", call->P[i], call->Q[i]);
    for (int i = 0; i < RESULTS_MAX && call->result[i] != 0; i++)
        fprintf(stderr, "%s%.17g", i ? ", " : " -> ", call->result[i]);
    fprintf(stderr, "\n");
}

/* Whether the promise was kept. */
static bool report(const row *claim, size_t calls, uint64_t seed)
{
    const double wanted = ceil((double)calls * claim->part);
    work w = {
        .claim = claim, .seed = seed, .count = (size_t)wanted, .lock = PTHREAD_MUTEX_INITIALIZER};
    w.errors = malloc(w.count * sizeof *w.errors);
    if (!w.errors) {
        fprintf(stderr, "out of memory\n");
        exit(EXIT_FAILURE);
    }
    measure(&w);
    size_t worst = 0;
    for (size_t i = 1; i < w.count; i++)
        if (w.errors[i] > w.errors[worst])
            worst = i;
    const double error = w.errors[worst];
    qsort(w.errors, w.count, sizeof *w.errors, ascending);
    const double usual = w.errors[(w.count - 1) * 999 / 1000];
    free(w.errors);
    probe call;
    probe_error(claim, seed, worst, &call);
    const bool kept = error <= claim->promised;
    printf("| `%s` | %s | %zu | %.3g | %.3g | %.1e %s | %s%s | ", claim->function, claim->domain,
           w.count, error / DBL_EPSILON, usual / DBL_EPSILON, error, claim->measure, claim->promise,
           kept ? "" : " **broken**");
    print_call(stdout, &call, "%.4g");
    printf(" |\n");
    fflush(stdout);
    if (!kept)
        print_breach(claim, &call, error);
    probe_release(&call);
    return kept;
}

int main(int count, char *arguments[])
{
    const double calls = count > 1 ? strtod(arguments[1], NULL) : 2000;
    const uint64_t seed = count > 2 ? strtoull(arguments[2], NULL, 10) : 1;
    if (!(calls >= 1 && calls <= 1e9)) {
        fprintf(stderr, "usage: accuracy [calls [seed [function]]]\n");
        return 2;
    }
    bool kept = true, found = false;
    printf("| `rwedge_` | domain sampled | calls | worst, eps | 99.9 %%, eps | worst, and of what "
           "| promised | worst at |\n"
           "|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof SECTIONS / sizeof SECTIONS[0]; i++)
        for (const row *claim = SECTIONS[i]; claim->function; claim++)
            if (count < 4 || strstr(claim->function, arguments[3])) {
                found = true;
                kept &= report(claim, (size_t)calls, seed);
            }
    flint_cleanup();
    if (!found) {
        fprintf(stderr, "accuracy: no row has \"%s\" in its first column\n", arguments[3]);
        return 2;
    }
    return kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
