/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results computed ahead by threads, and taken one by one in their order: as fast as the machine
 * has processors, in memory that does not grow with their number, and the same whatever the
 * number of threads. */
#ifndef CLI_AHEAD_H
#define CLI_AHEAD_H

#include <stddef.h>
#include <stdint.h>

enum { AHEAD_THREADS_MAX = 256 };

/* How many threads the machine can run at a time. */
int ahead_processors(void);

/* Computes the result of index i. It is called by several threads at a time. */
typedef void ahead_work(const void *context, int64_t i, void *result);

typedef struct ahead ahead;

/* Begins with indices 0 to count - 1, each of whose results takes `size` bytes; context must
 * stay. Threads that cannot be had are done without. NULL, with a message, where memory is
 * short. */
ahead *ahead_start(int threads, int64_t count, size_t size, ahead_work *compute,
                   const void *context);

/* The next result; it stays until the call after it. At most count times. */
const void *ahead_next(ahead *work);

/* Ends the threads, whatever is left to do. NULL is allowed. */
void ahead_stop(ahead *work);

#endif
