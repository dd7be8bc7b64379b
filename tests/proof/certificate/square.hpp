/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential of one contact over squares of the half-plane, lengths in b, stresses in
 * theta/A. */
#ifndef SQUARE_HPP
#define SQUARE_HPP

#include "balls/patch.hpp"
#include "model.hpp"

struct square {
    double x, y, half; /* centre and half a side; y >= half */
};

/* G = u + iv and y G' = p + iq over a square. Rests are infinite where there is no enclosure:
 * split it. */
struct field {
    model u, v, p, q;
};

field field_over(const patch &c, square s);

/* J2 at a point, in balls, for the friction f and kappa = (1-2nu)^2/3. */
ball J2_at(const patch &c, const complex_ball &z, const ball &f, const ball &kappa);

/* An upper bound of J2 wherever it is farther than the distance from the contact -1 <= x <= 1. */
ball far_J2(const patch &c, double distance, const ball &f, const ball &kappa);

/* The largest double below all of the ball. */
double lower_bound(const ball &x);

#endif
