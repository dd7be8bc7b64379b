/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load of a wedge at which the peak of sqrt(J2), in theta/A, is what the material bears. */
#ifndef RW_LIMIT_LOAD_H
#define RW_LIMIT_LOAD_H

/* The peak grows as alpha falls, and is proportional to 1/alpha from 1 on. For alpha = 0 it is
 * asked where it is finite, for f = 0 with nu = 0.5. */
typedef struct {
    double (*peak)(double alpha, double f, double nu);
    double smallest_tip; /* the smallest alpha > 0 that may be asked */
    double nearest;      /* the absolute error of ln(alpha) */
} rw_limit;

/* HUGE_VAL where no load reaches it, or no alpha that may be asked; NaN outside the domain. */
double rw_limit_load(const rw_limit *limit, double theta, double a, double A, double f, double nu,
                     double k);

#endif
