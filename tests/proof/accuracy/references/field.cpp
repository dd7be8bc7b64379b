/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/field.hpp"

ball norm_of(const tensor &s) { return sqrt(sqr(s.xx) + sqr(s.yy) + 2 * sqr(s.xy)); }

tensor tensor_of(const superposition &at) { return {at.s - re(at.D), at.s + re(at.D), im(at.D)}; }

superposition sliding(const sliding_contact &t, const potentials &N)
{
    return superposed(N, t.f * N);
}

/* (2/pi) (phi0/alpha)/X, the points over c in X. */
potentials by_half_width(const patch &p, const complex_ball &point)
{
    const complex_ball z = point / p.half_width, per_X = inv(root(z - 1) * root(z + 1));
    const ball factor = 2 / pi() * p.arc();
    return {factor * per_X, -im(z) * factor * (z * per_X * per_X * per_X)};
}

/* y times the next derivative of G, which is 0 on the surface. */
changes by_x(const patch &p, const complex_ball &z)
{
    const higher_derivatives bends = p.bends(z);
    const ball y = im(z);
    return {{p.slope(z), y * bends.second}, {bends.second, y * bends.third}};
}

/* The derivative of G by y is i times that by x; y itself changes too. */
potentials turned(const potentials &change)
{
    return {times_i(change.G), change.G + times_i(change.H)};
}

/* Products of the superposition and its derivatives. */
J2_jet J2_at(const sliding_contact &t, const complex_ball &z)
{
    const changes by = by_x(t.shape, z);
    const potentials twist = turned(by.second);
    const superposition S = sliding(t, t.shape.at(z)), x = sliding(t, by.first),
                        y = sliding(t, turned(by.first)), xx = sliding(t, by.second),
                        xy = sliding(t, twist), yy = sliding(t, turned(twist));
    const auto product = [&](const superposition &a, const superposition &b) {
        return J2_change(a, b, t.kappa);
    };
    return {J2_of(S, t.kappa),
            product(S, x),
            product(S, y),
            product(x, x) + product(S, xx),
            product(x, y) + product(S, xy),
            product(y, y) + product(S, yy)};
}
