/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/search.h"

#include "base/domain.h"
#include "base/tuned.h"
#include "numerical/rates.h"

#include <string.h>

/* Angles of the grid; at a second trial twice as many. */
enum { ANGLES = 96 };

/* A front near one of the state before starts just inside the old zone that stuck, where the
 * residual is steep; for side -1 just outside. Whether any front was moved. */
static bool start_beside(const rw_problem *p, rw_fronts *f, double angle, int side)
{
    const rw_zones *old = &p->old->zones;
    bool is_moved = false;
    for (int j = 0; j < f->fronts; j++)
        for (int i = 0; i + 1 < old->count; i++) {
            const int left = old->zone[i].label, right = old->zone[i + 1].label;
            const int slip = f->label[j] != 0 ? f->label[j] : f->label[j + 1];
            if ((left != 0 ? left : right) != slip || (left == 0) != (f->label[j] == 0))
                continue;
            const double at = rw_angle_of(p, old->zone[i].right);
            if (fabs(at - f->y[j]) < RW_NEAR_OLD_FRONT * angle) {
                f->y[j] = at + side * (f->label[j] != 0 ? 1 : -1) * RW_BESIDE_OLD_FRONT * angle;
                is_moved = true;
            }
        }
    return is_moved;
}

static bool is_ordered(const rw_fronts *f)
{
    for (int j = 0; j <= f->fronts; j++)
        if (!((j > 0 ? f->y[j - 1] : 0) < (j < f->fronts ? f->y[j] : RW_PI)))
            return false;
    return true;
}

/* Whether a zone inside is narrower than `least` over the half-width: the equations do not
 * determine it, and its effect is below the tolerance. A zone that sticks between two ways of slip
 * may be a point. */
static bool has_sliver(const rw_work *w, const rw_fronts *f)
{
    const double least = RW_SLIVER * pow(w->frame->tolerance, 2.0 / 3);
    for (int i = 1; i + 1 < f->zones; i++)
        if (f->y[i] - f->y[i - 1] < least && f->label[i - 1] == f->label[i + 1])
            return true;
    return false;
}

/* A residual takes values at all points, for each zone that sticks. */
static void add_effort(rw_work *w, int residuals)
{
    w->is_short = w->is_short || w->fronts.is_short;
    w->search -= residuals;
    rw_spend(w, (double)residuals * w->fronts.sticks * (double)w->fronts.count);
}

static bool newton(rw_work *w, double residual)
{
    const int budget = RW_NEWTON_TURNS * (w->fronts.unknowns + 1);
    w->fronts.budget = budget;
    const bool is_done = rw_fronts_newton(&w->fronts, residual);
    add_effort(w, budget - w->fronts.budget);
    return is_done;
}

static bool relax(rw_work *w)
{
    w->fronts.budget = RW_RELAX_BUDGET;
    const bool is_done = rw_fronts_relax(&w->fronts);
    add_effort(w, RW_RELAX_BUDGET - w->fronts.budget);
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

/* The change of D at the edges that stick; HUGE_VAL where it was or is not known. */
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
    rw_fronts *f = &w->fronts;
    bool is_done = true, is_settled = !f->sticks_to_edge[0] && !f->sticks_to_edge[1];
    for (int turn = 0; turn < RW_RATIO_TURNS && is_done && !is_settled; turn++) {
        const double before[2] = {D[0], D[1]};
        double y[RW_MOST_FRONTS];
        rw_zones zones;
        rw_fronts_zones(f, &zones);
        ratios_at_start(w, p, &zones, D);
        memcpy(y, f->y, sizeof y);
        rw_fronts_begin(f, p, &zones, D);
        memcpy(f->y, y, sizeof y);
        is_settled = change_of_ratios(f, before, D) < RW_SAME_RATIO * w->frame->tolerance;
        is_done = is_settled || newton(w, residual);
    }
    return is_done;
}

static bool find_fronts(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle)
{
    rw_fronts *f = &w->fronts;
    const double residual = fmax(1e-12, RW_RESIDUAL * w->frame->tolerance) * p->scale;
    double D[2];
    ratios_at_start(w, p, zones, D);
    for (int side = 1; side >= -1; side -= 2) {
        if (w->search <= 0 || !rw_fronts_begin(f, p, zones, D))
            return false;
        const bool is_moved = start_beside(p, f, angle, side);
        if (side < 0 && !is_moved)
            return false;
        if (!is_ordered(f))
            rw_fronts_begin(f, p, zones, D);
        double start[RW_MOST_FRONTS];
        memcpy(start, f->y, sizeof start);
        bool is_done = newton(w, residual);
        if (!is_done && angle > 0) {
            memcpy(f->y, start, sizeof start);
            is_done = relax(w) && newton(w, residual);
        }
        if (is_done)
            return settle_ratios(w, p, D, residual) && !has_sliver(w, f);
    }
    return false;
}

