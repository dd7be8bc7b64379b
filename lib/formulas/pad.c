/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formulas/pad.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/root.h"

#include <float.h>

/* ---- Load, moment and tilt of a patch ---- */

/* An arc outside the patch has a tilt of -1 or 1. These are added apart: for a symmetric pad they
 * cancel exactly. */
rw_pressing rw_pad_pressing(const rw_pad *pad, rw_patch patch)
{
    rw_pressing sum = {0, 0, 0};
    double aside = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        const double weight = pad->weights[i];
        int side = arc.left < patch.right ? 1 : -1;
        if (rw_arc_is_inside(arc, patch)) {
            const rw_pressing carried = rw_arc_pressing(arc, patch, &side);
            sum.load += weight * carried.load;
            sum.moment += weight * carried.moment;
            sum.tilt += weight * carried.tilt;
        }
        aside += side * weight;
    }
    sum.tilt += aside;
    return sum;
}

rw_edge_rates rw_pad_edge_rates(const rw_pad *pad, rw_patch patch)
{
    rw_edge_rates sum = {0, 0};
    for (size_t i = 0; i < pad->count; i++) {
        if (!rw_arc_is_inside(pad->arcs[i], patch))
            continue;
        const rw_arc_ends ends = rw_arc_ends_of(pad->arcs[i], patch);
        const rw_edge_rates rates = rw_patch_edge_rates(&ends);
        sum.at_left += pad->weights[i] * rates.at_left;
        sum.at_right += pad->weights[i] * rates.at_right;
    }
    return sum;
}

/* How much the profile of an arc rises from its left end to x. */
static double rise(rw_arc arc, double x)
{
    const double a = rw_arc_half_length(arc);
    if (x <= arc.left)
        return 0;
    return x < arc.right ? (x - arc.left) / a * ((x - arc.left) / 2) : 2 * (a + (x - arc.right));
}

double rw_pad_rise(const rw_pad *pad, rw_patch patch, double x)
{
    double sum = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        if (arc.left >= patch.right && x > patch.right)
            sum += pad->weights[i] * rise(arc, x);
        else if (arc.right <= patch.left && x < patch.left)
            sum += pad->weights[i] * rise((rw_arc){-arc.right, -arc.left}, -x);
    }
    return sum;
}

double rw_pad_height(const rw_pad *pad, double x)
{
    double sum = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        if (arc.left >= 0 && arc.right > 0)
            sum += pad->weights[i] * rise(arc, x);
        else if (arc.right > 0 && x < arc.right) /* in the middle */
            sum += pad->weights[i] * (x / arc.right * (x / 2));
        else if (arc.right > 0 || arc.left == 0) /* or a kink there */
            sum += pad->weights[i] * (x - arc.right / 2);
    }
    return sum;
}

bool rw_pad_is_kink(const rw_pad *pad, double x)
{
    for (size_t i = 0; i < pad->count; i++)
        if (pad->arcs[i].left == x && pad->arcs[i].right == x)
            return true;
    return false;
}

/* ---- The patch of a load ---- */

/* A width that cannot be multiplied. */
static const double LARGEST = 1e250;

typedef struct {
    const rw_pad *pad;
    double P, wanted;
    bool by_moment;
    double left;
} search;

static double half_load_excess(double s, const void *context)
{
    const search *at = context;
    return rw_pad_pressing(at->pad, (rw_patch){-s, s}).load - at->P;
}

static double load_excess(double right, const void *context)
{
    const search *at = context;
    return rw_pad_pressing(at->pad, (rw_patch){at->left, right}).load - at->P;
}

/* The first place after *from, in steps that double, at which f is positive: always before the
 * largest, as a load grows with the width. *from, where f is not positive, moves to the place
 * before it. */
static double beyond_root(rw_function f, const void *context, double *from, double step)
{
    while (f(*from + step, context) < 0 && ALWAYS(step < LARGEST)) {
        *from += step;
        step *= 2;
    }
    return *from + step;
}

/* The load is less than the width: the slope changes by 2 at most. */
double rw_pad_half_width(const rw_pad *pad, double P)
{
    const search at = {.pad = pad, .P = P};
    double lo = P / 2 * (1 - DBL_EPSILON);
    if (P == 0)
        return 0;
    const double hi = beyond_root(half_load_excess, &at, &lo, lo);
    return rw_root(half_load_excess, &at, lo, hi, 0);
}

static double right_edge(const search *at)
{
    double lo = at->left + at->P * (1 - DBL_EPSILON);
    const double hi = beyond_root(load_excess, at, &lo, at->P);
    const double nearest = DBL_EPSILON / 4 * (hi - at->left);
    return rw_root(load_excess, at, lo, hi, nearest);
}

/* Under one load the moment and the tilt grow as the edges move to the right. The rounded edges of
 * a narrow patch far from x = 0 have a load that differs: the moment is corrected for it. */
static double excess(double left, const void *context)
{
    search at = *(const search *)context;
    at.left = left;
    const rw_pressing carried = rw_pad_pressing(at.pad, (rw_patch){left, right_edge(&at)});
    /* rounding may leave no width, and so no load */
    const double arm = carried.load > 0 ? carried.moment / carried.load : left;
    return (at.by_moment ? arm * at.P : carried.tilt) - at.wanted;
}

/* The left edge is between -infinity, where the tilt is -1, and the right end of the profile, where
 * it is 1. */
static rw_patch search_patch(search *s)
{
    const double end = s->pad->arcs[s->pad->count - 1].right;
    double lo = s->pad->arcs[0].left - s->P, step = s->P;
    while (excess(lo, s) > 0) {
        lo -= step;
        step *= 2;
    }
    double distance = end - lo;
    do {
        distance /= 2;
        if (!(end - distance < end))
            return (rw_patch){NAN, NAN};
    } while (excess(end - distance, s) < 0);
    s->left = rw_root(excess, s, lo, end - distance, DBL_EPSILON / 4 * (s->P + (end - lo)));
    return (rw_patch){s->left, right_edge(s)};
}

static rw_patch patch_of(const rw_pad *pad, double P, double wanted, bool by_moment)
{
    search s = {.pad = pad, .P = P, .wanted = wanted, .by_moment = by_moment};
    if (!pad->is_symmetric)
        return search_patch(&s);
    if (wanted == 0) {
        const double b = rw_pad_half_width(pad, P);
        return (rw_patch){-b, b};
    }
    s.wanted = fabs(wanted);
    const rw_patch patch = search_patch(&s);
    return wanted < 0 ? (rw_patch){-patch.right, -patch.left} : patch;
}

rw_patch rw_pad_patch_of_moment(const rw_pad *pad, double P, double M)
{
    return patch_of(pad, P, M, true);
}

rw_patch rw_pad_patch_of_tilt(const rw_pad *pad, double P, double tilt)
{
    return patch_of(pad, P, tilt, false);
}
