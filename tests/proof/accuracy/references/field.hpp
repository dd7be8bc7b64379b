/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in ball arithmetic, from the potentials of the pressure and of the shear traction:
 * one is the contact's own, the other a sum of patches. Natural units, but lengths in any. */
#ifndef FIELD_HPP
#define FIELD_HPP

#include <deque>

#include "balls/patch.hpp"

/* The last patch is the contact; f times the weights times the patches' pressures make the shear
 * traction. */
struct traction {
    struct part {
        patch shape;
        ball weight;

        part(const ball &a, const ball &c, const ball &w) : shape(a, c), weight(w) {}
    };

    ball a, f, kappa;         /* rounding; friction; (1-2nu)^2/3 */
    bool shear_alone = false; /* the shear traction without the pressure; for stresses_at() */
    std::deque<part> parts;

    traction(const ball &rounding, const ball &friction, double nu)
        : a(rounding), f(friction), kappa(sqr(2 * ball(nu) - 1) / 3)
    {
    }
    void add(const ball &half_width, const ball &weight)
    {
        parts.emplace_back(a, half_width, weight);
    }
    const patch &whole() const { return parts.back().shape; }
};

struct tensor {
    ball xx, yy, xy;
};

/* sqrt(xx^2 + yy^2 + 2 xy^2) */
ball norm_of(const tensor &s);

tensor tensor_of(const superposition &at);
tensor stresses_at(const traction &t, const complex_ball &z);

/* In full sliding, f times the pressure. */
superposition sliding(const traction &t, const potentials &N);

/* c d/dc of a patch pressed to the half-width c. */
potentials by_half_width(const patch &p, const complex_ball &z);

/* A stationary point of J2. flatness is the smallest curvature times y^2 over J2. */
struct extremum {
    ball x, y, J2;
    double flatness;
};

/* The one next to (x, y), y > 0. False where none is proved. */
bool find_stationary(extremum *at, const traction &t, double x, double y);

#endif
