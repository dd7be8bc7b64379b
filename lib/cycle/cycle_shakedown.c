/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounds of the shakedown of a cycle that stays in place. Let a load's deviator be (Re D, weight s,
 * txy), whose length is sqrt(J2), and r the peak that residual stresses can leave.
 *
 * No residual stress leaves less at a place than the radius of the smallest ball around the path of
 * its deviators; at the surface txy of the residual stress is 0, and the centre lies there. That is
 * the upper bound of the factor: necessary alone, as the balls of places need not go together.
 *
 * Residual stresses rho_xx(y) and rho_zz(x, y) are in equilibrium, whatever these functions are.
 * They move Re D by what is one number for a depth, and the second part by any number for each
 * place. By Melan's theorem what they leave is the lower bound. lib/README.md, "Shakedown". */
#include "base/maximum.h"
#include "cycle/states.h"
#include "planes/smallest_ball.h"
#include "stress/von_mises.h"

#include <stdlib.h>

enum { PARTS = 5, PER_PART = 24, PLACES = PARTS * PER_PART + 1, DEPTHS = 24, CUTS = 12 };

typedef struct {
    const rwedge_cycle *cycle;
    size_t loads;
    double weight; /* (1 - 2 nu)/sqrt(3) */
    double grid[PLACES], room[PLACES];
    double y, centre; /* of the present depth */
    double *stress;   /* of one place, then the deviators of all that were kept */
    rw_point *path, *turned, *kept;
    size_t cuts;
    double x; /* where the upper bound was, at the last depth */
    bool failed;
} search;

/* ---- One place ---- */

static void take_path(search *s, double x)
{
    const size_t n = s->loads;
    s->failed = rw_cycle_stresses(s->cycle, 1, &x, &s->y, s->stress) != RWEDGE_OK || s->failed;
    for (size_t i = 0; i < n; i++) {
        const double sxx = s->stress[i], syy = s->stress[n + i];
        s->path[i] =
            (rw_point){{syy / 2 - sxx / 2, s->weight * (sxx / 2 + syy / 2), s->stress[2 * n + i]}};
    }
}

/* What any residual stress leaves at least. */
static double least_at(double x, const void *of)
{
    search *s = (search *)of; /* its room */
    take_path(s, x);
    return (s->y > 0 ? rw_smallest_ball : rw_smallest_mirrored_ball)(s->loads, s->path).radius;
}

/* What is left where Re D is moved by `centre`: the second part moves as it is best. That is the
 * radius of the smallest circle around the points (second part, length of the others) and their
 * images. */
static double left_with(search *s, const rw_point path[], double centre)
{
    for (size_t i = 0; i < s->loads; i++)
        s->turned[i] = (rw_point){{path[i].x[1], 0, hypot(path[i].x[0] - centre, path[i].x[2])}};
    return rw_smallest_mirrored_ball(s->loads, s->turned).radius;
}

static double left_at(double x, const void *of)
{
    search *s = (search *)of;
    take_path(s, x);
    return left_with(s, s->path, s->centre);
}

/* ---- One depth ---- */

/* The most that is left at the places that were kept; less is better, and it is a convex function
 * of the centre. */
static double left_of_kept(const search *s, double centre)
{
    double most = 0;
    for (size_t i = 0; i < s->cuts; i++)
        most = fmax(most, left_with((search *)s, s->kept + i * s->loads, centre));
    return most;
}

typedef struct {
    const search *search;
    double above; /* more than any value */
} convex;

static double below_top(double centre, const void *of)
{
    const convex *c = of;
    return c->above - left_of_kept(c->search, centre);
}

/* The best centre for the places that were kept; what is left there. */
static double best_centre(search *s)
{
    double low = HUGE_VAL, high = -HUGE_VAL, value[3];
    for (size_t i = 0; i < s->cuts * s->loads; i++) {
        low = fmin(low, s->kept[i].x[0]);
        high = fmax(high, s->kept[i].x[0]);
    }
    const convex c = {s, left_of_kept(s, low) + left_of_kept(s, high)};
    const double place[3] = {low, low / 2 + high / 2, high};
    if (!(low < place[1] && place[1] < high)) {
        s->centre = low;
        return left_of_kept(s, low);
    }
    const rw_maximum best = rw_largest_value(below_top, &c, 3, place, value);
    s->centre = best.x;
    return c.above - best.value;
}

/* The peak that residual stresses of this kind leave at a depth: the worst place is kept, and the
 * centre chosen anew, until no other place is worse. It is that of the last centre, so it is not
 * too low. */
