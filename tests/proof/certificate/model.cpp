/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.hpp"

#include <float.h>
#include <initializer_list>
#include <math.h>

/* No value here has gone through more than some twenty roundings, each of at most DBL_EPSILON/2
 * of a sum of terms that the bounds contain, up to four times over. */
static const double ROUNDING = 64 * DBL_EPSILON;

static double linear_bound(const model &m)
{
    return fabs(m.x) + fabs(m.y);
}

static double square_bound(const model &m)
{
    return fabs(m.xx) + fabs(m.xy) + fabs(m.yy);
}

double model_bound(const model &m)
{
    return (fabs(m.one) + linear_bound(m) + square_bound(m) + m.rest) * (1 + ROUNDING);
}

model operator*(const model &a, const model &b)
{
    const double la = linear_bound(a), lb = linear_bound(b), sa = square_bound(a),
                 sb = square_bound(b);
    const double whole_a = fabs(a.one) + la + sa, whole_b = fabs(b.one) + lb + sb;
    const double cut_off = la * sb + sa * lb + sa * sb;
    const double from_rests = a.rest * (whole_b + b.rest) + whole_a * b.rest;
    return {a.one * b.one,
            a.one * b.x + a.x * b.one,
            a.one * b.y + a.y * b.one,
            a.one * b.xx + a.x * b.x + a.xx * b.one,
            a.one * b.xy + a.x * b.y + a.y * b.x + a.xy * b.one,
            a.one * b.yy + a.y * b.y + a.yy * b.one,
            (cut_off + from_rests + ROUNDING * whole_a * whole_b) * (1 + ROUNDING)};
}

model model_combination(int terms, const double *weight, const model *term)
{
    model sum = {};
    double rest = 0, rounded = 0;
    for (int i = 0; i < terms; i++) {
        const double w = weight[i];
        const model &t = term[i];
        sum.one += w * t.one;
        sum.x += w * t.x;
        sum.y += w * t.y;
        sum.xx += w * t.xx;
        sum.xy += w * t.xy;
        sum.yy += w * t.yy;
        rest += fabs(w) * t.rest;
        rounded += fabs(w) * (fabs(t.one) + linear_bound(t) + square_bound(t));
    }
    sum.rest = (rest + ROUNDING * rounded) * (1 + ROUNDING);
    return sum;
}

model operator*(double weight, const model &a)
{
    return model_combination(1, &weight, &a);
}

model operator+(const model &a, const model &b)
{
    static const double BOTH[] = {1, 1};
    const model terms[] = {a, b};
    return model_combination(2, BOTH, terms);
}

model operator-(const model &a, const model &b)
{
    return a + -1 * b;
}

struct peak {
    double value, at;
};

/* The maximum of one + b t + a t^2 over [-1, 1]. */
static peak edge_peak(double one, double b, double a)
{
    if (a < 0 && fabs(b) < -2 * a)
        return {one - b * b / (4 * a), -b / (2 * a)};
    return {one + fabs(b) + a, b < 0 ? -1.0 : 1.0};
}

static summit higher(summit a, summit b)
{
    return a.value > b.value ? a : b;
}

/* The polynomial's maximum on the square's boundary. */
static summit boundary_summit(const model &m)
{
    summit best = {-HUGE_VAL, 0, 0};
    for (const double side : {-1.0, 1.0}) {
        const peak along_x = edge_peak(m.one + side * m.y + m.yy, m.x + side * m.xy, m.xx);
        const peak along_y = edge_peak(m.one + side * m.x + m.xx, m.y + side * m.xy, m.yy);
        best = higher(best, {along_x.value, along_x.at, side});
        best = higher(best, {along_y.value, side, along_y.at});
    }
    return best;
}

static const double DOUBT = 1e-12; /* of the determinant, relatively; its rounding is 1e-15 */

/* 4 times the determinant of the Hessian's half. */
static double determinant(const model &m)
{
    return 4 * m.xx * m.yy - m.xy * m.xy;
}

/* True: the polynomial is concave for sure. False: with yy larger by 2 DOUBT of itself it is surely
 * not concave, and has its maximum on the boundary. */
static bool is_concave(const model &m)
{
    return m.xx < 0 && m.yy < 0 && determinant(m) > DOUBT * (4 * m.xx * m.yy);
}

double model::at(double xi, double eta) const
{
    return one + x * xi + y * eta + xx * xi * xi + xy * xi * eta + yy * eta * eta;
}

summit model_summit(const model &m)
{
    if (is_concave(m)) {
        const double xi = (m.xy * m.y - 2 * m.yy * m.x) / determinant(m);
        const double eta = (m.xy * m.x - 2 * m.xx * m.y) / determinant(m);
        if (fabs(xi) <= 1 && fabs(eta) <= 1)
            return {m.at(xi, eta), xi, eta};
    }
    return boundary_summit(m);
}

/* A concave function lies below its tangent plane at any point: the plane's maximum over the
 * square. */
static double tangent_bound(const model &m, summit at)
{
    const double slope_x = m.x + 2 * m.xx * at.xi + m.xy * at.eta;
    const double slope_y = m.y + 2 * m.yy * at.eta + m.xy * at.xi;
    return m.at(at.xi, at.eta) + fabs(slope_x) - slope_x * at.xi + fabs(slope_y) - slope_y * at.eta;
}

double model_maximum(const model &m)
{
    const double bound = model_bound(m);
    if (!(bound < HUGE_VAL)) /* nor if it is not a number */
        return HUGE_VAL;
    const double slack = m.rest * (1 + ROUNDING) + 2 * DOUBT * square_bound(m) + ROUNDING * bound;
    const summit top = model_summit(m);
    return (is_concave(m) ? tangent_bound(m, top) : top.value) + slack;
}
