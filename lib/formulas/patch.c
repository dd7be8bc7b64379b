/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formulas/patch.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/logarithm.h"
#include "rwedge.h"
#include "base/root.h"

#include <float.h>

/* A smaller alpha is lost in rounding beside 1, and its square beside any number. */
static const double SHARP = 0x1p-260;

/* A width that cannot be multiplied. */
static const double LARGEST = 1e250;

/* The rounding of an edge, over the width: an edge at the same place counts as inside. */
static const double SLACK = 1e-12;

bool rw_patch_is_nested(rw_patch inner, rw_patch outer, double tilt)
{
    if (fabs(tilt) >= 1) /* a flank is on the surface: it has no edges */
        return false;
    const double reach = fmax(fabs(outer.left), fabs(outer.right)); /* may be many widths */
    const double tolerance =
        (SLACK + 16 * DBL_EPSILON / (1 - fabs(tilt))) * (outer.right - outer.left) +
        8 * DBL_EPSILON * reach;
    return isgreaterequal(inner.left, outer.left - tolerance) &&
           islessequal(inner.right, outer.right + tolerance);
}

/* sin(v) - v cos(v), 0 <= v <= pi/2: of the order v^3/3. */
static double sine_less_arc(double v, double sine, double cosine)
{
    if (v > 0.5)
        return sine - v * cosine;
    double term = v * v * v / 6, sum = 0; /* sum (-1)^(k+1) 2k v^(2k+1)/(2k+1)! */
    for (int k = 1; k < 8; k++) {
        sum += 2 * k * term;
        term *= -v * v / ((2 * k + 2) * (2 * k + 3));
    }
    return sum;
}

double rw_arc_less_product(double v, double sine, double cosine)
{
    return v * sine * sine - cosine * sine_less_arc(v, sine, cosine);
}

/* With the sines t and cosines c of the two angles, t_1 - t_0 = 2 cos_middle sin_half, c_0 + c_1 =
 * 2 cos_middle cos_half and t_0 + t_1 = 2 sin_middle cos_half. */
rw_arc_ends rw_arc_ends_of(rw_arc arc, rw_patch patch)
{
    const double s = rw_patch_half_width(patch), alpha = rw_arc_half_length(arc) / s;
    rw_arc_ends k = {.alpha = alpha, .per_alpha = alpha < SHARP ? 0 : 1 / alpha};
    for (int i = 0; i < 2; i++) {
        const double at = i == 0 ? arc.left : arc.right;
        const double from_left = (at - patch.left) / s, to_right = (patch.right - at) / s;
        k.is_inside[i] = from_left > 0 && to_right > 0;
        k.sine[i] = k.is_inside[i] ? (at - rw_patch_middle(patch)) / s : 2 * i - 1;
        k.cosine[i] = k.is_inside[i] ? sqrt(from_left * to_right) : 0;
    }
    const bool left_inside = k.is_inside[0], right_inside = k.is_inside[1];
    const double centre = arc.left / 2 + arc.right / 2, off = centre - rw_patch_middle(patch);
    const double between = right_inside  ? left_inside ? 2 * alpha : (arc.right - patch.left) / s
                           : left_inside ? (patch.right - arc.left) / s
                                         : 2;
    const double sum = right_inside  ? left_inside ? 2 * (off / s) : (arc.right - patch.right) / s
                       : left_inside ? (arc.left - patch.left) / s
                                     : 0;
    const double over = right_inside && left_inside ? 2 : between * k.per_alpha;
    const double cosines = k.cosine[0] + k.cosine[1];
    const double twice = sqrt(cosines * cosines + between * between);
    k.sin_half = between / twice;
    k.cos_half = cosines / twice;
    k.sin_half_over = over / twice;
    k.half_over = rw_angle_over(cosines, over, alpha, k.per_alpha);
    k.cos_middle = twice / 2;
    k.sin_middle = k.cos_half > 0 ? sum / (2 * k.cos_half) : 0;
    return k;
}

rw_edge_rates rw_patch_edge_rates(const rw_arc_ends *k)
{
    const double slant = k->sin_middle * k->sin_half_over; /* (c_0 - c_1)/(2 alpha) */
    return (rw_edge_rates){.at_left = k->half_over - slant, .at_right = k->half_over + slant};
}

/* The tilt -<phi> (2/pi). Where both ends of the rounding are inside, <phi> is the middle angle
 * less a term from the curvature of the sine. Where one end is inside, phi is pi/2 on the rest of
 * the rounding. */
static double tilt_of(const rw_arc_ends *k, double half, int *side)
{
    *side = 0;
    if (k->is_inside[0] && k->is_inside[1]) {
        const double bend =
            half > 0 ? sine_less_arc(half, k->sin_half, k->cos_half) / k->sin_half : 0;
        const double middle = rw_angle(k->cos_middle, k->sin_middle);
        return -2 / RW_PI * (middle - k->sin_middle / k->cos_middle * bend);
    }
    const int in = k->is_inside[1];
    *side = in ? 1 : -1;
    const double arc = rw_angle(-*side * k->sine[in], k->cosine[in]);
    return -*side *
           (sine_less_arc(arc, k->cosine[in], -*side * k->sine[in]) / RW_PI * k->per_alpha);
}

