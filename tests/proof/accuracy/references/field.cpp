/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/field.hpp"

#include "references/root.hpp"

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
    const ball factor = 2 / pi() * (p.is_sharp() ? 1 : p.phi0 / p.alpha);
    return {factor * per_X, -im(z) * factor * (z * per_X * per_X * per_X)};
}

namespace
{

/* J2 and its derivatives by x and y. */
struct J2_jet {
    ball J2, x, y, xx, xy, yy;
};

/* In full sliding: products of the superposition and its derivatives. Those by y are i times those
 * by x, and that of the y in y G'. */
J2_jet J2_at(const sliding_contact &t, const complex_ball &z)
{
    const complex_ball d = t.shape.slope(z);
    const higher_derivatives bends = t.shape.bends(z);
    const complex_ball &dd = bends.second, bend = im(z) * dd, third = im(z) * bends.third;
    const superposition S = sliding(t, t.shape.at(z)), x = sliding(t, {d, bend}),
                        y = sliding(t, {times_i(d), d + times_i(bend)}),
                        xx = sliding(t, {dd, third}),
                        xy = sliding(t, {times_i(dd), dd + times_i(third)}),
                        yy = sliding(t, {-dd, 2 * times_i(dd) - third});
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

} // namespace

/* ---- Its stationary points ---- */

bool find_stationary(extremum *at, const sliding_contact &t, double x, double y)
{
    column place;
    const auto gradient = [&](const column &z) -> residual {
        const J2_jet J = J2_at(t, {z.x, z.y});
        return {{J.x, J.y}, {J.xx, J.xy, J.xy, J.yy}};
    };
    if (!find_zero(&place, {x, y}, y, gradient))
        return false;
    const J2_jet J = J2_at(t, {place.x, place.y});
    const ball scale = sqr(place.y) / J.J2, size = hypot(hypot(J.xx, J.yy), J.xy);
    const ball flatness = abs(J.xx * J.yy - sqr(J.xy)) / size * scale;
    *at = {place.x, place.y, J.J2, middle(flatness)};
    return true;
}
