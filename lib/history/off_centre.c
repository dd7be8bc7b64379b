/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Outside a patch, on its right, with x = m + s cosh(w), X = sinh(w), and of each end of the
 * rounding omega = the angle of (1 - t cosh(w), c sinh(w)), which is 0 at the edge and has the
 * derivative c/(cosh(w) - t), the gap is an integral of
 *
 *     slope = g - delta - G
 *           = (1/(pi alpha)) [ 2 h X + (cosh(w) - t_0) omega_0 - (cosh(w) - t_1) omega_1 ]
 *
 * that has a closed form, but for both ends outside and beyond them. Next to the edge that cancels,
 * and the slope is integrated instead. h is half the angle between the ends (patch.h); ends outside
 * at the left have omega = 0, and ends at the right none: there the profile goes on with the
 * rounding, and beyond x = a the slope is 1 - delta - G. */
#include "history/off_centre.h"

#include "base/always.h"
#include "base/integral.h"
#include "base/logarithm.h"
#include "stress/eccentric.h"

/* ---- The gap, on the right of a patch ---- */

typedef struct {
    double a, m, s, delta;
    rw_corners ends;
    double clear[2]; /* 1 - t, exactly */
    bool flank;      /* lies outside of the patch */
    rw_eccentric potential;
} outside;

/* cosh(w) - 1 */
static double cosh_less_1(double w)
{
    const double half = sinh(w / 2);
    return 2 * half * half;
}

/* omega of an end, 0 for one that is not inside. */
static double omega(const outside *o, int end, double w)
{
    if (!o->ends.is_inside[end])
        return 0;
    return rw_angle(o->clear[end] - o->ends.sine[end] * cosh_less_1(w),
                    o->ends.cosine[end] * sinh(w));
}

/* (omega_0 - omega_1)/alpha, both ends inside. */
static double omega_difference(const outside *o, double w)
{
    const rw_corners *k = &o->ends;
    const double X = sinh(w), C = cosh(w);
    const double x0 = o->clear[0] - k->sine[0] * cosh_less_1(w),
                 x1 = o->clear[1] - k->sine[1] * cosh_less_1(w);
    const double x = x0 * x1 + k->cosine[0] * k->cosine[1] * X * X;
    const double y_over = 2 * k->sin_half_over * X * (k->sin_middle - C * k->cos_half);
    return rw_angle_over(x, y_over, k->alpha, k->per_alpha);
}

static bool is_rounded(const outside *o)
{
    return o->ends.is_inside[0] && o->ends.is_inside[1];
}

/* Times pi/2. */
static double slope(double w, const void *context)
{
    const outside *o = context;
    const rw_corners *k = &o->ends;
    const double X = sinh(w), C = cosh(w);
    double sum;
    if (is_rounded(o) && k->per_alpha == 0)
        sum = omega(o, 0, w);
    else if (is_rounded(o))
        sum = k->half_over * X + (C - k->sine[1]) * omega_difference(o, w) / 2 + omega(o, 0, w);
    else
        sum = k->half_over * X +
              ((C - k->sine[0]) * omega(o, 0, w) - (C - k->sine[1]) * omega(o, 1, w)) *
                  k->per_alpha / 2;
    return sum * X;
}

/* int (cosh(w) - t) omega sinh(w) dw of an end */
static double primitive_of(const outside *o, int end, double w)
{
    const double t = o->ends.sine[end], c = o->ends.cosine[end], from = cosh(w) - t;
    return from * from * omega(o, end, w) / 2 - c / 2 * (sinh(w) - t * w);
}

/* int slope, times pi/2. */
static double primitive(const outside *o, double w)
{
    const rw_corners *k = &o->ends;
    const double X = sinh(w), C = cosh(w);
    if (is_rounded(o) && k->per_alpha == 0)
        return (C - k->sine[0]) * omega(o, 0, w) - k->cosine[0] * w;
    const double segment = k->half_over / 2 * (C * X - w);
    if (!is_rounded(o))
        return segment + (primitive_of(o, 0, w) - primitive_of(o, 1, w)) * k->per_alpha / 2;
    const double from = C - k->sine[1], sum = 2 * C - k->sine[0] - k->sine[1];
    const double cos_twice = 1 - 2 * k->sin_middle * k->sin_middle;
    const double rest = k->sin_half_over / 2 * (k->sin_middle * X + cos_twice * k->cos_half * w);
    return segment + from * from * omega_difference(o, w) / 4 + sum * omega(o, 0, w) / 2 - rest;
}

/* Where the closed form neither cancels next to the edge nor far away. */
static const double NEAR = 0.06, FAR = 2;

/* Panels as long as w is far from the singularities, at distances of the angles between the ends
 * and the edge. */
static double integrate(rw_function f, const outside *o, double from, double to)
{
    double sum = 0, first = 1;
    for (int i = 0; i < 2; i++)
        if (o->ends.is_inside[i])
            first = fmin(first, rw_angle(o->ends.sine[i], o->ends.cosine[i]));
    while (from < to) {
        const double next = fmin(to, from + fmin(2, fmax(first, from)));
        sum += rw_integral(f, o, from, next);
        from = next;
    }
    return sum;
}

static double plain_slope(double w, const void *context)
{
    const outside *o = context;
    return (1 - o->delta - rw_eccentric_at(&o->potential, o->m + o->s * cosh(w), 0).G_re) * sinh(w);
}

