/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/search.h"

#include "base/domain.h"
#include "numerical/rates.h"

#include <string.h>

/* Angles of the grid; at a second trial twice as many. */
enum { ANGLES = 96 };

/* How many residuals the search for the fronts of one pattern may take, for each unknown and one
 * more. It succeeds with fewer, if at all. */
enum { TURNS = 10 };

/* How many residuals the search for the zones of a step may take, and how many each outcome counts.
 * Beyond that a shorter step is better: its zones are nearer to the old ones, and found at once. */
enum { SEARCH = 500, OUTCOME = 20 };

/* The residual at which Newton's method ends, over the tolerance. */
static const double RESIDUAL = 1e-5;

/* Fronts near those before start just inside of what stuck, where the residual is steep. */
static void start_beside(const rw_problem *p, double angle, rw_zones *zones)
{
    const rw_zones *old = &p->old->zones;
    for (int j = 0; j + 1 < zones->count; j++)
        for (int i = 0; i + 1 < old->count; i++) {
            rw_zone *left = &zones->zone[j], *right = left + 1;
            const double at = rw_angle_of(p, old->zone[i].right);
            const double x = rw_place_of(p, at + (left->label != 0 ? 0.05 : -0.05) * angle);
            if (old->zone[i].label == left->label && old->zone[i + 1].label == right->label &&
                fabs(at - rw_angle_of(p, left->right)) < 2.5 * angle && x > left->left &&
                x < right->right)
                left->right = right->left = x;
        }
}

/* A residual takes values at all points, for each zone that sticks. */
static void add_effort(rw_work *w, int residuals)
{
    w->search -= residuals;
    w->effort += residuals * w->fronts.sticks * (int)w->fronts.count;
}

static bool newton(rw_work *w, double residual)
{
    const int budget = TURNS * (w->fronts.unknowns + 1);
    w->fronts.budget = budget;
    const bool is_done = rw_fronts_newton(&w->fronts, residual);
    add_effort(w, budget - w->fronts.budget);
    return is_done;
}

/* D at edges that grow, at the beginning of a step which ends with these zones. */
static void ratios_at_start(rw_work *w, const rw_problem *p, const rw_zones *after, double D[2])
{
    D[0] = D[1] = NAN;
    if (!p->grows[0] && !p->grows[1])
        return;
    const rw_zones begun = rw_rates_begun(&w->fronts, &w->start, &p->old->zones, after);
    rw_rates_ratio(&w->fronts, &w->start, &begun, D);
}

/* Of D at the edges that stick; HUGE_VAL where it was or is not known. */
static double change_of_ratios(const rw_fronts *f, const double before[2], const double D[2])
{
    double most = 0;
    for (int side = 0; side < 2; side++)
        if (f->sticks_to_edge[side] && !(isnan(before[side]) && isnan(D[side])))
            most =
                isnan(before[side] + D[side]) ? HUGE_VAL : fmax(most, fabs(D[side] - before[side]));
    return most;
}

/* D at the beginning follows from the zones at the end, which it changes a little. */
static bool settle_ratios(rw_work *w, const rw_problem *p, double D[2], double residual)
{
    enum { MOST_TURNS = 4 };
    static const double SAME = 0.1; /* of the tolerance */
    rw_fronts *f = &w->fronts;
    bool is_done = true, is_settled = !f->sticks_to_edge[0] && !f->sticks_to_edge[1];
    for (int turn = 0; turn < MOST_TURNS && is_done && !is_settled; turn++) {
        const double before[2] = {D[0], D[1]};
        double y[RW_MOST_FRONTS];
        rw_zones zones;
        rw_fronts_zones(f, &zones);
        ratios_at_start(w, p, &zones, D);
        memcpy(y, f->y, sizeof y);
        rw_fronts_begin(f, p, &zones, D);
        memcpy(f->y, y, sizeof y);
        is_settled = change_of_ratios(f, before, D) < SAME * w->frame->tolerance;
        is_done = is_settled || newton(w, residual);
    }
    return is_done;
}

