/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The end of wear in partial slip, while Q goes to and fro by Q_a under a constant P and a held
 * tilt. What sticks in every cycle keeps its profile; the rest wears until it carries nothing. The
 * zone that sticks is the patch of P - Q_a/f under the present tilt. With its middle m and
 * half-width s the pressure becomes
 *
 *     N = N(patch) + (Q_a/f)/(pi sqrt(s^2 - (x-m)^2)),
 *
 * a flat punch that carries Q_a/f, and the gap beside it that of the patch less
 *
 *     (A Q_a/(pi f)) arcosh(|x-m|/s):
 *
 * as far as that is negative it is worn off. The shear that changes, Q_a/(pi sqrt(...)), then is f
 * times the singular part of N: the edges just stick. lib/README.md, "The fully worn pad". */
#include "base/maximum.h"
#include "contact/contact.h"
#include "history/gap.h"

#include <float.h>

typedef struct {
    const rw_geometry *geometry;
    rw_patch stuck;
    double punch; /* Q_a/(pi f) */
} end_of_wear;

static double arcosh_beyond(double over) /* of 1 + over */
{
    return log1p(over + sqrt(over * (2 + over)));
}

/* What overlaps at x beside the zone that sticks; negative beyond what wears. It is concave. */
static double overlap(const end_of_wear *e, double x)
{
    const double beyond = fmax(e->stuck.left - x, x - e->stuck.right);
    return e->geometry->A * e->punch * arcosh_beyond(beyond / rw_patch_half_width(e->stuck)) -
           e->geometry->theta * rw_patch_gap(e->geometry, e->stuck, x);
}

static double depth_at(double x, const void *of)
{
    const end_of_wear *e = of;
    return rw_patch_has(e->stuck, x) ? 0 : fmax(0, overlap(e, x));
}

/* ---- The zone that sticks ---- */

static int32_t find_end(const rwedge_contact *contact, double Q_a, end_of_wear *end)
{
    if (!rw_is_magnitude(Q_a))
        return RWEDGE_EDOMAIN;
    if (contact->phase == RW_APART)
        return RWEDGE_EABSENT;
    if (contact->unlike)
        return RWEDGE_EPATH;
    const rw_corner *present = rw_memory_end(&contact->memory);
    const double left_over = present->load - Q_a / contact->f; /* f = 0: NaN or -inf */
    if (!(left_over > rw_memory_tolerance(present->load)))
        return RWEDGE_ESLIDING;
    end->geometry = &contact->geometry;
    end->stuck =
        Q_a > 0 ? rw_patch_under_tilt(end->geometry, left_over, present->tilt) : present->patch;
    end->punch = Q_a / (contact->f * RW_PI);
    return rw_is_contact_size(end->geometry, rw_patch_half_width(end->stuck)) ? RWEDGE_OK
                                                                              : RWEDGE_ERANGE;
}

/* ---- How far it wears ---- */

/* One side of the zone, right or left (1 or -1), where x follows from the angle t: x - m = s
 * cosh(t). */
typedef struct {
    const end_of_wear *end;
    int side;
} flank;

static double place(const flank *of, double t)
{
    const double half = sinh(t / 2), beyond = rw_patch_half_width(of->end->stuck) * 2 * half * half;
    return of->side > 0 ? of->end->stuck.right + beyond : of->end->stuck.left - beyond;
}

static double angle(const flank *of, double x)
{
    const double beyond = of->side > 0 ? x - of->end->stuck.right : of->end->stuck.left - x;
    return arcosh_beyond(beyond / rw_patch_half_width(of->end->stuck));
}

static double overlap_at(double t, const void *of)
{
    const flank *to = of;
    return overlap(to->end, place(to, t));
}

/* Where the overlap ends. Beside the zone it is positive, as the root of the distance. 0 where that
 * is too close to be told. */
static double worn_angle(const flank *of)
{
    enum { DOUBLINGS = 100 };
    double low = 1, high = 1;
    if (of->end->punch == 0)
        return 0;
    for (int i = 0; i < DOUBLINGS && overlap_at(low, of) < 0; i++)
        low /= 2;
    for (int i = 0; i < DOUBLINGS && overlap_at(high, of) > 0; i++)
        high *= 2;
    const double t = rw_root(overlap_at, of, low, fmax(high, 2 * low), 0);
    return isnan(t) ? 0 : t;
}

/* ---- The area that is worn off ---- */

static double overlap_by_angle(double t, const void *of)
{
    const flank *to = of;
    return overlap_at(t, of) * rw_patch_half_width(to->end->stuck) * sinh(t);
}

