/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maxima of J2 of one contact in full sliding, natural units, alpha <= 1: enclosed by
 * Newton's method next to where the library says they are. That each is the global one is not
 * shown here. */
#ifndef STRENGTH_HPP
#define STRENGTH_HPP

#include "references/field.hpp"

/* Of J2; unknown where none is proved. flatness is the smallest curvature times y^2 over J2; on the
 * surface it is the curvature over J2, by the angle whose sine is x/alpha. */
struct extremum {
    ball x, y, J2;
    double flatness;
};

/* The one next to (x, y): a stationary point, or the maximum over the surface where y is 0. */
extremum extremum_near(const sliding_contact &t, double x, double y);

/* P/(bk) of that maximum. */
ball limit_of(const ball &alpha, const ball &J2);

#endif
