/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Times that hold on a busy machine: of the processor, not of the wall, and the fastest of
 * several. */
#ifndef STOPWATCH_H
#define STOPWATCH_H

/* Something to do, n times; returns a number that depends on all of it. */
typedef double (*work)(long n);

/* Processor time in seconds that one of the n takes, the fastest of `runs` runs. */
double fastest(work what, long n, int runs);

#endif
