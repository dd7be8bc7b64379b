/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formulas of one contact in ball arithmetic, from the paper. */
#ifndef CONTACT_HPP
#define CONTACT_HPP

#include "balls/ball.hpp"

/* phi0 and c0 = cos(phi0), sin(phi0) = min(a/b, 1). */
struct angle {
    ball phi0, c0;
};

angle angle_of(const ball &a, const ball &b);

/* A P/theta of a contact of half-width b, Eq. (7), (11), (15): (b^2 phi0 + a sqrt(b^2-a^2))/a. */
ball force(const ball &a, const ball &b);

/* The half-width b > 0 of that force; guess is near it, and only a guess. Unknown where it is too
 * far off. */
ball half_width(const ball &a, const ball &wanted, double guess);

/* A p/theta at |x| < c, pressed to the half-width c: the potential on the surface; 0 beyond. */
ball pressure(const ball &a, const ball &c, const ball &x);

#endif