static double w_at(const outside *o, double right, double x)
{
    const double beyond = (x - right) / o->s;
    return asinh(sqrt(beyond * (2 + beyond)));
}

/* x > right. The formulas hold as far as the profile is what they take it for. */
static double right_gap(double a, rw_patch patch, double x)
{
    outside o = {.a = a,
                 .m = rw_patch_middle(patch),
                 .s = rw_patch_half_width(patch),
                 .delta = rw_patch_pressing(a, patch).tilt,
                 .ends = rw_corners_of(a, patch),
                 .flank = patch.right >= a};
    o.clear[0] = (patch.right + a) / o.s;
    o.clear[1] = (patch.right - a) / o.s;
    const double whole = w_at(&o, patch.right, x);
    const double rounding = o.flank ? whole : fmin(whole, w_at(&o, patch.right, a));
    const double closed = fmin(rounding, FAR);
    double gap =
        2 / RW_PI * (closed < NEAR ? integrate(slope, &o, 0, closed) : primitive(&o, closed));
    if (!o.flank && closed < rounding)
        gap += 2 / RW_PI * integrate(slope, &o, closed, rounding);
    const double from = o.flank ? closed : rounding;
    if (from < whole) {
        rw_eccentric_init(&o.potential, a, patch);
        gap += integrate(plain_slope, &o, from, whole);
    }
    return o.s * gap;
}

double rw_patch_gap(double a, rw_patch patch, double x)
{
    if (x > patch.right)
        return right_gap(a, patch, x);
    if (x < patch.left)
        return right_gap(a, (rw_patch){-patch.right, -patch.left}, -x);
    return 0;
}

/* ---- Displacement ---- */

/* The first corner in which two paths differ: it is a front inside the layer of the other one, or
 * its layer has another slope. */
static size_t count_common(const rw_memory *one, const rw_memory *other)
{
    size_t i = 1;
    /* always: they differ before one of them ends, because one has slipped where the other has
     * not */
    while (ALWAYS(i + 1 < one->count && i + 1 < other->count) &&
           one->corners[i].load == other->corners[i].load &&
           one->corners[i].ratio == other->corners[i].ratio)
        i++;
    return i;
}

/* Of the corners from `first` on; where that is not the first, the step at the corner before it. */
static double displacement(const rw_memory *path, size_t first, double a, double x)
{
    double sum = 0;
    for (size_t i = first; i < path->count; i++) {
        const double beyond = i + 1 < path->count ? path->corners[i + 1].ratio : 0;
        sum += (path->corners[i].ratio - beyond) * rw_patch_gap(a, path->corners[i].patch, x);
    }
    if (first > 1)
        sum -= path->corners[first].ratio * rw_patch_gap(a, path->corners[first - 1].patch, x);
    return sum;
}

double rw_path_displacement(const rw_memory *path, const rw_memory *beyond, double a, double x)
{
    const size_t common = count_common(path, beyond);
    return displacement(path, common, a, x) - displacement(beyond, common, a, x);
}

/* ---- Energy ---- */

typedef struct {
    const rw_memory *before, *after;
    const rw_eccentric *contact;
    double a;
} annulus;

static double work_at(double x, const void *context)
{
    const annulus *w = context;
    const double slip = rw_path_displacement(w->after, w->before, w->a, x);
    const double sign = rw_memory_end(w->after)->ratio; /* of slip, at all points: one_way.h */
    return fmax(0, sign * slip * rw_eccentric_at(w->contact, x, 0).G_im);
}

/* Between two marks: the integrand is smooth but for roots and logarithms at the ends, which the
 * substitution of tanh and sinh takes away. */
static double panel_integral(const annulus *w, double left, double right)
{
    const double half = (right - left) / 2, middle = left + half, step = 0.16;
    double sum = 0;
    for (int i = -20; i <= 20; i++) {
        const double t = i * step, u = tanh(RW_HALF_PI * sinh(t));
        const double x = middle + half * u, weight = RW_HALF_PI * cosh(t) * (1 - u * u);
        if (x > left && x < right)
            sum += weight * work_at(x, w);
    }
    return half * step * sum;
}

static void note_mark(double at, double left, double right, double *nearest)
{
    if (at > left && at < right && at < *nearest)
        *nearest = at;
}

/* The next mark on the way from left to right: an edge of a patch, an end of the rounding. */
static double next_mark(const annulus *w, double left, double right)
{
    double nearest = right;
    for (int k = 0; k < 2; k++) {
        const rw_memory *path = k ? w->after : w->before;
        for (size_t i = 1; i < path->count; i++) {
            note_mark(path->corners[i].patch.left, left, right, &nearest);
            note_mark(path->corners[i].patch.right, left, right, &nearest);
        }
    }
    note_mark(-w->a, left, right, &nearest);
    note_mark(w->a, left, right, &nearest);
    return nearest;
}

static double integral_between(const annulus *w, double left, double right)
{
    double sum = 0;
    while (left < right) {
        const double next = next_mark(w, left, right);
        sum += panel_integral(w, left, next);
        left = next;
    }
    return sum;
}

double rw_annuli_work(const rw_memory *before, const rw_memory *after, double a)
{
    const rw_corner *end = rw_memory_end(after);
    const rw_patch contact = end->patch, front = (end - 1)->patch;
    rw_eccentric potential;
    rw_eccentric_init(&potential, a, contact);
    const annulus w = {before, after, &potential, a};
    return integral_between(&w, contact.left, front.left) +
           integral_between(&w, front.right, contact.right);
}