static bool find_fronts(rw_work *w, const rw_problem *p, const rw_zones *zones)
{
    const double residual = fmax(1e-12, RESIDUAL * w->frame->tolerance) * p->scale;
    double D[2];
    ratios_at_start(w, p, zones, D);
    return w->search > 0 && rw_fronts_begin(&w->fronts, p, zones, D) && newton(w, residual) &&
           settle_ratios(w, p, D, residual);
}

/* Notes the effort of an outcome, about a residual for each element, and where memory was short. */
static bool noted(rw_work *w, bool is_done, const rw_outcome *outcome)
{
    w->is_short = w->is_short || outcome->is_short;
    if (is_done)
        w->effort += (int)(outcome->state.traction.count * w->fronts.count);
    return is_done;
}

static bool try_fronts(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                       rw_outcome *outcome)
{
    rw_zones start = *zones;
    start_beside(p, angle, &start);
    if (!find_fronts(w, p, &start))
        return false;
    if (!noted(w, rw_outcome_of_fronts(&w->fronts, outcome), outcome))
        return false;
    w->search -= OUTCOME;
    return true;
}

/* The outcome of a pattern. Parts that turn out to have the wrong label get the other one, and the
 * pattern is tried again. */
static bool try_pattern(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                        double least, rw_outcome *best)
{
    if (!try_fronts(w, p, zones, angle, best))
        return false;
    for (int turn = 0; turn < 3 && best->violation > p->allowed; turn++) {
        rw_zones mended = best->state.zones;
        rw_outcome other;
        for (int i = 0; i < best->wrong.count; i++)
            rw_pattern_insert(&mended, best->wrong.zone[i], least);
        if (!try_fronts(w, p, &mended, angle, &other))
            break;
        rw_shear_state_destroy(other.violation < best->violation ? &best->state : &other.state);
        if (!(other.violation < best->violation))
            break;
        *best = other;
    }
    return true;
}

/* Keeps the better of two. */
static void keep_better(rw_outcome *best, bool *is_known, const rw_outcome *other)
{
    rw_outcome worse = *other;
    if (!*is_known || other->violation < best->violation) {
        worse = *best;
        *best = *other;
    }
    if (*is_known)
        rw_shear_state_destroy(&worse.state);
    *is_known = true;
}

static bool try_all(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                    rw_outcome *best)
{
    const double width = p->half * angle * angle * 2;
    rw_zones pattern = *zones;
    bool is_known = false;
    rw_pattern_clean(&pattern, width);
    for (int number = 0; number < RW_VARIANTS; number++) {
        rw_zones variant;
        rw_outcome outcome;
        if (!rw_pattern_variant(p, &pattern, width, number, &variant))
            continue;
        rw_pattern_clean(&variant, width);
        if (!try_pattern(w, p, &variant, angle, width, &outcome))
            continue;
        keep_better(best, &is_known, &outcome);
        if (best->violation <= p->allowed)
            return true;
    }
    return is_known;
}

/* The zones of a contact, scaled to another one. */
static rw_zones moved_to(rw_zones zones, rw_patch contact)
{
    const double left = zones.zone[0].left, right = zones.zone[zones.count - 1].right;
    const double stretch = (contact.right - contact.left) / (right - left);
    for (int i = 0; i < zones.count; i++) {
        zones.zone[i].left = i > 0 ? zones.zone[i - 1].right : contact.left;
        zones.zone[i].right = i + 1 == zones.count
                                  ? contact.right
                                  : contact.left + stretch * (zones.zone[i].right - left);
    }
    return zones;
}

/* Tries the zones of a similar step; or those before the step, if they go on slipping as they
 * did. */
