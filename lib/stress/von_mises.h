/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The yield criterion in full sliding, J2 = |D|^2 + kappa s^2 with kappa = (1-2nu)^2/3, and its
 * derivatives. */
#ifndef RW_VON_MISES_H
#define RW_VON_MISES_H

#include "stress/derivatives.h"

typedef struct {
    double J2;
    double x, y;             /* first derivatives, times y */
    double xx, xy, yy;       /* second derivatives, times y^2 */
    double f_x, f_y;         /* derivatives of x, y with respect to f, */
    double kappa_x, kappa_y; /* and to kappa */
} rw_von_mises;

/* kappa from Poisson's ratio; 0 where nu = 1/2. */
double rw_plane_strain_weight(double nu);

/* J2 and its derivatives at x >= 0, y > 0. */
rw_von_mises rw_von_mises_at(const rw_potential *potential, double f, double kappa, double x,
                             double y);

/* The derivatives of J2 at (x, y), y >= 0, by friction, by kappa, and by the rounding where x/a and
 * y/a stay. Not at the edge of the contact. */
typedef struct {
    double J2;
    double f, kappa;
    double rounding; /* alpha d/dalpha */
} rw_von_mises_change;

rw_von_mises_change rw_von_mises_change_at(const rw_potential *potential, double f, double kappa,
                                           double x, double y);

#endif
