/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results computed ahead. Threads take blocks of indices in turn, and put the results into a ring
 * of blocks. The caller empties the ring. Without threads the caller computes each block itself. */
#include "system.h"

#include "text/text.h"

#include <pthread.h>
#include <stdlib.h>

enum {
    /* indices; a result takes some microseconds, to hand over a block about one */
    BLOCK = 32,
    BLOCKS_A_THREAD = 4, /* of the ring */
};

struct ahead {
    ahead_work *compute;
    const void *context;
    int64_t count;
    size_t size;

    int64_t next; /* the caller's */

    pthread_mutex_t lock; /* of what follows */
    pthread_cond_t room, progress;
    int64_t begun, freed; /* blocks that threads have taken, and that the caller is done with */
    bool *ready;          /* blocks of the ring */
    bool stopped;

    int slots; /* blocks of the ring */
    char *results;
    int threads;
    pthread_t thread[AHEAD_THREADS_MAX];
};

static int64_t blocks_of(int64_t count)
{
    return count / BLOCK + (count % BLOCK > 0);
}

static char *result_at(const ahead *work, int64_t i)
{
    const int64_t slot = i / BLOCK % work->slots * BLOCK + i % BLOCK;
    return work->results + (size_t)slot * work->size;
}

static void compute_block(const ahead *work, int64_t block)
{
    for (int64_t i = block * BLOCK; i < work->count && i < (block + 1) * BLOCK; i++)
        work->compute(work->context, i, result_at(work, i));
}

/* The next block to compute, when there is room for it; -1 where there is none left. Under the
 * lock. */
static int64_t take_block(ahead *work)
{
    while (!work->stopped && work->begun < blocks_of(work->count) &&
           work->begun >= work->freed + work->slots)
        pthread_cond_wait(&work->room, &work->lock);
    return work->stopped || work->begun >= blocks_of(work->count) ? -1 : work->begun++;
}

static void *run_thread(void *context)
{
    ahead *work = context;
    pthread_mutex_lock(&work->lock);
    for (int64_t block = take_block(work); block >= 0; block = take_block(work)) {
        pthread_mutex_unlock(&work->lock);
        compute_block(work, block);
        pthread_mutex_lock(&work->lock);
        work->ready[block % work->slots] = true;
        pthread_cond_signal(&work->progress);
    }
    pthread_mutex_unlock(&work->lock);
    return NULL;
}

static void start_threads(ahead *work, int threads)
{
    signals_hold();
    while (work->threads < threads &&
           pthread_create(&work->thread[work->threads], NULL, run_thread, work) == 0)
        work->threads++;
    signals_release();
}

/* The one whose threads run; NULL for none. */
static ahead *running;

/* No thread goes on while the command ends. */
static void stop_running(void)
{
    ahead_stop(running);
}

static void prepare(void)
{
    static bool is_prepared;
    if (!is_prepared && atexit(stop_running) != 0)
        failure("out of memory");
    is_prepared = true;
}

ahead *ahead_start(int threads, int64_t count, size_t size, ahead_work *compute,
                   const void *context)
{
    if (threads > blocks_of(count)) /* no thread without work */
        threads = count > 0 ? (int)blocks_of(count) : 1;
    prepare();
    const int slots = threads * BLOCKS_A_THREAD;
    ahead *work = memory_zeroed(1, sizeof *work);
    *work = (ahead){.compute = compute,
                    .context = context,
                    .count = count,
                    .size = size,
                    .ready = memory_zeroed((size_t)slots, sizeof *work->ready),
                    .slots = slots,
                    .results = memory_zeroed((size_t)slots * BLOCK, size)};
    pthread_mutex_init(&work->lock, NULL);
    pthread_cond_init(&work->room, NULL);
    pthread_cond_init(&work->progress, NULL);
    if (threads > 1)
        start_threads(work, threads);
    running = work;
    return work;
}

/* The caller is done with all blocks before this one. */
static void wait_for_block(ahead *work, int64_t block)
{
    if (work->threads == 0) {
        compute_block(work, block);
        return;
    }
    pthread_mutex_lock(&work->lock);
    if (block > 0)
        work->ready[(block - 1) % work->slots] = false;
    work->freed = block;
    pthread_cond_broadcast(&work->room);
    while (!work->ready[block % work->slots])
        pthread_cond_wait(&work->progress, &work->lock);
    pthread_mutex_unlock(&work->lock);
}

const void *ahead_next(ahead *work)
{
    const int64_t i = work->next++;
    if (i % BLOCK == 0)
        wait_for_block(work, i / BLOCK);
    return result_at(work, i);
}

void ahead_stop(ahead *work)
{
    if (work == NULL)
        return;
    pthread_mutex_lock(&work->lock);
    work->stopped = true;
    pthread_cond_broadcast(&work->room);
    pthread_mutex_unlock(&work->lock);
    for (int i = 0; i < work->threads; i++)
        pthread_join(work->thread[i], NULL);
    pthread_cond_destroy(&work->progress);
    pthread_cond_destroy(&work->room);
    pthread_mutex_destroy(&work->lock);
    free(work->results);
    free(work->ready);
    free(work);
    running = NULL;
}
