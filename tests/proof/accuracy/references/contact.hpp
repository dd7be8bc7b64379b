/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The formulas of one contact in ball arithmetic, from the paper. */
#ifndef CONTACT_HPP
#define CONTACT_HPP

#include "balls/patch.hpp"

/* The half-width b > 0 of that force; guess is near it, and only a guess. Unknown where it is too
 * far off. */
ball half_width(const ball &a, const ball &wanted, double guess);

/* A p/theta at |x| < c, pressed to the half-width c: the potential on the surface; 0 beyond. */
ball pressure(const ball &a, const ball &c, const ball &x);

#endif
