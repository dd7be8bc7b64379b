/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Yield at the surface: the maximum of J2 over y = 0 in full sliding. */
#ifndef RW_SURFACE_H
#define RW_SURFACE_H

/* A maximum of J2, in (theta/A)^2, and where it is, in b. */
typedef struct {
    double J2, x, y;
} rw_maximum;

/* alpha in (0, 1]; the contact beyond is that of alpha = 1, with stresses 1/alpha of it. */
rw_maximum rw_surface_maximum(double alpha, double f, double kappa);

#endif
