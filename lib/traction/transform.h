/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The displacement and the field that a traction t causes, in closed form of its elements:
 *     Omega(z) = (1/pi) int t/(s - z) ds,   w(x) = -(1/pi) int t ln|s - x| ds,   w' = Re Omega.
 * With z = end + scale zeta^2 an element of the Legendre coefficients c_k has
 *     int t/(s - z) ds = -2 sum c_k [Q_k(v+) + Q_k(v-)],   v+- = (2 (+-zeta) - first - last)/(last
 * - first) times the sign of the scale, with Legendre's functions of the second kind. The
 * potential is that of the primitive, integrated by parts. Far from an element Gauss's rule on it
 * is as accurate. */
#ifndef RW_TRANSFORM_H
#define RW_TRANSFORM_H

#include "traction/traction.h"
#include "potential/batch.h"

/* Re Omega at a place of the surface, a principal value where there is traction. */
double rw_traction_slope(const rw_traction *traction, double x);

/* w at a place of the surface, up to a constant that depends on the unit of length. */
double rw_traction_displacement(const rw_traction *traction, double x);

/* Sets w at n <= RW_TERMS places, quicker than one by one. That of a place does not depend on the
 * others. */
void rw_traction_displacements(const rw_traction *traction, size_t n, const double x[], double w[]);

/* Omega and y Omega' at n <= RW_BATCH places; on the surface, Omega + i t and 0. What a place has
 * does not depend on the others. It is quick where the traction has its clusters, and so is the
 * displacement. */
void rw_traction_fields(const rw_traction *traction, int n, const double x[], const double y[],
                        rw_fields *fields);

#endif
