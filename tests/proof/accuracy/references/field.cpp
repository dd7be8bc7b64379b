/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/field.hpp"

/* ---- Stresses: s = Im N - Re T, D = -y N' + i y T' + T, sxx, syy = s -+ Re D, txy = Im D ---- */

ball norm_of(const tensor &s) { return sqrt(sqr(s.xx) + sqr(s.yy) + 2 * sqr(s.xy)); }

tensor stresses_at(const traction &t, const complex_ball &z)
{
    complex_ball N, H, T, H_T;
    for (const traction::part &p : t.parts) {
        const bool whole = &p == &t.parts.back();
        if (is_zero(p.weight) && !whole)
            continue;
        const complex_ball G = p.shape.potential(z), depth_slope = p.shape.depth_slope(z);
        T += t.f * p.weight * G;
        H_T += t.f * p.weight * depth_slope;
        if (whole && !t.shear_alone) {
            N = G;
            H = depth_slope;
        }
    }
    const complex_ball D = T + times_i(H_T) - H;
    const ball s = im(N) - re(T);
    return {s - re(D), s + re(D), im(D)};
}

/* ---- J2 = |D|^2 + kappa s^2 ---- */

namespace
{

/* A potential and its derivatives. */
struct jet {
    complex_ball G, d, dd, ddd;
};

jet jet_of(const patch &p, const complex_ball &z, int order)
{
    jet j = {p.potential(z), p.slope(z), {}, {}};
    if (order > 0) {
        const higher_derivatives bends = p.bends(z);
        j.dd = bends.second;
        j.ddd = bends.third;
    }
    return j;
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
J2_jet J2_at(const traction &t, const complex_ball &z, int order)
{
    jet N, T;
    for (const traction::part &p : t.parts)
        if (!is_zero(p.weight) || &p == &t.parts.back()) {
            N = jet_of(p.shape, z, order); /* that of the whole is the last */
            add(&T, t.f * p.weight, N);
        }
    const ball y = im(z), s = im(N.G) - re(T.G);
    const complex_ball D = y * (times_i(T.d) - N.d) + T.G;
    J2_jet J;
    J.J2 = dot(D, D) + t.kappa * sqr(s);
    if (order == 0)
        return J;
    const complex_ball bend = y * (times_i(T.dd) - N.dd), Dx = bend + T.d,
                       Dy = times_i(bend + 2 * T.d) - N.d;
    const ball sx = im(N.d) - re(T.d), sy = re(N.d) + im(T.d);
    J.x = 2 * (dot(D, Dx) + t.kappa * s * sx);
    J.y = 2 * (dot(D, Dy) + t.kappa * s * sy);
    if (order == 1)
        return J;
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

namespace
{

struct matrix {
    double xx, xy, yy;
};

/* The inverse of the Hessian at the middle, in lengths of the depth; any numbers near it serve. */
bool invert(matrix *inverse, const J2_jet &J, double depth, double *flatness)
{
    const double scale = depth * depth / middle(J.J2);
    const double xx = middle(J.xx) * scale, xy = middle(J.xy) * scale, yy = middle(J.yy) * scale;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant != 0 && isfinite(determinant)))
        return false;
    /* the smaller curvature, but for a factor of 2 */
    *flatness = fabs(determinant) / hypot(hypot(xx, yy), xy);
    *inverse = {yy / determinant * scale, -xy / determinant * scale, xx / determinant * scale};
    return true;
}

/* Krawczyk's operator about the middle of the box, step = K - middle: it contains middle - step
 * of every stationary point of the box; and where K lies inside the box, there is one. */
struct krawczyk {
    complex_ball centre;
    J2_jet at_centre, over_box;
    ball x, y; /* the step */
    double flatness = 0;
    bool is_regular;

    krawczyk(const traction &t, const complex_ball &box)
        : centre(midpoint(box)), at_centre(J2_at(t, centre, 1)), over_box(J2_at(t, box, 2))
    {
        matrix inverse = {}; /* Y */
        is_regular = invert(&inverse, over_box, middle(im(centre)), &flatness);
        if (!is_regular)
            return;
        const complex_ball reach = box - centre;
        x = row(inverse.xx, inverse.xy, {1, 0}, reach);
        y = row(inverse.xy, inverse.yy, {0, 1}, reach);
        is_regular = is_finite(x) && is_finite(y);
    }

    complex_ball moved() const { return centre + complex_ball(x, y); }

  private:
    /* -Y g + (1 - Y H)(box - middle) */
    ball row(double Yx, double Yy, const complex_ball &unit, const complex_ball &reach) const
    {
        const J2_jet &g = at_centre, &H = over_box;
        return (re(unit) - Yx * H.xx - Yy * H.xy) * re(reach) +
               (im(unit) - Yx * H.xy - Yy * H.yy) * im(reach) - Yx * g.x - Yy * g.y;
    }
};

/* Newton's method without proof. */
complex_ball improved(const traction &t, const complex_ball &guess)
{
    complex_ball z = guess;
    for (int i = 0; i < 12; i++) {
        const double depth = middle(im(z));
        const krawczyk step(t, z);
        const double length = hypot(middle(step.x), middle(step.y));
        if (!step.is_regular || !(length < 0.5 * depth))
            break;
        z = midpoint(step.moved());
        if (length < ldexp(depth, -(int)bits / 2))
            break;
    }
    return z;
}

} // namespace

bool find_stationary(extremum *at, const traction &t, double x, double y)
{
    const complex_ball z = improved(t, {x, y});
    const double depth = middle(im(z));
    for (slong n = bits / 2; n > 0; n -= bits / 12) {
        const ball width = ldexp(depth, -(int)n);
        const krawczyk step(t, {widened(re(z), width), widened(im(z), width)});
        if (!step.is_regular || !(abs(step.x) < width && abs(step.y) < width))
            continue;
        /* Taylor about the middle m: J2(m + d) in J2(m) + g d + d H d/2, d in the step */
        const ball d = widened(0, max(abs(step.x), abs(step.y))), dd = d * d;
        const J2_jet &m = step.at_centre, &H = step.over_box;
        *at = {re(step.moved()), im(step.moved()),
               m.J2 + m.x * d + m.y * d + H.xx * dd + H.xy * dd + H.yy * dd, step.flatness};
        return true;
    }
    return false;
}
