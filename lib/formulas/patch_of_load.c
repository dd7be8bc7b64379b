/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The patch of a load and a moment or a tilt. Under one load both edges move to the same side, and
 * the moment and the tilt grow with them. */
#include "formulas/arcs.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/root.h"
#include "rwedge.h"

#include <float.h>

/* A width that cannot be multiplied. */
static const double LARGEST = 1e250;

static const rw_patch NONE = {NAN, NAN};

typedef struct {
    const rw_arcs *arcs;
    rw_carried carried; /* NULL: rw_arcs_pressing() */
    const void *context;
    double P, wanted;
    bool by_moment;
    double left;
} search;

static rw_pressing pressing_of(const search *at, rw_patch patch)
{
    return at->carried ? at->carried(at->context, patch) : rw_arcs_pressing(at->arcs, patch);
}

static double load_excess(double right, const void *context)
{
    const search *at = context;
    return pressing_of(at, (rw_patch){at->left, right}).load - at->P;
}

/* The right edge that goes with the left one under the load P: the load grows with the edge,
 * without bound, and is less than the width, or not much more where it is rounded up. The edge of a
 * pad may be next to 0. */
static double right_edge(const search *at)
{
    double lo = at->left + at->P / 2, width = at->P;
    /* always: the load grows with the width; the left edge is a number, because excess() has both
     * signs where it is searched */
    while (load_excess(at->left + width, at) < 0 && ALWAYS(width < LARGEST)) {
        lo = at->left + width;
        width *= 2;
    }
    return rw_root(load_excess, at, lo, at->left + width,
                   at->arcs->pad || at->carried ? DBL_EPSILON / 4 * width : 0);
}

/* The rounded edges of a narrow patch far from x = 0 have a load that differs: the moment of a pad,
 * which may be there, is corrected for it. */
static double excess(double left, const void *context)
{
    search at = *(const search *)context;
    at.left = left;
    const rw_pressing carried = pressing_of(&at, (rw_patch){left, right_edge(&at)});
    if (!at.by_moment)
        return carried.tilt - at.wanted;
    if (!at.arcs->pad)
        return carried.moment - at.wanted;
    /* rounding may leave no width, and so no load */
    return (carried.load > 0 ? carried.moment / carried.load : left) * at.P - at.wanted;
}

/* A left edge that is too far to the left: `lo`, or one beyond. The loop ends: steps that begin
 * with more than 0 reach any distance, and at -infinity the tilt is -1. */
static double far_left(const search *s, double lo, double step)
{
    for (; excess(lo, s) > 0; step *= 2)
        lo -= step;
    return lo;
}

/* Searches from a left edge that is too far to the left towards the end of the profile, where M is
 * infinite and the tilt is 1. */
static rw_patch search_patch(search *s, double lo, double end, double nearest)
{
    double distance = end - lo;
    do {
        distance /= 2;
        if (!(end - distance < end))
            return NONE;
    } while (excess(end - distance, s) < 0);
    s->left = rw_root(excess, s, lo, end - distance, nearest);
    return (rw_patch){s->left, right_edge(s)};
}

/* ---- The wedge, wanted >= 0 ---- */

/* The sharp wedge, m >= 0: where the edges differ much, the one nearer to the apex is small. */
static rw_patch sharp(double m, double P)
{
    const double s = hypot(m, P / 2);
    return (rw_patch){-(P / 2) * (P / 2 / (m + s)), m + s};
}

/* The search begins with the centred patch. */
static rw_patch patch_of_wedge(search *s)
{
    const double a = s->arcs->rounding.right, P = s->P, wanted = s->wanted;
    const double arm = s->by_moment ? wanted / P : 0;
    if (a == 0)
        return sharp(s->by_moment ? 2 * arm : P / 2 * tan(RW_HALF_PI * wanted), P);
    if (arm > 2 * RW_LARGEST * fmin(a, 1)) /* it is inside the contact: it, or a/b, is too large */
        return NONE;
    const double half = sqrt(2 / RW_PI * a) * sqrt(P), m = s->by_moment ? arm : wanted * a;
    if (m + half <= a) /* Hertz */
        return (rw_patch){m - half, m + half};
    const double centred = half <= a ? half : a / rwedge_a_over_b(P / a);
    if (isnan(centred)) /* a/b is not in the domain */
        return NONE;
    if (wanted == 0)
        return (rw_patch){-centred, centred};
    /* rounding other than to the nearest takes a few steps */
    const double lo = far_left(s, -centred * (1 + 4 * DBL_EPSILON), 4 * DBL_EPSILON * centred);
    return search_patch(s, lo, a, DBL_EPSILON * centred / 4);
}

/* ---- A pad ---- */

static double half_load_excess(double s, const void *context)
{
    const search *at = context;
    return rw_arcs_pressing(at->arcs, (rw_patch){-s, s}).load - at->P;
}

/* The load is less than the width: the slope changes by 2 at most. */
double rw_pad_half_width(const rw_pad *pad, double P)
{
    const rw_arcs arcs = {.count = pad->count, .pad = pad};
    const search at = {.arcs = &arcs, .P = P};
    double lo = P / 2 * (1 - DBL_EPSILON), hi = 2 * lo;
    if (P == 0)
        return 0;
    while (half_load_excess(lo, &at) > 0) /* a kink's, if its load is rounded up */
        lo /= 2;
    for (; half_load_excess(hi, &at) < 0 && ALWAYS(hi < LARGEST); hi *= 2)
        lo = hi;
    return rw_root(half_load_excess, &at, lo, hi, 0);
}