/* Notes the effort of an outcome, about a residual for each element, and where memory was short. */
static bool noted(rw_work *w, bool is_done, const rw_outcome *outcome)
{
    w->is_short = w->is_short || outcome->is_short;
    if (is_done)
        rw_spend(w, (double)(outcome->state.traction.count * w->fronts.count));
    return is_done;
}

static bool try_fronts(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                       rw_outcome *outcome)
{
    if (!find_fronts(w, p, zones, angle))
        return false;
    if (!noted(w, rw_outcome_of_fronts(&w->fronts, outcome), outcome))
        return false;
    w->search -= RW_OUTCOME_COUNTS;
    return true;
}

/* An outcome that is worse than any. */
static const rw_outcome NONE = {.violation = HUGE_VAL};

/* Another outcome takes the place of the best one, or is freed. Whether it does. */
static bool take_if(bool is_better, rw_outcome *best, const rw_outcome *other)
{
    rw_traction loser = is_better ? best->state.traction : other->state.traction;
    rw_traction_destroy(&loser);
    if (is_better)
        *best = *other;
    return is_better;
}

/* Tries a pattern, and keeps its outcome where it is the best so far. Parts that turn out to have
 * the wrong label get the other one, and the pattern is tried again. */
static void try_pattern(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                        double least, rw_outcome *best)
{
    rw_zones pattern = *zones;
    rw_outcome outcome = NONE, other;
    for (int turn = 0; turn < 4 && outcome.violation > p->allowed; turn++) {
        if (!try_fronts(w, p, &pattern, angle, &other) ||
            !take_if(other.violation < outcome.violation, &outcome, &other))
            break;
        pattern = outcome.state.zones;
        rw_pattern_insert(&pattern, &outcome.wrong, least);
    }
    take_if(outcome.violation < best->violation, best, &outcome);
}

/* A guess of the layers of a growing contact, as if all of it stuck. Where no edge grows from the
 * beginning on its weight is 0. */
static rw_layers guess_layers(rw_work *w)
{
    const rw_zones stuck = {1, {{0, w->start.to.left, w->start.to.right}}};
    double ratio[2], sum = 0;
    int known = 0;
    rw_rates_ratio(&w->fronts, &w->start, &stuck, ratio);
    for (int side = 0; side < 2; side++)
        if (isfinite(ratio[side])) {
            sum += ratio[side];
            known++;
        }
    return (rw_layers){1, {sum / fmax(known, 1)}};
}

