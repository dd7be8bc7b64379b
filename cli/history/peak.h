/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest value of a function between two places. */
#ifndef CLI_PEAK_H
#define CLI_PEAK_H

typedef struct {
    double x, value;
} peak;

/* NAN where it has no value, which no peak is. */
typedef double peak_function(const void *context, double x);

/* The best of the start and of a search between the places, to 1e-10 of their distance. */
peak peak_between(double from, double to, peak start, peak_function *f, const void *context);

#endif
