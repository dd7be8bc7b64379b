/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every function may be called from any number of threads, and many threads may read a handle at
 * a time. Two and eight threads each do all of the work with the same handles. They give the bits
 * that one thread gives. threads.sh runs this under the thread sanitizer too, which also sees
 * accesses that do not show in a result.
 *
 *     test_threads [NUMBERS]     how many arguments of each function */
#define _POSIX_C_SOURCE 200809L

#include "claims.h"
#include "every_function.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { THREADS_MAX = 8 };
static int numbers = 8;
static int most; /* results of one number */
static shared_handles shared;

/* The results of one thread, with the same room at each number. */
typedef struct {
    double *values;
    int first, number; /* where the thread begins, and is */
    int count;         /* of the results of this number */
    pthread_barrier_t *start;
} results;

static void count(void *context, const char *function, bool is_status, double value)
{
    (void)function, (void)is_status, (void)value;
    ++*(int *)context;
}

static void count_most(void)
{
    for (int i = 0; i < numbers; i++) {
        int here = 0;
        every_function(&shared, i, count, &here);
        most = here > most ? here : most;
    }
}

static void keep(void *context, const char *function, bool is_status, double value)
{
    (void)function, (void)is_status;
    results *r = context;
    if (r->count < most)
        r->values[r->number * most + r->count] = value;
    r->count++;
}

static void *evaluate(void *context)
{
    results *r = context;
    pthread_barrier_wait(r->start);
    for (int i = 0; i < numbers; i++) {
        r->number = (r->first + i) % numbers;
        r->count = 0;
        every_function(&shared, r->number, keep, r);
    }
    return NULL;
}

/* Threads begin at different numbers, so that different arguments meet. */
static void run_threads(int count, results r[])
{
    pthread_t thread[THREADS_MAX];
    pthread_barrier_t start;
    assert_int_equal(pthread_barrier_init(&start, NULL, (unsigned)count), 0);
    for (int i = 0; i < count; i++) {
        r[i] = (results){.values = calloc((size_t)(numbers * most), sizeof(double)),
                         .first = i * numbers / count,
                         .start = &start};
        assert_non_null(r[i].values);
        assert_int_equal(pthread_create(&thread[i], NULL, evaluate, &r[i]), 0);
    }
    for (int i = 0; i < count; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    pthread_barrier_destroy(&start);
}

static void assert_same_results(const results *expected, const results *actual)
{
    assert_true(actual->count >= 1 && actual->count <= most);
    assert_memory_equal(actual->values, expected->values,
                        (size_t)(numbers * most) * sizeof(double));
}

CLAIM(threads_give_the_bits_of_one)
{
    results alone, r[THREADS_MAX];
    count_most();
    run_threads(1, &alone);
    for (int count = 2; count <= THREADS_MAX; count *= 4) {
        run_threads(count, r);
        for (int i = 0; i < count; i++) {
            assert_same_results(&alone, &r[i]);
            free(r[i].values);
        }
    }
    free(alone.values);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        numbers = atoi(argv[1]);
    if (numbers < 1 || !shared_create(&shared))
        return 2;
    const int status = run_claims();
    shared_destroy(&shared);
    return status;
}