/* The next end of an arc after t, or `last`. The overlap has a corner of the second order there. */
static double next_break(const flank *of, double t, double last)
{
    const rw_arcs arcs = rw_arcs_of(of->end->geometry);
    double next = last;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        const double ends[] = {arc.left, arc.right};
        for (int k = 0; k < 2; k++)
            if (!rw_patch_has(of->end->stuck, ends[k]) &&
                of->side * (ends[k] - rw_patch_middle(of->end->stuck)) > 0 &&
                angle(of, ends[k]) > t)
                next = fmin(next, angle(of, ends[k]));
    }
    return next;
}

/* An arc may end inside, beside the edge: the pieces become smaller towards it. */
static double worn_area(const flank *of, double last)
{
    enum { HALVINGS = 24 };
    double area = 0, from = 0;
    for (int i = HALVINGS; i >= 0; i--) {
        const double to = ldexp(last, -i);
        while (from < to) {
            const double next = next_break(of, from, to);
            area += rw_integral(overlap_by_angle, of, from, next);
            from = next;
        }
    }
    return area;
}

/* ---- The functions ---- */

int32_t rwedge_contact_worn_zone(const rwedge_contact *contact, double Q_a, double *left,
                                 double *right, double *worn_left, double *worn_right, double *area)
{
    if (!contact || !left || !right || !worn_left || !worn_right || !area)
        return RWEDGE_ENULL;
    end_of_wear end;
    const int32_t status = find_end(contact, Q_a, &end);
    if (status != RWEDGE_OK)
        return status;
    const flank at_left = {&end, -1}, at_right = {&end, 1};
    const double to_left = worn_angle(&at_left), to_right = worn_angle(&at_right);
    const rw_patch worn = {place(&at_left, to_left), place(&at_right, to_right)};
    const double sum = worn_area(&at_left, to_left) + worn_area(&at_right, to_right);
    const double reach = end.geometry->reach;
    if (!rw_is_magnitude(sum) || (reach > 0 && fmax(-worn.left, worn.right) > reach))
        return RWEDGE_ERANGE;
    *left = end.stuck.left;
    *right = end.stuck.right;
    *worn_left = worn.left;
    *worn_right = worn.right;
    *area = sum;
    return RWEDGE_OK;
}

/* Two depths are equal that differ by this part: a few roundings. */
static const double EQUAL = 16 * DBL_EPSILON;

int32_t rwedge_contact_deepest_wear(const rwedge_contact *contact, double Q_a, double *depth,
                                    double *x)
{
    double left, right, worn_left, worn_right, area;
    if (!depth || !x)
        return RWEDGE_ENULL;
    const int32_t status =
        rwedge_contact_worn_zone(contact, Q_a, &left, &right, &worn_left, &worn_right, &area);
    end_of_wear end;
    if (status != RWEDGE_OK)
        return status;
    find_end(contact, Q_a, &end);
    double at[RW_SPREAD], value[RW_SPREAD];
    rw_spread_places(worn_left, left, at);
    const rw_maximum on_left = rw_largest_value(depth_at, &end, RW_SPREAD, at, value);
    rw_spread_places(right, worn_right, at);
    const rw_maximum on_right = rw_largest_value(depth_at, &end, RW_SPREAD, at, value);
    const bool is_left = on_left.value > (1 + EQUAL) * on_right.value;
    *depth = is_left ? on_left.value : on_right.value;
    *x = is_left ? on_left.x : on_right.x;
    return RWEDGE_OK;
}

/* The pressure at the edges of the zone is infinite, if anything wears. */
static bool has_pressure(const end_of_wear *end, double half_width, double x)
{
    const bool is_edge = x == end->stuck.left || x == end->stuck.right;
    return rw_has_stress(end->geometry, half_width, x, 0) && !(is_edge && end->punch > 0);
}

static double pressure_at(const end_of_wear *end, double x)
{
    if (!rw_patch_has(end->stuck, x))
        return 0;
    const double root = sqrt(x - end->stuck.left) * sqrt(end->stuck.right - x);
    return rw_unit_stress(end->geometry) * rw_pressure_of(end->geometry, end->stuck, x) -
           (end->punch > 0 ? end->punch / root : 0);
}

int32_t rwedge_contact_full_wear(const rwedge_contact *contact, double Q_a, size_t n,
                                 const double x[], double depth[], double p[])
{
    if (!contact || (n > 0 && (!x || !depth || !p)))
        return RWEDGE_ENULL;
    end_of_wear end;
    const int32_t status = find_end(contact, Q_a, &end);
    if (status != RWEDGE_OK)
        return status;
    for (size_t i = 0; i < n; i++)
        if (!has_pressure(&end, rw_patch_half_width(end.stuck), x[i]))
            return RWEDGE_EDOMAIN;
    for (size_t i = 0; i < n; i++) {
        const double at = x[i]; /* x may be p or depth */
        depth[i] = depth_at(at, &end);
        p[i] = pressure_at(&end, at);
    }
    return RWEDGE_OK;
}
