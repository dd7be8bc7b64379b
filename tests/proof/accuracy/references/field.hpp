/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses in ball arithmetic, from the potentials of the pressure and of the shear traction:
 * one is the contact's own, the other a sum of patches. Natural units, but lengths in any. */
#ifndef FIELD_HPP
#define FIELD_HPP

#include <deque>

#include "references/complex_ball.hpp"

/* A rounded wedge pressed to a half-width: G, G' and y G' of ball_potential.h. */
class patch
{
    ball_patch v;

  public:
    patch(const ball &a, const ball &c) { ball_patch_init(&v, a.arb(), c.arb(), bits); }
    ~patch() { ball_patch_clear(&v); }
    patch(const patch &) = delete;
    patch &operator=(const patch &) = delete;

    ball half_width() const { return ball::copy(v.half_width); }
    ball alpha() const { return ball::copy(v.alpha); }
    ball c0() const { return ball::copy(v.c0); }
    ball phi0() const { return ball::copy(v.phi0); }

    complex_ball potential(const complex_ball &z) const { return at(ball_potential, z); }
    complex_ball slope(const complex_ball &z) const { return at(ball_potential_slope, z); }
    complex_ball depth_slope(const complex_ball &z) const
    {
        return at(ball_potential_slope_by_depth, z);
    }

  private:
    template <typename Function> complex_ball at(Function f, const complex_ball &z) const
    {
        complex_ball result;
        f(result.acb(), &v, z.acb(), bits);
        return result;
    }
};

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

/* A potential and its derivatives; those of the second and third order where order > 0. */
struct jet {
    complex_ball G, d, dd, ddd;
};

jet jet_of(const patch &p, const complex_ball &z, int order);

struct tensor {
    ball xx, yy, xy;
};

/* sqrt(xx^2 + yy^2 + 2 xy^2) */
ball norm_of(const tensor &s);

tensor stresses_at(const traction &t, const complex_ball &z);

/* J2 and its derivatives by x and y, y > 0; as many of them as orders 0, 1, 2 have. */
struct J2_jet {
    ball J2, x, y, xx, xy, yy;
};

J2_jet J2_at(const traction &t, const complex_ball &z, int order);

/* A stationary point of J2. flatness is the smallest curvature times y^2 over J2. */
struct extremum {
    ball x, y, J2;
    double flatness;
};

/* The one next to (x, y), y > 0. False where none is proved. */
bool find_stationary(extremum *at, const traction &t, double x, double y);

#endif
