/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _POSIX_C_SOURCE 199309L

#include "stopwatch.h"

#include <math.h>
#include <time.h>

static volatile double sink; /* keeps the work from being optimised away */

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double fastest(work task, long n, int runs)
{
    double best = HUGE_VAL;
    for (int run = 0; run < runs; run++) {
        const double start = seconds();
        sink = task.plain ? task.plain(n) : task.with(task.first, task.second, n);
        best = fmin(best, seconds() - start);
    }
    return best / (double)n;
}
