/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Threads compute results ahead; the caller takes them one by one, in their order. Memory does not
 * grow with the number of results, and the results do not depend on the number of threads. */
#ifndef CLI_AHEAD_H
#define CLI_AHEAD_H

#include <stddef.h>
#include <stdint.h>

enum { AHEAD_THREADS_MAX = 256 };

/* Computes the result of index i. It is called by several threads at a time. */
typedef void ahead_work(const void *context, int64_t i, void *result);

typedef struct ahead ahead;

/* Starts to compute the results 0 to count - 1. Each takes `size` bytes; the context must stay.
 * Where the system gives fewer threads, those do the work. Only one such computation may run at a
 * time. */
ahead *ahead_start(int threads, int64_t count, size_t size, ahead_work *compute,
                   const void *context);

/* The next result. It stays until the next call. To be called at most count times. */
const void *ahead_next(ahead *work);

/* Ends the threads, whatever is left to do, as the end of the command does. NULL is allowed. */
void ahead_stop(ahead *work);

#endif
