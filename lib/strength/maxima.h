/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maxima of J2 in full sliding. */
#ifndef RW_MAXIMA_H
#define RW_MAXIMA_H

#include <stdbool.h>

/* A maximum of J2, in (theta/A)^2, and where it is, in b. */
typedef struct {
    double J2, x, y;
} rw_maximum;

/* The maximum over y = 0. alpha in (0, 1]; the contact beyond is that of alpha = 1, with stresses
 * 1/alpha of it. */
rw_maximum rw_surface_maximum(double alpha, double f, double kappa);

/* The local maximum at y > 0. False where there is none; *maximum is then untouched. */
bool rw_subsurface_maximum(double alpha, double f, double kappa, rw_maximum *maximum);

#endif