/* The left edge is between -infinity, where the tilt is -1, and the right end of the profile.
 * Without P there is no moment, and at the left end of the profile the tilt is -1 already. */
static rw_patch patch_of_any(search *s)
{
    const double end = rw_arc_at(s->arcs, s->arcs->count - 1).right;
    const double lo = far_left(s, rw_arc_at(s->arcs, 0).left - s->P, s->P);
    return search_patch(s, lo, end, DBL_EPSILON / 4 * (s->P + (end - lo)));
}

static rw_patch patch_of_pad(search *s)
{
    const rw_pad *pad = s->arcs->pad;
    if (pad->is_symmetric && s->wanted == 0) {
        const double b = rw_pad_half_width(pad, s->P);
        return (rw_patch){-b, b};
    }
    return patch_of_any(s);
}

/* The patch of -M or -delta is the mirror image to the last bit. */
static rw_patch patch_of(const rw_arcs *arcs, double P, double wanted, bool by_moment)
{
    const bool is_mirrored = wanted < 0 && (!arcs->pad || arcs->pad->is_symmetric);
    search s = {
        .arcs = arcs, .P = P, .wanted = is_mirrored ? -wanted : wanted, .by_moment = by_moment};
    const rw_patch patch = arcs->pad ? patch_of_pad(&s) : patch_of_wedge(&s);
    return is_mirrored ? (rw_patch){-patch.right, -patch.left} : patch;
}

rw_patch rw_arcs_patch_of_moment(const rw_arcs *arcs, double P, double M)
{
    return patch_of(arcs, P, M, true);
}

rw_patch rw_arcs_patch_of_tilt(const rw_arcs *arcs, double P, double tilt)
{
    return patch_of(arcs, P, tilt, false);
}

rw_patch rw_carried_patch(const rw_arcs *arcs, rw_carried carried, const void *context, double P,
                          double wanted, bool by_moment)
{
    search s = {.arcs = arcs,
                .carried = carried,
                .context = context,
                .P = P,
                .wanted = wanted,
                .by_moment = by_moment};
    return patch_of_any(&s);
}

/* ---- Edges that turn ---- */

/* Above 0 where a change of load and moment moves the edge outwards, on the side -1 or 1. */
static double outwards(rw_patch patch, int side, double dP, double dM)
{
    return dP + side * 2 / rw_patch_half_width(patch) * (dM - rw_patch_middle(patch) * dP);
}

/* Finds the turn of an edge by halving. */
static double turn(const rw_arcs *arcs, int side, rw_pressing from, double dP, double dM)
{
    enum { HALVINGS = 40 };
    double inwards_at = 0, outwards_at = 1;
    for (int i = 0; i < HALVINGS; i++) {
        const double t = inwards_at / 2 + outwards_at / 2;
        const rw_patch patch =
            rw_arcs_patch_of_moment(arcs, from.load + t * dP, from.moment + t * dM);
        *(outwards(patch, side, dP, dM) > 0 ? &outwards_at : &inwards_at) = t;
    }
    return outwards_at;
}

rw_turns rw_arcs_turns(const rw_arcs *arcs, rw_patch from, rw_patch to)
{
    const rw_pressing first = rw_arcs_pressing(arcs, from), last = rw_arcs_pressing(arcs, to);
    const double dP = last.load - first.load, dM = last.moment - first.moment;
    rw_turns turns;
    for (int i = 0, side = -1; i < 2; i++, side = 1)
        turns.at[i] = outwards(from, side, dP, dM) >= 0 ? 0
                      : outwards(to, side, dP, dM) <= 0 ? 1
                                                        : turn(arcs, side, first, dP, dM);
    return turns;
}

/* A straight way of load and tilt: an edge rests where the half-width is |dP|/(pi |d delta|)
 * (path.c). The half-width passes that value once, rising with the load, because the other edge
 * goes the way of the load. */
rw_turns rw_arcs_turns_of_tilt(const rw_arcs *arcs, rw_patch from, rw_patch to)
{
    enum { HALVINGS = 40 };
    const rw_pressing first = rw_arcs_pressing(arcs, from), last = rw_arcs_pressing(arcs, to);
    const double dP = last.load - first.load, tilt = last.tilt - first.tilt;
    const double rests = fabs(dP) / (RW_PI * fabs(tilt));
    const double few = rw_patch_half_width(dP > 0 ? from : to),
                 many = rw_patch_half_width(dP > 0 ? to : from);
    if (!(few < rests && rests < many))
        return (rw_turns){{1, 1}};
    double narrow = dP > 0 ? 0 : 1, wide = 1 - narrow;
    for (int i = 0; i < HALVINGS; i++) {
        const double t = narrow / 2 + wide / 2;
        const rw_patch patch =
            rw_arcs_patch_of_tilt(arcs, first.load + t * dP, first.tilt + t * tilt);
        *(rw_patch_half_width(patch) > rests ? &wide : &narrow) = t;
    }
    return (rw_turns){{wide, wide}};
}
