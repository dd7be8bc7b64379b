/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formulas/patch.h"

#include "base/domain.h"
#include "base/logarithm.h"

#include <float.h>

/* A smaller alpha is lost in rounding beside 1, and its square beside any number. */
static const double SHARP = 0x1p-260;

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
