/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With z = sin(zeta), C = cos(zeta) = -i sqrt(z^2-1), S = sin(zeta+phi0) = c0 z + alpha C, over
 * the half-width, and x >= 0 (the other half follows from G(-conj z) = -conj G(z)):
 *
 *     l  = ln(sin(zeta-phi0)/S) = ln(z-alpha) + ln(z+alpha) - 2 ln S,
 *     G  = 1 + (i/pi) [ 2 ln(S/(C+c0)) - (z-alpha) l/alpha - 2 phi0 C/alpha ],
 *     G' = (i/pi) [ 2 phi0 z/(alpha C) - l/alpha ].
 *
 * S and C + c0 have positive real parts there. Hertz: G = (z-iC)/alpha; sharp wedge: G = (2/(pi
 * i)) ln((iC+i)/z). */
#include "balls/patch.hpp"

potentials operator*(const ball &factor, const potentials &p)
{
    return {factor * p.G, factor * p.H};
}

potentials operator+(const potentials &a, const potentials &b) { return {a.G + b.G, a.H + b.H}; }

potentials operator-(const potentials &a, const potentials &b) { return {a.G - b.G, a.H - b.H}; }

superposition superposed(const potentials &N, const potentials &T)
{
    return {im(N.G) - re(T.G), T.G + times_i(T.H) - N.H};
}

ball J2_of(const superposition &at, const ball &kappa)
{
    return dot(at.D, at.D) + kappa * sqr(at.s);
}

ball J2_change(const superposition &at, const superposition &change, const ball &kappa)
{
    return 2 * (dot(at.D, change.D) + kappa * at.s * change.s);
}

patch::patch(const ball &a, const ball &c) : half_width(c), alpha(a / c)
{
    if (a >= c) { /* Hertz */
        phi0 = scaled(pi(), -1);
        return;
    }
    const ball root_of_squares = sqrt((c + a) * (c - a));
    c0 = root_of_squares / c;
    phi0 = atan2(a, root_of_squares);
}

namespace
{

/* ln(-i z) + i pi/2: cut downwards, like root(). */
complex_ball logarithm(const complex_ball &z)
{
    return log(over_i(z)) + complex_ball(0, scaled(pi(), -1));
}

/* The disc, as a square, of all numbers of at most the modulus bound. */
complex_ball disc(const ball &bound)
{
    const ball side = widened(0, bound);
    return complex_ball(side, side);
}

/* What multiplies a logarithm or 1/C, and whether its modulus stays below the distance from
 * where these are infinite: that of the depth does, and of z - alpha, but not that of 1. */
struct factor {
    complex_ball value;
    bool vanishes;
};

/* by * ln z. Where z may be 0: r (|ln r| + 5) bounds |z ln z| for |z| <= r <= 1/e, as |arg z| <=
 * 3 pi/2. */
complex_ball times_logarithm(const factor &by, const complex_ball &z)
{
    if (!by.vanishes || !contains_zero(z))
        return by.value * logarithm(z);
    const ball r = upper_bound(z);
    if (is_zero(r))
        return 0;
    if (middle(r) > 0.36)
        return complex_ball(unknown(), unknown());
    return disc((5 - log(r)) * r);
}

/* A point of the right half over the half-width, and what all formulas are made of. */
struct place {
    const patch &on;
    const bool mirrored;
    const complex_ball z, before, beyond; /* z, z - alpha, z - 1 */
    const complex_ball plus_root;         /* sqrt(z+1) */
    const complex_ball C;

    place(const patch &p, const complex_ball &point)
        : on(p), mirrored(sign(re(point)) < 0), z(right_half(point / p.half_width)),
          before(z - p.alpha), beyond(z - 1), plus_root(root(z + 1)),
          C(over_i(root(beyond) * plus_root))
    {
    }

    complex_ball logarithm_of_S() const { return log(z * on.c0 + C * on.alpha); }

    /* by * l. */
    complex_ball times_l(const factor &by, const complex_ball &ln_S) const
    {
        return by.value * (logarithm(z + on.alpha) - 2 * ln_S) + times_logarithm(by, before);
    }