static void try_all(rw_work *w, const rw_problem *p, const rw_zones *zones, double angle,
                    rw_outcome *best)
{
    const double width = p->half * angle * angle * 2;
    rw_zones pattern = *zones, variant;
    rw_pattern_clean(&pattern, width);
    do {
        for (int number = 0; number < RW_VARIANTS && best->violation > p->allowed; number++) {
            if (!rw_pattern_variant(p, &pattern, width, number, &variant))
                continue;
            rw_pattern_clean(&variant, width);
            try_pattern(w, p, &variant, angle, width, best);
        }
    } while (best->violation > p->allowed && rw_pattern_simpler(p, &pattern, width));
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
static void try_guess(rw_work *w, const rw_problem *p, const rw_zones *guess, rw_outcome *best)
{
    const rw_zones *old = &p->old->zones;
    if (!guess && (old->count < 2 || rw_rates_wrong(&w->fronts, &w->start, old, old) > 0))
        return;
    const rw_zones zones = moved_to(guess ? *guess : *old, p->to);
    try_pattern(w, p, &zones, guess ? 0 : RW_PI / ANGLES, p->half * 1e-3, best);
}

/* The zones, but places that are new in contact stick. Whether there are any that slip. */
static bool stick_where_new(const rw_problem *p, rw_zones *zones)
{
    const rw_zone first = zones->zone[0], last = zones->zone[zones->count - 1];
    rw_zones new = {.count = 0};
    if (first.label != 0 && p->grows[0] && first.right <= p->from.left)
        new.zone[new.count++] = (rw_zone){0, first.left, first.right};
    if (last.label != 0 && p->grows[1] && last.left >= p->from.right)
        new.zone[new.count++] = (rw_zone){0, last.left, last.right};
    rw_pattern_insert(zones, &new, 0);
    return new.count > 0;
}

/* Slip that ends at an edge that grows: where all that slips is new in contact, its slip is too
 * small to count, whatever its sense, but the rates tell that it has ended. */
static void end_slip_at_edges(rw_work *w, const rw_problem *p, rw_outcome *best)
{
    rw_zones zones = best->state.zones;
    rw_outcome other;
    if (!stick_where_new(p, &zones))
        return;
    if (rw_rates_wrong(&w->fronts, &w->end, &best->state.zones, &best->state.zones) >
            p->allowed * p->scale &&
        try_fronts(w, p, &zones, 0, &other))
        take_if(other.violation <= p->allowed, best, &other);
}

bool rw_search(rw_work *w, const rw_problem *p, const rw_zones *guess, bool coarse,
               rw_outcome *best)
{
    w->search = w->effort > w->most_effort ? 0 : RW_SEARCH_BUDGET;
    *best = NONE;
    try_guess(w, p, guess, best);
    if (best->violation <= p->allowed) {
        end_slip_at_edges(w, p, best);
        return true;
    }
    const rw_layers layers = p->grows[0] || p->grows[1] ? guess_layers(w) : (rw_layers){.count = 0};
    for (int trial = 0; trial < RW_TRIALS; trial++) {
        rw_grid *grid = &w->grid[trial];
        const int n = ANGLES << trial;
        if (grid->n == 0 && !rw_grid_init(grid, n)) {
            w->is_short = true;
            break;
        }
        rw_zones zones;
        rw_outcome outcome;
        const bool is_solved = rw_grid_solve(grid, p, &layers);
        rw_spend(w, n * n * n / 250 + n * n * grid->turns / 50); /* as measured */
        if (!is_solved)
            continue;
        rw_grid_zones(grid, p, &zones);
        try_all(w, p, &zones, RW_PI / n, best);
        if (best->violation <= p->allowed) {
            end_slip_at_edges(w, p, best);
            return true;
        }
        if (coarse && trial + 1 == RW_TRIALS &&
            noted(w, rw_outcome_of_grid(&w->fronts, grid, p, &layers, &outcome), &outcome))
            take_if(outcome.violation < best->violation, best, &outcome);
    }
    if (!coarse && best->violation > w->frame->tolerance)
        rw_traction_destroy(&best->state.traction);
    return best->state.traction.count > 0;
}

bool rw_search_zones(rw_work *w, const rw_problem *p, const rw_zones *guess, bool by_grid,
                     rw_zones *zones)
{
    const rw_zones start = moved_to(*guess, p->to);
    rw_outcome outcome;
    if (w->effort > w->most_effort)
        return false;
    w->search = RW_SEARCH_BUDGET;
    if (find_fronts(w, p, &start, 0)) {
        rw_fronts_zones(&w->fronts, zones);
        if (!by_grid)
            return true;
        rw_outcome_of_slip(&w->fronts, &outcome);
        if (outcome.violation <= RW_LIKE_GUESS * p->allowed)
            return true;
    }
    if (!by_grid || !rw_search(w, p, NULL, false, &outcome))
        return false;
    *zones = outcome.state.zones;
    rw_traction_destroy(&outcome.state.traction);
    return true;
}

void rw_work_init(rw_work *w, const rw_frame *frame, int most_effort)
{
    w->frame = frame;
    w->frictions = 0;
    w->effort = 0;
    w->most_effort = most_effort;
    w->is_short = false;
    rw_fronts_init(&w->fronts, frame->tolerance);
    for (int i = 0; i < RW_TRIALS; i++)
        w->grid[i].n = 0;
    for (int i = 0; i < RW_FRICTIONS; i++)
        w->friction[i] = (rw_friction){.peak = 0};
}

void rw_work_destroy(rw_work *w)
{
    for (int i = 0; i < RW_FRICTIONS; i++)
        rw_friction_destroy(&w->friction[i]);
    for (int i = 0; i < RW_TRIALS; i++)
        rw_grid_destroy(&w->grid[i]);
    rw_fronts_destroy(&w->fronts);
}
