/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The smallest peak of sqrt(J2) at a depth that residual stresses can leave. */
#ifndef RW_LEAST_PEAK_H
#define RW_LEAST_PEAK_H

#include "shakedown/pass.h"

typedef struct {
    double peak;  /* in theta/A */
    double slope; /* d peak/dy times y; 0 at the surface */
} rw_least_peak;

/* From a grid alone: not above the exact one, and below it by less than 5 %. */
double rw_least_peak_coarse(const rw_pass *pass, double y);

/* Relative error of the peak below 1e-11, if no two tops of the path are closer than two steps of
 * rw_pass_sample(). */
rw_least_peak rw_least_peak_at(const rw_pass *pass, double y, double step);

#endif