static double left_at_depth(double y, const void *of)
{
    static const double GAP = 1e-6;
    search *s = (search *)of;
    double least = HUGE_VAL;
    s->y = y;
    s->centre = 0;
    for (s->cuts = 0; s->cuts < CUTS;) {
        const rw_maximum worst = rw_largest_value(left_at, s, PLACES, s->grid, s->room);
        least = fmin(least, worst.value);
        take_path(s, worst.x);
        for (size_t i = 0; i < s->loads; i++)
            s->kept[s->cuts * s->loads + i] = s->path[i];
        s->cuts++;
        if (best_centre(s) >= least * (1 - GAP))
            break;
    }
    return least;
}

static double least_at_depth(double y, const void *of)
{
    search *s = (search *)of;
    s->y = y;
    const rw_maximum most = rw_largest_value(least_at, s, PLACES, s->grid, s->room);
    s->x = most.x;
    return most.value;
}

/* ---- Places ---- */

static rw_patch touched(const rwedge_cycle *cycle)
{
    rw_patch all = {HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < cycle->count; i++) {
        const rw_state *state = &cycle->states[i];
        if (!state->is_load || isnan(state->patch.left))
            continue;
        all.left = fmin(all.left, state->patch.left);
        all.right = fmax(all.right, state->patch.right);
    }
    return all;
}

/* Dense at the edges of the contact and of what never slips. */
static void choose_places(search *s, rw_patch patch)
{
    const double width = patch.right - patch.left;
    const rw_patch stuck = s->cycle->never_slips;
    const bool has_stuck =
        stuck.left > patch.left && stuck.right < patch.right && stuck.left < stuck.right;
    const double third = width / 3;
    const double ends[PARTS + 1] = {patch.left - width,
                                    patch.left,
                                    has_stuck ? stuck.left : patch.left + third,
                                    has_stuck ? stuck.right : patch.right - third,
                                    patch.right,
                                    patch.right + width};
    for (int part = 0; part < PARTS; part++)
        for (int i = 0; i < PER_PART; i++)
            s->grid[part * PER_PART + i] =
                ends[part] + (ends[part + 1] - ends[part]) * (1 - cos(RW_PI * i / PER_PART)) / 2;
    s->grid[PLACES - 1] = ends[PARTS];
}

static void choose_depths(rw_patch patch, double depth[DEPTHS])
{
    static const double FIRST = 5e-3, RATIO = 1.3; /* of the width */
    depth[0] = 0;
    for (int i = 1; i < DEPTHS; i++)
        depth[i] = FIRST * (patch.right - patch.left) * pow(RATIO, i - 1);
}

/* ---- Together ---- */

static bool make_room(search *s)
{
    s->stress = malloc(3 * s->loads * sizeof *s->stress);
    s->path = malloc((2 + CUTS) * s->loads * sizeof *s->path);
    s->turned = s->path ? s->path + s->loads : NULL;
    s->kept = s->path ? s->turned + s->loads : NULL;
    return s->stress && s->path;
}

typedef struct {
    double lower, upper, x, y;
} bounds;

static int32_t find(search *s, rw_patch patch, double k, bounds *found)
{
    double depth[DEPTHS], value[DEPTHS];
    choose_places(s, patch);
    choose_depths(patch, depth);
    const rw_maximum left = rw_largest_value(left_at_depth, s, DEPTHS, depth, value);
    const rw_maximum least = rw_largest_value(least_at_depth, s, DEPTHS, depth, value);
    const double most = least_at_depth(least.x, s);
    if (s->failed)
        return RWEDGE_ENOMEM;
    if (!(most > 0)) /* nothing changes */
        return RWEDGE_ERANGE;
    *found = (bounds){k / fmax(left.value, most), k / most, s->x, least.x};
    return rw_is_magnitude(found->lower) && rw_is_magnitude(found->upper) ? RWEDGE_OK
                                                                          : RWEDGE_ERANGE;
}

static bool touches_kink(const rw_geometry *g, rw_patch patch)
{
    const rw_arcs arcs = rw_arcs_of(g);
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        if (arc.left == arc.right && rw_patch_has(patch, arc.left))
            return true;
    }
    return false;
}

int32_t rwedge_cycle_shakedown(const rwedge_cycle *cycle, double nu, double k, double *lower,
                               double *upper, double *x, double *y)
{
    if (!cycle || !lower || !upper || !x || !y)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_positive(k))
        return RWEDGE_EDOMAIN;
    const rw_patch patch = touched(cycle);
    if (!(patch.left < patch.right) || touches_kink(&cycle->before->geometry, patch))
        return RWEDGE_EABSENT;
    search s = {
        .cycle = cycle, .loads = cycle->loads.count, .weight = sqrt(rw_plane_strain_weight(nu))};
    bounds found;
    const int32_t status = make_room(&s) ? find(&s, patch, k, &found) : RWEDGE_ENOMEM;
    free(s.stress);
    free(s.path);
    if (status != RWEDGE_OK)
        return status;
    *lower = found.lower;
    *upper = found.upper;
    *x = found.x;
    *y = found.y;
    return RWEDGE_OK;
}
