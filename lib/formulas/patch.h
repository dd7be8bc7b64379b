/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch of contact off the centre, as a moment or a bulk tension makes it: the wedge's profile,
 * of rounding a, pressed to left < x < right: the load, moment and tilt of a patch.
 *
 * With x = m + s sin(phi), m = (left + right)/2, s = (right - left)/2, all of it is a mean over the
 * rounding: <> is over |x| < a, phi staying at +-pi/2 beyond the edges. In theta/A and theta,
 *     P = 2 s <cos(phi)>,   M = m P + s^2 <sin(phi) cos(phi)>,   delta = -(2/pi) <phi>.
 * The tilt delta is what the moment takes off the slope g of the profile. |delta| < 1: at 1 a flank
 * would lie on the surface. */
#ifndef RW_PATCH_H
#define RW_PATCH_H

#include <math.h>
#include <stdbool.h>

/* The edges are exact: next to an edge, differences from it count. */
typedef struct {
    double left, right;
} rw_patch;

static inline double rw_patch_middle(rw_patch patch)
{
    return patch.left / 2 + patch.right / 2;
}

static inline double rw_patch_half_width(rw_patch patch)
{
    return patch.right / 2 - patch.left / 2;
}

/* The left edge, or with a side the right one. */
static inline double rw_patch_edge(rw_patch patch, int side)
{
    return side ? patch.right : patch.left;
}

static inline bool rw_patch_is_same(rw_patch a, rw_patch b)
{
    return fabs(a.left - b.left) + fabs(a.right - b.right) == 0;
}

/* The patch of separated bodies is NaN and has no place. These comparisons raise no exception. */
static inline bool rw_patch_has(rw_patch patch, double x)
{
    return isgreaterequal(x, patch.left) && islessequal(x, patch.right);
}

/* The height of the profile above its middle at x >= 0, over theta. */
static inline double rw_wedge_height(double a, double x)
{
    return x < a ? x / a * (x / 2) : x - a / 2;
}

/* A part of the profile with a constant curvature, left <= right: a kink where they are equal. The
 * wedge's is [-a, a]. */
typedef struct {
    double left, right;
} rw_arc;

static inline rw_arc rw_rounding(double a)
{
    return (rw_arc){-a, a};
}

static inline double rw_arc_half_length(rw_arc arc)
{
    return arc.right / 2 - arc.left / 2;
}

/* Whether a patch has a part of the arc inside; the ends of an arc that is no kink do not count. */
static inline bool rw_arc_is_inside(rw_arc arc, rw_patch patch)
{
    return arc.left < patch.right && arc.right > patch.left;
}

/* Whether all of the patch is on the arc: Hertz. */
static inline bool rw_arc_covers(rw_arc arc, rw_patch patch)
{
    return patch.left >= arc.left && patch.right <= arc.right;
}

/* Whether one patch lies inside another, to the rounding that patches of a tilt have. false for
 * NaN. */
bool rw_patch_is_nested(rw_patch inner, rw_patch outer, double tilt);

/* The ends of an arc as the patch sees them; one that is outside counts as the
 * edge. half is half the angle phi between them, middle the angle midway. */
typedef struct {
    double alpha,
        per_alpha; /* half the arc over s; its reciprocal, 0 where it is a kink to the last bit */
    double sine[2], cosine[2];       /* of phi */
    double sin_half, cos_half;       /* half >= 0 */
    double half_over, sin_half_over; /* over alpha, finite for alpha = 0 too */
    double sin_middle, cos_middle;   /* cos_middle >= sin_half */
    bool is_inside[2];
} rw_arc_ends;

/* left < right, with the arc at least partly inside. */
rw_arc_ends rw_arc_ends_of(rw_arc arc, rw_patch patch);

/* Load, moment about x = 0, tilt. */
typedef struct {
    double load, moment, tilt;
} rw_pressing;

/* The pressing of the wedge that has the arc for its rounding, without the part `side` of its tilt.
 * An arc on the right of the patch makes the tilt -1, one on its left 1: that is `side`, or 0.
 * Where an arc reaches into the patch only a little, what is left of the tilt is small, and keeps
 * its digits. */
rw_pressing rw_arc_pressing(rw_arc arc, rw_patch patch, int *side);

/* v - sin(v) cos(v), 0 <= v <= pi/2: of the order (2/3) v^3. */
double rw_arc_less_product(double v, double sine, double cosine);

/* How fast the edges move: a load dP and a tilt d delta move the right edge by (dP + pi s d
 * delta)/(2 at_right) and the left one by -(dP - pi s d delta)/(2 at_left). The pressure falls to
 * each like (2/pi) at_edge sqrt(2 r/s), at the distance r. */
typedef struct {
    double at_left, at_right;
} rw_edge_rates;

#endif
