/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/field.hpp"

#include "references/root.hpp"

ball norm_of(const tensor &s) { return sqrt(sqr(s.xx) + sqr(s.yy) + 2 * sqr(s.xy)); }

tensor tensor_of(const superposition &at) { return {at.s - re(at.D), at.s + re(at.D), im(at.D)}; }

tensor stresses_at(const traction &t, const complex_ball &z)
{
    potentials N, T;
    for (const traction::part &p : t.parts) {
        const bool whole = &p == &t.parts.back();
        if (is_zero(p.weight) && !whole)
            continue;
        const potentials at = p.shape.at(z);
        T.G += t.f * p.weight * at.G;
        T.H += t.f * p.weight * at.H;
        if (whole && !t.shear_alone)
            N = at;
    }
    return tensor_of(superposed(N, T));
}

/* (2/pi) (phi0/alpha)/X, the points over c in X. */
potentials by_half_width(const patch &p, const complex_ball &point)
{
    const complex_ball z = point / p.half_width, per_X = inv(root(z - 1) * root(z + 1));
    const ball factor = 2 / pi() * (p.is_sharp() ? 1 : p.phi0 / p.alpha);
    return {factor * per_X, -im(z) * factor * (z * per_X * per_X * per_X)};
}

/* ---- J2 = |D|^2 + kappa s^2 ---- */

namespace
{

/* J2 and its derivatives by x and y. */
struct J2_jet {
    ball J2, x, y, xx, xy, yy;
};

/* A potential and its derivatives. */
struct jet {
    complex_ball G, d, dd, ddd;
};

jet jet_of(const patch &p, const complex_ball &z)
{
    const higher_derivatives bends = p.bends(z);
    return {p.potential(z), p.slope(z), bends.second, bends.third};
}

void add(jet *sum, const ball &weight, const jet &j)
{
    sum->G += weight * j.G;
    sum->d += weight * j.d;
    sum->dd += weight * j.dd;
    sum->ddd += weight * j.ddd;
}

} // namespace

/* d = i d/dx of what is analytic in z, and the explicit y; all products of derivatives of D and
 * of s. */
static J2_jet J2_at(const traction &t, const complex_ball &z)
{
    jet N, T;
    for (const traction::part &p : t.parts)
        if (!is_zero(p.weight) || &p == &t.parts.back()) {
            N = jet_of(p.shape, z); /* that of the whole is the last */
            add(&T, t.f * p.weight, N);
        }
    const ball y = im(z), s = im(N.G) - re(T.G);
    const complex_ball D = y * (times_i(T.d) - N.d) + T.G;
    J2_jet J;
    J.J2 = dot(D, D) + t.kappa * sqr(s);
    const complex_ball bend = y * (times_i(T.dd) - N.dd), Dx = bend + T.d,
                       Dy = times_i(bend + 2 * T.d) - N.d;
    const ball sx = im(N.d) - re(T.d), sy = re(N.d) + im(T.d);
    J.x = 2 * (dot(D, Dx) + t.kappa * s * sx);
    J.y = 2 * (dot(D, Dy) + t.kappa * s * sy);
    const complex_ball third = y * (times_i(T.ddd) - N.ddd), Dxx = third + T.dd,
                       Dxy = times_i(third + 2 * T.dd) - N.dd,
                       Dyy = -third - 2 * times_i(N.dd) - 3 * T.dd;
    const ball sxx = im(N.dd) - re(T.dd), sxy = re(N.dd) + im(T.dd);
    J.xx = 2 * (dot(Dx, Dx) + dot(D, Dxx) + t.kappa * (sqr(sx) + s * sxx));
    J.xy = 2 * (dot(Dx, Dy) + dot(D, Dxy) + t.kappa * (sx * sy + s * sxy));
    J.yy = 2 * (dot(Dy, Dy) + dot(D, Dyy) + t.kappa * (sqr(sy) - s * sxx));
    return J;
}

/* ---- Its stationary points ---- */

bool find_stationary(extremum *at, const traction &t, double x, double y)
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
