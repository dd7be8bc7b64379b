/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Times that hold on a busy machine: of the processor, not of the wall, and the fastest of
 * several. */
#ifndef STOPWATCH_H
#define STOPWATCH_H

/* Something to do, n times, plainly or with two numbers; it returns a number that depends on all of
 * it. */
typedef struct {
    double (*plain)(long n);
    double (*with)(double first, double second, long n);
    double first, second;
} work;

/* Processor time in seconds that one of the n takes, the fastest of `runs` runs. */
double fastest(work task, long n, int runs);

#endif
