/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every function may be called from any number of threads, and many threads may read a handle at
 * a time. Two and eight threads each do all of the work with the same handles. They give the bits
 * that one thread gives. thread_sanitizer.sh runs this under the thread sanitizer too, which also
 * sees accesses that do not show in a result.
 *
 *     test_threads [NUMBERS]     how many arguments of each function */
#define _POSIX_C_SOURCE 200809L

#include "calls.h"
#include "claims.h"

#include <pthread.h>
#include <stdlib.h>

enum { THREADS_MAX = 8, ARRAY = 21 };
static int numbers;

/* The results of one thread: outputs of each call at each number. */
typedef struct {
    double (*out)[CALL_OUTPUTS];
    int first; /* where the thread begins */
    pthread_barrier_t *start;
} results;

static void evaluate_number(int number, double out[][CALL_OUTPUTS])
{
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        double v[CALL_ARGUMENTS];
        uint64_t state = (uint64_t)number << 32;
        int32_t status;
        draw_inside(&calls[i], &state, v);
        complaint_of(&calls[i], v, out[i], &status); /* without a result all are marked */
    }
}

static void *evaluate(void *context)
{
    const results *r = context;
    pthread_barrier_wait(r->start);
    for (int i = 0; i < numbers; i++) {
        const int number = (r->first + i) % numbers;
        evaluate_number(number, r->out + (size_t)number * ENTRY_COUNT);
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
        r[i] = (results){.out = calloc((size_t)numbers * ENTRY_COUNT, sizeof *r[i].out),
                         .first = i * numbers / count,
                         .start = &start};
        assert_non_null(r[i].out);
        assert_int_equal(pthread_create(&thread[i], NULL, evaluate, &r[i]), 0);
    }
    for (int i = 0; i < count; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    pthread_barrier_destroy(&start);
}

CLAIM(threads_give_the_bits_of_one)
{
    results alone, r[THREADS_MAX];
    numbers = (int)cases_or(4);
    array_size = ARRAY;
    run_threads(1, &alone);
    for (int count = 2; count <= THREADS_MAX; count *= 4) {
        run_threads(count, r);
        for (int i = 0; i < count; i++) {
            assert_memory_equal(r[i].out, alone.out,
                                (size_t)numbers * ENTRY_COUNT * sizeof *alone.out);
            free(r[i].out);
        }
    }
    free(alone.out);
}
