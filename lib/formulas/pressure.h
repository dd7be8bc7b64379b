/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure of a patch: the same profile pressed to another half-width. */
#ifndef RW_PRESSURE_H
#define RW_PRESSURE_H

/* A p/theta at x of the profile of rounding a >= 0 pressed to the half-width c > 0, lengths in
 * one unit; a/c finite, and x not the apex of the sharp wedge. Where two of a, c and x are nearly
 * equal, their difference counts; quotients would lose its digits. */
double rw_patch_pressure(double a, double c, double x);

#endif
