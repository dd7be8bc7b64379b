/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A dislocation on a straight line from the surface of the half-plane, which it leaves free of
 * traction. */
#ifndef RW_DISLOCATION_H
#define RW_DISLOCATION_H

#include "base/complex.h"

/* The stress on the line: tension across it, and shear along it with the sign of txy on a normal
 * line. */
typedef struct {
    double normal, shear;
} rw_line_stress;

/* The stress at the distance r from the mouth of a dislocation at the distance t, both along the
 * unit vector `direction` into the half-plane. The density 1 of the first opens the line, that of
 * the second slides along it. r_less_t is given, because r - t would lose digits. */
void rw_dislocation_stresses(rw_complex direction, double r, double t, double r_less_t,
                             rw_line_stress stress[2]);

#endif