rw_pressing rw_arc_pressing(rw_arc arc, rw_patch patch, int *side)
{
    const double m = rw_patch_middle(patch), s = rw_patch_half_width(patch);
    if (rw_arc_covers(arc, patch)) {
        const double a = rw_arc_half_length(arc), load = RW_HALF_PI * s * (s / a);
        *side = 0;
        return (rw_pressing){load, m * load, (m - (arc.left / 2 + arc.right / 2)) / a};
    }
    const rw_arc_ends k = rw_arc_ends_of(arc, patch);
    const double half = k.half_over * k.alpha;
    const double load = s * (rw_arc_less_product(half, k.sin_half, k.cos_half) * k.per_alpha +
                             2 * k.cos_middle * k.cos_middle * k.sin_half_over * k.cos_half);
    const double c0 = k.cosine[0], c1 = k.cosine[1];
    /* (c0^3 - c1^3)/(6 alpha) */
    const double off = k.sin_middle * k.sin_half_over / 3 * (c0 * c0 + c0 * c1 + c1 * c1);
    return (rw_pressing){load, m * load + s * s * off, tilt_of(&k, half, side)};
}

rw_pressing rw_patch_pressing(double a, rw_patch patch)
{
    int side;
    rw_pressing carried = rw_arc_pressing(rw_rounding(a), patch, &side);
    if (side != 0)
        carried.tilt += side;
    return carried;
}

/* ---- The patch of a load ---- */

/* For M, delta >= 0. */
typedef struct {
    double a, P, wanted;
    bool by_moment;
    double left;
} search;

static double load_excess(double right, const void *context)
{
    const search *s = context;
    return rw_patch_pressing(s->a, (rw_patch){s->left, right}).load - s->P;
}

/* The right edge that goes with the left one, left < a, under the load P: it grows with the edge,
 * without bound, and is less than the width. */
static double right_edge(const search *at)
{
    double lo = at->left + at->P * (1 - DBL_EPSILON), width = at->P;
    /* always: the load grows with the width */
    while (load_excess(at->left + width, at) < 0 && ALWAYS(width < LARGEST)) {
        lo = at->left + width;
        width *= 2;
    }
    return rw_root(load_excess, at, lo, at->left + width, 0);
}

/* Under one load both edges move to the same side, and the moment and the tilt grow with them. */
static double excess(double left, const void *context)
{
    search at = *(const search *)context;
    at.left = left;
    const rw_pressing carried = rw_patch_pressing(at.a, (rw_patch){left, right_edge(&at)});
    return (at.by_moment ? carried.moment : carried.tilt) - at.wanted;
}

/* From the centred patch to one whose left edge is at the end of the rounding, where M is infinite
 * and delta is 1. */
static rw_patch search_patch(search *s, double centred)
{
    if (isnan(centred)) /* a/b is not in the domain */
        return (rw_patch){NAN, NAN};
    double lo = -centred * (1 + 4 * DBL_EPSILON), distance = s->a - lo;
    do {
        distance /= 2;
        if (!(s->a - distance < s->a))
            return (rw_patch){NAN, NAN};
    } while (excess(s->a - distance, s) < 0);
    s->left = rw_root(excess, s, lo, s->a - distance, DBL_EPSILON * centred / 4);
    return (rw_patch){s->left, right_edge(s)};
}

static rw_patch hertz(double m, double s)
{
    return (rw_patch){m - s, m + s};
}

/* The sharp wedge, m >= 0: where the edges differ much, the one nearer to the apex is small. */
static rw_patch sharp(double m, double P)
{
    const double s = hypot(m, P / 2);
    return (rw_patch){-(P / 2) * (P / 2 / (m + s)), m + s};
}

static rw_patch of_moment(double a, double P, double M)
{
    if (a == 0)
        return sharp(2 * (M / P), P);
    const double s = sqrt(2 / RW_PI * a) * sqrt(P), m = M / P;
    if (m >
        2 * RW_LARGEST * fmin(a, 1)) /* m is inside the contact: it, or a/b, is not in the domain */
        return (rw_patch){NAN, NAN};
    if (m + s <= a)
        return hertz(m, s);
    search wanted = {.a = a, .P = P, .wanted = M, .by_moment = true};
    return search_patch(&wanted, s <= a ? s : a / rwedge_a_over_b(P / a));
}

static rw_patch of_tilt(double a, double P, double delta)
{
    if (a == 0)
        return sharp(P / 2 * tan(RW_HALF_PI * delta), P);
    const double s = sqrt(2 / RW_PI * a) * sqrt(P), m = delta * a;
    if (m + s <= a)
        return hertz(m, s);
    search wanted = {.a = a, .P = P, .wanted = delta};
    return search_patch(&wanted, s <= a ? s : a / rwedge_a_over_b(P / a));
}

static rw_patch mirrored(double sign, rw_patch patch)
{
    return sign < 0 ? (rw_patch){-patch.right, -patch.left} : patch;
}

rw_patch rw_patch_of_moment(double a, double P, double M)
{
    return mirrored(M, of_moment(a, P, fabs(M)));
}

rw_patch rw_patch_of_tilt(double a, double P, double delta)
{
    return mirrored(delta, of_tilt(a, P, fabs(delta)));
}
