/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of life over a parameter: sums of two powers of the number of reversals. */
#ifndef RW_LIFE_H
#define RW_LIFE_H

#include <stdbool.h>

/* first (2N)^slope + second (2N)^other; a run-out below the limit. */
typedef struct {
    double height[2], slope[2], limit; /* heights: the logarithms of first and second */
} rw_life_curve;

/* Whether the constants are in their domains; sets the curve if they are. */
bool rw_smith_watson_topper_curve(double E, double sf, double b, double ef, double c, double limit,
                                  rw_life_curve *curve);
bool rw_fatemi_socie_curve(double G, double tf, double b, double gf, double c, double limit,
                           rw_life_curve *curve);

/* Cycles to failure at a value, which is 0 or positive: HUGE_VAL for a run-out and beyond 1e60, NaN
 * below 1e-60. */
double rw_life(const rw_life_curve *curve, double value);

#endif
