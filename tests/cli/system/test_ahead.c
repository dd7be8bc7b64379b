/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results computed ahead arrive in order, each once, with any number of threads. Several blocks are
 * computed at one time. The caller may stop before it has taken all results.
 * tests/embedding/threads.sh runs this under the thread sanitizer too. */
#define _POSIX_C_SOURCE 200809L

#include "claims.h"
#include "system/system.h"

#include <signal.h>
#include <pthread.h>
#include <time.h>

/* Takes longer for some, so that blocks become ready out of order. */
static void square(const void *context, int64_t i, void *result)
{
    volatile int64_t waste = 0;
    for (int64_t k = 0; k < i % 7 * *(const int *)context; k++)
        waste = waste + k;
    *(int64_t *)result = i * i;
}

CLAIM(results_come_in_order)
{
    static const int64_t counts[] = {0, 1, 31, 32, 33, 100, 1000, 5000};
    const int slowness = 100;
    for (int threads = 1; threads <= 8; threads++)
        for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
            ahead *work = ahead_start(threads, counts[k], sizeof(int64_t), square, &slowness);
            assert_non_null(work);
            for (int64_t i = 0; i < counts[k]; i++)
                assert_true(*(const int64_t *)ahead_next(work) == i * i);
            ahead_stop(work);
        }
}

CLAIM(work_may_be_left)
{
    const int slowness = 10;
    for (int taken = 0; taken < 200; taken += 13) {
        ahead *work = ahead_start(4, INT64_MAX / 2, sizeof(int64_t), square, &slowness);
        assert_non_null(work);
        for (int64_t i = 0; i < taken; i++)
            assert_true(*(const int64_t *)ahead_next(work) == i * i);
        ahead_stop(work);
    }
    ahead_stop(NULL);
}

/* Results that wait until so many of them are being computed at one time. */
typedef struct {
    pthread_mutex_t lock; /* of what follows */
    pthread_cond_t change;
    int expected, waiting;
    bool over, met; /* nobody waits any more; and so because all came */
} meeting;

static void end_meeting(meeting *at, bool met)
{
    at->over = true;
    at->met = met;
    pthread_cond_broadcast(&at->change);
}

static bool meet(meeting *at, const struct timespec *latest)
{
    pthread_mutex_lock(&at->lock);
    if (!at->over && ++at->waiting == at->expected)
        end_meeting(at, true);
    while (!at->over)
        if (pthread_cond_timedwait(&at->change, &at->lock, latest) != 0 && !at->over)
            end_meeting(at, false);
    const bool met = at->met;
    pthread_mutex_unlock(&at->lock);
    return met;
}

enum { PATIENCE = 10 }; /* seconds */

static void meet_others(const void *context, int64_t i, void *result)
{
    (void)i;
    struct timespec latest;
    clock_gettime(CLOCK_REALTIME, &latest);
    latest.tv_sec += PATIENCE;
    *(bool *)result = meet(*(meeting *const *)context, &latest);
}

/* As many blocks at a time as there are threads: none of them waits for a block of another to be
 * computed. */
CLAIM(blocks_are_computed_at_one_time)
{
    enum { COUNT = 1000 };
    for (int threads = 2; threads <= 8; threads *= 2) {
        meeting place = {.lock = PTHREAD_MUTEX_INITIALIZER,
                         .change = PTHREAD_COND_INITIALIZER,
                         .expected = threads};
        meeting *const at = &place;
        int met = 0;
        ahead *work = ahead_start(threads, COUNT, sizeof(bool), meet_others, &at);
        assert_non_null(work);
        for (int i = 0; i < COUNT; i++)
            met += *(const bool *)ahead_next(work) ? 1 : 0;
        ahead_stop(work);
        assert_int_equal(met, COUNT);
    }
}

static void is_interrupt_blocked(const void *context, int64_t i, void *result)
{
    (void)context;
    (void)i;
    sigset_t mask;
    pthread_sigmask(SIG_SETMASK, NULL, &mask);
    *(bool *)result = sigismember(&mask, SIGINT) == 1;
}

CLAIM(threads_leave_signals_to_the_caller)
{
    enum { COUNT = 1000 };
    ahead *work = ahead_start(4, COUNT, sizeof(bool), is_interrupt_blocked, NULL);
    assert_non_null(work);
    for (int i = 0; i < COUNT; i++)
        assert_true(*(const bool *)ahead_next(work));
    ahead_stop(work);
    bool callers;
    is_interrupt_blocked(NULL, 0, &callers);
    assert_false(callers);
}
