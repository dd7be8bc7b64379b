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
#include "history/gap.h"

#include "base/root.h"
#include "base/logarithm.h"
#include "potential/eccentric.h"

typedef struct {
    double m, s, delta;
    rw_arc arc;
    rw_patch patch;
    rw_arc_ends ends;
    double clear[2]; /* 1 - t, exactly */
    bool flank;      /* lies outside of the patch */
    rw_eccentric potential;
} outside;

/* X = sinh(w), C = cosh(w) = 1 + less. */
typedef struct {
    double w, X, C, less;
} place;

static place place_at(double w)
{
    const double half = sinh(w / 2), less = 2 * half * half;
    return (place){w, 2 * half * sqrt(1 + half * half), 1 + less, less};
}

/* omega of an end of the rounding, 0 for an end outside the patch. */
static double omega(const outside *o, int end, place at)
{
    if (!o->ends.is_inside[end])
        return 0;
    return rw_angle(o->clear[end] - o->ends.sine[end] * at.less, o->ends.cosine[end] * at.X);
}

/* (omega_0 - omega_1)/alpha, both ends inside. */
static double omega_difference(const outside *o, place at)
{
    const rw_arc_ends *k = &o->ends;
    const double X = at.X, C = at.C;
    const double x0 = o->clear[0] - k->sine[0] * at.less, x1 = o->clear[1] - k->sine[1] * at.less;
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
    const rw_arc_ends *k = &o->ends;
    const place at = place_at(w);
    const double X = at.X, C = at.C;
    double sum;
    if (is_rounded(o) && k->per_alpha == 0)
        sum = omega(o, 0, at);
    else if (is_rounded(o))
        sum = k->half_over * X + (C - k->sine[1]) * omega_difference(o, at) / 2 + omega(o, 0, at);
    else
        sum = k->half_over * X +
              ((C - k->sine[0]) * omega(o, 0, at) - (C - k->sine[1]) * omega(o, 1, at)) *
                  k->per_alpha / 2;
    return sum * X;
}

/* int (cosh(w) - t) omega sinh(w) dw of an end */
static double primitive_of(const outside *o, int end, place at)
{
    const double t = o->ends.sine[end], c = o->ends.cosine[end], from = at.C - t;
    return from * from * omega(o, end, at) / 2 - c / 2 * (at.X - t * at.w);
}

/* int slope, times pi/2. */
static double primitive(const outside *o, double w)
{
    const rw_arc_ends *k = &o->ends;
    const place at = place_at(w);
    const double X = at.X, C = at.C;
    if (is_rounded(o) && k->per_alpha == 0)
        return (C - k->sine[0]) * omega(o, 0, at) - k->cosine[0] * w;
    const double segment = k->half_over / 2 * (C * X - w);
    if (!is_rounded(o))
        return segment + (primitive_of(o, 0, at) - primitive_of(o, 1, at)) * k->per_alpha / 2;
    const double from = C - k->sine[1], sum = 2 * C - k->sine[0] - k->sine[1];
    const double cos_twice = 1 - 2 * k->sin_middle * k->sin_middle;
    const double rest = k->sin_half_over / 2 * (k->sin_middle * X + cos_twice * k->cos_half * w);
    return segment + from * from * omega_difference(o, at) / 4 + sum * omega(o, 0, at) / 2 - rest;
}

/* Between these w the closed form cancels neither as it does next to the edge nor as far away. */
static const double NEAR = 0.06, FAR = 2;

/* More panels than a patch of the domain can need: none of its angles is below 1e-160, no w above
 * 400. */
enum { PANELS_MAX = 1024 };

/* Panels as long as w is far from the singularities, at distances of the angles between the ends
 * and the edge. NaN for a patch without width: none of its panels has a length. */
static double integrate(rw_function f, const outside *o, double from, double to)
{
    double sum = 0, first = 1;
    for (int i = 0; i < 2; i++)
        if (o->ends.is_inside[i])
            first = fmin(first, rw_angle(o->ends.sine[i], o->ends.cosine[i]));
    for (int i = 0; i < PANELS_MAX && from < to; i++) {
        const double next = fmin(to, from + fmin(2, fmax(first, from)));
        sum += rw_integral(f, o, from, next);
        from = next;
    }
    return from < to ? NAN : sum;
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

/* The formulas hold up to the next end of the rounding: beyond it the profile differs. */
static outside outside_of(rw_arc arc, rw_patch patch)
{
    outside o = {.arc = arc,
                 .patch = patch,
                 .m = rw_patch_middle(patch),
                 .s = rw_patch_half_width(patch),
                 .ends = rw_arc_ends_of(arc, patch),
                 .flank = patch.right >= arc.right};
    o.clear[0] = (patch.right - arc.left) / o.s;
    o.clear[1] = (patch.right - arc.right) / o.s;
    return o;
}

/* x > right */
static double right_gap(outside *o, double x)
{
    const double whole = w_at(o, o->patch.right, x);
    const double rounding = o->flank ? whole : fmin(whole, w_at(o, o->patch.right, o->arc.right));
    const double closed = fmin(rounding, FAR);
    double gap =
        2 / RW_PI * (closed < NEAR ? integrate(slope, o, 0, closed) : primitive(o, closed));
    if (!o->flank && closed < rounding)
        gap += 2 / RW_PI * integrate(slope, o, closed, rounding);
    const double from = o->flank ? closed : rounding;
    if (from < whole) {
        int side;
        o->delta = rw_arc_pressing(o->arc, o->patch, &side).tilt;
        o->delta += side;
        rw_eccentric_init_arc(&o->potential, o->arc, o->patch);
        gap += integrate(plain_slope, o, from, whole);
    }
    return o->s * gap;
}

/* The gap of the wedge that has the arc for its rounding; x is outside the patch. */
static double arc_gap(rw_arc arc, rw_patch patch, double x)
{
    const bool is_right = x > patch.right;
    outside o = is_right ? outside_of(arc, patch)
                         : outside_of((rw_arc){-arc.right, -arc.left},
                                      (rw_patch){-patch.right, -patch.left});
    return right_gap(&o, is_right ? x : -x);
}

double rw_off_centre_gap(const rw_geometry *g, rw_patch patch, double x)
{
    const rw_pad *pad = g->pad;
    if (!pad)
        return arc_gap(rw_rounding(g->a), patch, x);
    double sum = rw_pad_rise(pad, patch, x);
    for (size_t i = 0; i < pad->count; i++)
        if (rw_arc_is_inside(pad->arcs[i], patch))
            sum += pad->weights[i] * arc_gap(pad->arcs[i], patch, x);
    return sum;
}
