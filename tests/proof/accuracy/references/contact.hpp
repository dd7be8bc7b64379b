/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CONTACT_HPP
#define CONTACT_HPP
#include "references/ball.hpp"
extern "C" {
#include "references/balls.h"
}
struct angle {
    ball phi0, c0;
};
inline angle angle_of(const ball &a, const ball &b)
{
    angle r;
    ball_angle(r.phi0.arb(), r.c0.arb(), a.arb(), b.arb(), bits);
    return r;
}
inline ball force(const ball &a, const ball &b)
{
    return rounded(ball_force, a, b);
}
inline ball half_width(const ball &a, const ball &f, double guess)
{
    ball r;
    ball_half_width(r.arb(), a.arb(), f.arb(), guess, bits);
    return r;
}
inline ball pressure(const ball &a, const ball &c, const ball &x)
{
    return rounded(ball_pressure, a, c, x);
}
#endif
