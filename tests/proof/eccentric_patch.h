/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure of the rounded wedge on a patch off its centre, in closed form, written for the
 * tests. Lengths in a, stresses in theta/A, the tilt in theta. */
#ifndef ECCENTRIC_PATCH_H
#define ECCENTRIC_PATCH_H

/* The patch middle - half < x < middle + half. */
typedef struct {
    double middle, half;
} eccentric_patch;

/* What presses it: load, moment about x = 0, tilt. */
typedef struct {
    double P, M, tilt;
} patch_loads;

patch_loads eccentric_loads(eccentric_patch patch);

/* Negative inside, 0 outside. */
double eccentric_pressure(eccentric_patch patch, double x);

/* The patch of a load and moment, of a load and tilt; fails the test where none is found. */
eccentric_patch patch_of_moment(double P, double M);
eccentric_patch patch_of_tilt(double P, double tilt);

#endif
