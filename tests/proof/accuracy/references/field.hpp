/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in ball arithmetic, from the potentials of the pressure and of the shear traction.
 * Natural units. */
#ifndef FIELD_HPP
#define FIELD_HPP

#include "balls/patch.hpp"

/* In full sliding, of half-width 1. */
struct sliding_contact {
    ball a, f, kappa; /* rounding; friction; (1-2nu)^2/3 */
    patch shape;

    sliding_contact(const ball &alpha, const ball &friction, double nu)
        : a(alpha), f(friction), kappa(sqr(2 * ball(nu) - 1) / 3), shape(alpha, 1)
    {
    }
};

struct tensor {
    ball xx, yy, xy;
};

/* sqrt(xx^2 + yy^2 + 2 xy^2) */
ball norm_of(const tensor &s);

tensor tensor_of(const superposition &at);

/* The shear traction is f times the pressure. */
superposition sliding(const sliding_contact &t, const potentials &N);

/* How the potentials of a patch change with x, to the first and to the second derivative; and by y
 * what changes so by x. */
struct changes {
    potentials first, second;
};

changes by_x(const patch &p, const complex_ball &z);
potentials turned(const potentials &change);

/* c d/dc of a patch pressed to the half-width c. */
potentials by_half_width(const patch &p, const complex_ball &z);

/* J2 in full sliding, and its derivatives. */
struct J2_jet {
    ball J2, x, y, xx, xy, yy;
};

J2_jet J2_at(const sliding_contact &t, const complex_ball &z);

#endif