static bool try_guess(rw_work *w, const rw_problem *p, const rw_zones *guess, rw_outcome *best)
{
    const rw_zones *old = &p->old->zones;
    if (!guess && (old->count < 2 || rw_rates_wrong(&w->fronts, &w->start, old, old) > 0))
        return false;
    const rw_zones zones = moved_to(guess ? *guess : *old, p->to);
    return try_pattern(w, p, &zones, guess ? 0 : RW_PI / ANGLES, p->half * 1e-3, best);
}

/* Slip at the edges becomes stick where all that slips is new in contact. Whether there is any. */
static bool stick_where_new(const rw_problem *p, rw_zones *zones)
{
    rw_zone *first = zones->zone, *last = first + zones->count - 1;
    const bool at_left = first->label != 0 && p->grows[0] && first->right <= p->from.left;
    const bool at_right = last->label != 0 && p->grows[1] && last->left >= p->from.right;
    first->label = at_left ? 0 : first->label;
    last->label = at_right ? 0 : last->label;
    rw_pattern_clean(zones, 0);
    return at_left || at_right;
}

/* Slip that ends at an edge that grows: where all that slips is new in contact, its slip is too
 * small to count, whatever its sense, but the rates tell that it has ended. */
static void end_slip_at_edges(rw_work *w, const rw_problem *p, rw_outcome *best)
{
    rw_zones zones = best->state.zones;
    rw_outcome other;
    if (!stick_where_new(p, &zones))
        return;
    if (rw_rates_wrong(&w->fronts, &w->end, &best->state.zones, &best->state.zones) <=
            p->allowed * p->scale ||
        !try_fronts(w, p, &zones, 0, &other))
        return;
    const bool is_allowed = other.violation <= p->allowed;
    rw_shear_state_destroy(is_allowed ? &best->state : &other.state);
    if (is_allowed)
        *best = other;
}

bool rw_search(rw_work *w, const rw_problem *p, const rw_zones *guess, bool coarse,
               rw_outcome *best)
{
    w->search = w->effort > w->most_effort ? 0 : SEARCH;
    bool is_known = try_guess(w, p, guess, best);
    if (is_known && best->violation <= p->allowed) {
        end_slip_at_edges(w, p, best);
        return true;
    }
    for (int trial = 0; trial < RW_TRIALS; trial++) {
        rw_grid *grid = &w->grid[trial];
        const int n = ANGLES << trial;
        if (!grid->x && !rw_grid_create(grid, n)) {
            w->is_short = true;
            break;
        }
        rw_zones zones;
        rw_outcome outcome;
        const bool is_solved = rw_grid_solve(grid, p);
        w->effort += n * n * n / 250 + n * n * grid->turns / 50; /* as measured */
        if (!is_solved)
            continue;
        rw_grid_zones(grid, p, &zones);
        if (try_all(w, p, &zones, RW_PI / n, &outcome))
            keep_better(best, &is_known, &outcome);
        if (is_known && best->violation <= p->allowed)
            return true;
        if (coarse && trial + 1 == RW_TRIALS &&
            noted(w, rw_outcome_of_grid(&w->fronts, grid, p, &outcome), &outcome))
            keep_better(best, &is_known, &outcome);
    }
    if (is_known && !coarse && best->violation > w->frame->tolerance) {
        rw_shear_state_destroy(&best->state);
        return false;
    }
    return is_known;
}

bool rw_work_create(rw_work *w, const rw_frame *frame, int most_effort)
{
    *w = (rw_work){.frame = frame, .most_effort = most_effort};
    return rw_fronts_create(&w->fronts, frame->tolerance);
}

void rw_work_destroy(rw_work *w)
{
    rw_fronts_destroy(&w->fronts);
    for (int i = 0; i < RW_TRIALS; i++)
        rw_grid_destroy(&w->grid[i]);
    for (int i = 0; i < RW_FRICTIONS; i++)
        rw_friction_destroy(&w->friction[i]);
}
