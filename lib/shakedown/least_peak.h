/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest peak of sqrt(J2) at a depth that residual stresses can leave. */
#ifndef RW_LEAST_PEAK_H
#define RW_LEAST_PEAK_H

#include "shakedown/tops.h"

#include <stdbool.h>

/* The ball: its centre, on txy = 0, and the places that touch it or nearly do; those without a
 * weight do not. */
typedef struct {
    double peak;  /* in theta/A */
    double slope; /* d peak/dy times y; 0 at the surface */
    double centre[2];
    int n;
    double t[RW_TOPS], weight[RW_TOPS];
} rw_least_peak;

/* The least peak from a grid alone: not above the exact one, and below it by less than 5 %. */
double rw_least_peak_coarse(const rw_pass *pass, double y);

/* Relative error of the peak below 1e-11, if no two tops of the path are closer than two steps of
 * rw_pass_sample(). */
rw_least_peak rw_least_peak_at(const rw_pass *pass, double y, double step);

/* The same at another depth, from the places that touch at one near it, without a grid: the path
 * may leave this ball elsewhere. False where Newton's method does not converge. */
bool rw_least_peak_follows(const rw_least_peak *from, const rw_pass *pass, double y,
                           rw_least_peak *peak);

/* An upper bound of the peak as the grid sees it: the farthest place from the centre that is known.
 * It is the known peak where that is right. */
double rw_least_peak_checked(const rw_least_peak *known, const rw_pass *pass, double y,
                             double step);

#endif
