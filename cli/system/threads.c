/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Threads take blocks of indices in turn, and the caller takes its share. */
#include "system.h"

#include <pthread.h>

typedef struct {
    threads_work *compute;
    void *context;
    int64_t count, block;
    pthread_mutex_t lock; /* of what follows */
    int64_t next;         /* that no thread has taken */
} shared;

static int64_t take_block(shared *work)
{
    pthread_mutex_lock(&work->lock);
    const int64_t first = work->next;
    work->next += work->block;
    pthread_mutex_unlock(&work->lock);
    return first;
}

static void *compute_blocks(void *of_shared)
{
    shared *work = of_shared;
    for (int64_t first = take_block(work); first < work->count; first = take_block(work))
        for (int64_t i = first; i < first + work->block && i < work->count; i++)
            work->compute(work->context, i);
    return NULL;
}

void threads_run(int threads, int64_t count, threads_work *compute, void *context)
{
    enum { MOST = 32 }; /* indices of a block: some take a microsecond, as to take a block does */
    pthread_t thread[THREADS_MAX];
    const int64_t share = count / (4 * threads);
    shared work = {compute,
                   context,
                   count,
                   share < 1 ? 1 : share < MOST ? share : MOST,
                   PTHREAD_MUTEX_INITIALIZER,
                   0};
    int started = 0;
    signals_hold();
    while (started + 1 < threads && started + 1 < count &&
           pthread_create(&thread[started], NULL, compute_blocks, &work) == 0)
        started++;
    signals_release();
    compute_blocks(&work);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_mutex_destroy(&work.lock);
}