    /* by/C. Where z may be 1: |y/sqrt(z-1)| <= sqrt|z-1|. */
    complex_ball over_C(const factor &by) const
    {
        if (!by.vanishes || !contains_zero(beyond))
            return by.value / C;
        return disc(sqrt(upper_bound(beyond))) / plus_root;
    }

  private:
    complex_ball right_half(const complex_ball &point) const
    {
        if (!on.is_hertz() && !(on.alpha < 1)) /* it may be either formula's */
            return complex_ball(unknown(), unknown());
        return mirrored ? -conj(point) : point;
    }
};

complex_ball rounded_potential(const place &at)
{
    const patch &p = at.on;
    const complex_ball ln_S = at.logarithm_of_S();
    const complex_ball by_arc = at.times_l({at.before, true}, ln_S) + 2 * at.C * p.phi0;
    return i_over_pi(2 * (ln_S - log(at.C + p.c0)) - by_arc / p.alpha) + 1;
}

/* The real part of C + 1 is positive. */
complex_ball sharp_potential(const place &at)
{
    return i_over_pi(-2 * (log(at.C + 1) - logarithm(at.z))) + 1; /* ln i */
}

/* by * G' of the half-width 1. */
complex_ball times_slope(const factor &by, const place &at)
{
    const patch &p = at.on;
    const complex_ball edge = at.over_C(by);
    if (p.is_hertz()) /* G' = (1 + i z/C)/alpha */
        return (times_i(edge * at.z) + by.value) / p.alpha;
    if (p.is_sharp()) /* G' = (2 i/pi)/(z C) */
        return i_over_pi(2 * edge / at.z);
    return i_over_pi((2 * edge * at.z * p.phi0 - at.times_l(by, at.logarithm_of_S())) / p.alpha);
}

/* Adds the part A of G'' and its derivatives, A' = -z r A and A'' = (z^2 r^2 - r + 2 z^2 t) A,
 * where r and t are the same combination of 1/X^2, 1/q and of their squares: r' = -2 z t. */
void add_part(higher_derivatives *sum, const complex_ball &A, const complex_ball &z,
              const complex_ball &r, const complex_ball &t)
{
    sum->second += A;
    sum->third -= z * r * A;
    sum->fourth += ((2 * t + sqr(r)) * sqr(z) - r) * A;
}

} // namespace

complex_ball patch::potential(const complex_ball &z) const
{
    const place at(*this, z);
    const complex_ball G = is_hertz()   ? (at.z - times_i(at.C)) / alpha
                           : is_sharp() ? sharp_potential(at)
                                        : rounded_potential(at);
    return at.mirrored ? -conj(G) : G;
}

complex_ball patch::slope(const complex_ball &z) const
{
    const place at(*this, z);
    const complex_ball dG = times_slope({1, false}, at) / half_width;
    return at.mirrored ? conj(dG) : dG;
}

complex_ball patch::depth_slope(const complex_ball &z) const
{
    const place at(*this, z);
    const complex_ball H = times_slope({im(at.z), true}, at);
    return at.mirrored ? conj(H) : H;
}

potentials patch::at(const complex_ball &z) const { return {potential(z), depth_slope(z)}; }

/* With q = z^2-alpha^2, X^2 = z^2-1 over the half-width, and the two parts A = c0/(X q), B =
 * phi0/(alpha X^3) of
 *
 *     G'' = (2/pi) (A + B),     A'/A = -z (1/X^2 + 2/q),     B'/B = -3 z/X^2,
 *
 * all derivatives are algebraic. */
higher_derivatives patch::bends(const complex_ball &point) const
{
    higher_derivatives sum;
    const complex_ball z = point / half_width;
    const complex_ball per_X = inv(root(z - 1) * root(z + 1)), per_X2 = sqr(per_X);
    add_part(&sum, per_X * per_X2 * arc(), z, 3 * per_X2, 3 * sqr(per_X2));
    if (!is_hertz()) { /* which has no corners */
        const complex_ball per_q = inv((z - alpha) * (z + alpha));
        add_part(&sum, per_X * per_q * c0, z, 2 * per_q + per_X2, 2 * sqr(per_q) + sqr(per_X2));
    }
    const ball factor = 2 / pi() / sqr(half_width);
    return {sum.second * factor, sum.third * (factor / half_width),
            sum.fourth * (factor / sqr(half_width))};
}
