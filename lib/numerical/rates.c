/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/rates.h"

#include "base/domain.h"
#include "base/linear.h"
#include "base/tuned.h"
#include "numerical/pattern.h"

/* The solution of the rates. S f dp/ds on all of the contact makes no slip. With this traction as
 * layer 0, the rest is 0 but in zones that slip the other way than S. Many zones are those of a
 * grid, which is not that exact. */
static bool solve(rw_fronts *f, const rw_problem *problem, const rw_zones *zones, int sign,
                  rw_stuck *s)
{
    if (zones->count > RW_MOST_FRONTS)
        return false;
    f->problem = problem;
    rw_fronts_forget(f);
    *s = rw_stuck_of(f, zones);
    if (s->count == 0)
        return false;
    rw_fronts_collect(f, zones, &(rw_layers){sign != 0, {sign}}, f->coarse);
    const bool is_done = rw_fronts_polynomial(f, s);
    rw_fronts_prepare(f);
    return is_done;
}

/* At the RW_RATE_POINTS places x: w' where it slips with this sign; where it sticks the rate of t
 * beyond S f dp/ds: both terms are over i there, so that the second one changes its sign. */
static void rates_at(const rw_fronts *f, const rw_stuck *s, bool sticks, const double x[],
                     double rate[])
{
    double X[RW_RATE_POINTS];
    rw_X_values(s, RW_RATE_POINTS, x, X);
    for (int i = 0; i < RW_RATE_POINTS; i++) {
        const double p = rw_polynomial_at(s, (x[i] - s->middle) / s->half);
        rate[i] = X[i] * rw_fronts_transform(f, x[i]) + (sticks ? -p : p) / X[i];
    }
}

/* The places between two ends at which the rates are read, with their weights. */
static void rate_points(double from, double length, double x[], double weight[])
{
    rw_half_circle(RW_RATE_POINTS, x, weight);
    for (int i = 0; i < RW_RATE_POINTS; i++) {
        x[i] = from + length * x[i];
        weight[i] *= length;
    }
}

/* The end of a zone that slips from which slip is counted. Returns how far the other end is, < 0 to
 * the left. */
static double from_front(const rw_stuck *s, rw_zone zone, double *front)
{
    const bool is_leftmost = zone.right == s->end[0];
    *front = is_leftmost ? zone.right : zone.left;
    return is_leftmost ? zone.left - zone.right : zone.right - zone.left;
}

/* The largest slip with the sign of the traction, from the front on; `way` -1: against it. */
static double largest_slip(const rw_fronts *f, const rw_stuck *s, rw_zone zone, int way)
{
    double front, slip = 0, most = 0;
    double x[RW_RATE_POINTS], step[RW_RATE_POINTS], rate[RW_RATE_POINTS];
    const double length = from_front(s, zone, &front);
    rate_points(front, length, x, step);
    rates_at(f, s, false, x, rate);
    for (int i = 0; i < RW_RATE_POINTS; i++) {
        slip += rate[i] * step[i];
        most = fmax(most, way * zone.label * slip);
    }
    return most / sqrt(fabs(length) * s->half);
}

/* The factor of the rate of friction at an edge, which is like 1/sqrt: > 0 where the edge grows. */
static double edge_rate(const rw_problem *p, int side)
{
    const double sign = side ? 1 : -1;
    return p->frame->f * (p->load[0] / RW_PI + sign * p->tilt[0] * p->half) / (p->half * sqrt(2));
}

/* Whether the zones stick up to the edge. */
static bool sticks_at_edge(const rw_zones *zones, int side)
{
    return rw_zones_at_edge(zones, side).label == 0;
}

/* The ratio has the sign of the rates. */
static double ratio_at(const rw_problem *p, const rw_zones *zones, int sign, const rw_stuck *s,
                       int side)
{
    double K[RW_MOST_FRONTS];
    if (!(edge_rate(p, side) > 0) || !sticks_at_edge(zones, side))
        return NAN;
    rw_fronts_singular(s, K);
    return sign + K[side ? 2 * s->count - 1 : 0] / edge_rate(p, side);
}

static int first_sign(const rw_zones *zones)
{
    int sign = 0;
    for (int i = 0; i < zones->count && sign == 0; i++)
        sign = zones->zone[i].label;
    return sign;
}

double rw_rates_wrong(rw_fronts *f, const rw_problem *p, const rw_zones *zones,
                      const rw_zones *after)
{
    const int first = first_sign(zones);
    double most = 0;
    for (int sign = first; sign == first || sign == -first; sign -= 2 * first) {
        rw_stuck s;
        if (!solve(f, p, zones, sign, &s))
            return most;
        for (int i = 0; i < zones->count; i++)
            if (zones->zone[i].label != 0 && zones->zone[i].label == sign)
                most = fmax(most, largest_slip(f, &s, zones->zone[i], 1));
        for (int side = 0; side < 2 && sign == first; side++) {
            const double D = ratio_at(p, zones, sign, &s, side);
            if (isgreater(fabs(D), 1) && sticks_at_edge(after, side))
                most =
                    fmax(most, (fabs(D) - 1) * p->frame->f * fabs(p->load[0]) / (RW_PI * p->half));
        }
        if (sign == 0)
            break;
    }
    return most;
}

/* The largest slip that goes the right way in a zone. */
static double slip_in(rw_fronts *f, const rw_problem *p, const rw_zones *zones, rw_zone zone)
{
    rw_stuck s;
    return solve(f, p, zones, zone.label, &s) ? largest_slip(f, &s, zone, -1) : 0;
}

/* How far the traction goes beyond friction at the RW_RATE_POINTS places x of a part that slipped
 * with its label and now sticks: where it does, it slips on at first. false where it is not
 * known. */
static bool excess_in(rw_fronts *f, const rw_problem *p, const rw_zones *zones, rw_zone part,
                      double x[], double step[], double excess[])
{
    rw_stuck s;
    if (!solve(f, p, zones, part.label, &s))
        return false;
    rate_points(part.left, part.right - part.left, x, step);
    rates_at(f, &s, true, x, excess);
    for (int i = 0; i < RW_RATE_POINTS; i++)
        excess[i] = fmax(0, part.label * excess[i]);
    return true;
}

static double mean_excess_in(rw_fronts *f, const rw_problem *p, const rw_zones *zones, rw_zone part)
{
    double sum = 0, x[RW_RATE_POINTS], step[RW_RATE_POINTS], excess[RW_RATE_POINTS];
    if (!excess_in(f, p, zones, part, x, step, excess))
        return HUGE_VAL;
    for (int i = 0; i < RW_RATE_POINTS; i++)
        sum += excess[i] * step[i];
    return sum / sqrt((part.right - part.left) * p->half);
}

void rw_rates_free_ratio(rw_fronts *f, const rw_problem *p, const rw_zones *zones, double ratio[2])
{
    rw_stuck s;
    const int sign = first_sign(zones);
    const bool is_known = solve(f, p, zones, sign, &s);
    for (int side = 0; side < 2; side++)
        ratio[side] = is_known ? ratio_at(p, zones, sign, &s, side) : NAN;
}

void rw_rates_ratio(rw_fronts *f, const rw_problem *p, const rw_zones *zones, double ratio[2])
{
    rw_rates_free_ratio(f, p, zones, ratio);
    for (int side = 0; side < 2; side++)
        ratio[side] = isnan(ratio[side]) ? NAN : fmax(-1, fmin(1, ratio[side]));
}

/* What slips the same way in both. */
static rw_zones common_slip(const rw_zones *old, const rw_zones *after)
{
    rw_zones begun = {1, {{0, old->zone[0].left, old->zone[old->count - 1].right}}};
    for (int i = 0; i < old->count; i++)
        for (int k = 0; k < after->count; k++) {
            const rw_zone a = old->zone[i], b = after->zone[k];
            const double left = k == 0 ? -HUGE_VAL : b.left; /* the contact may recede */
            const double right = k + 1 == after->count ? HUGE_VAL : b.right;
            const rw_zones both = {1, {{a.label, fmax(a.left, left), fmin(a.right, right)}}};
            if (a.label != 0 && a.label == b.label && both.zone[0].left < both.zone[0].right)
                rw_pattern_insert(&begun, &both, 0);
        }
    return begun;
}

/* ---- Fronts that stick grows from ---- */

/* A front inside of a zone that slipped before: that of which zone, the end of what sticks, and how
 * far it may move. */
typedef struct {
    int zone, end;
    double least, most;
} free_front;

static int free_fronts(const rw_zones *old, const rw_zones *begun, free_front fronts[])
{
    int count = 0, ends = begun->zone[0].label == 0;
    for (int i = 0; i + 1 < begun->count; i++) {
        const rw_zone zone = begun->zone[i].label != 0 ? begun->zone[i] : begun->zone[i + 1];
        const double x = begun->zone[i].right;
        for (int k = 0; k < old->count; k++)
            if (old->zone[k].label == zone.label && x > old->zone[k].left && x < old->zone[k].right)
                fronts[count++] = (free_front){i, ends, old->zone[k].left, old->zone[k].right};
        ends++;
    }
    return count;
}

static void set_front(rw_zones *zones, int i, double x)
{
    zones->zone[i].right = zones->zone[i + 1].left = x;
}

/* K at the free fronts; NaN where it is not known. */
static void pulls(rw_fronts *f, const rw_problem *p, const rw_zones *zones, int count,
                  const free_front fronts[], double K[])
{
    rw_stuck s;
    double all[RW_MOST_FRONTS];
    const bool is_known = solve(f, p, zones, first_sign(zones), &s);
    if (is_known)
        rw_fronts_singular(&s, all);
    for (int i = 0; i < count; i++)
        K[i] = is_known ? all[fronts[i].end] : NAN;
}

/* One step of Newton's method. The largest move, over the half-width; NaN where it fails. Fronts
 * that come to the end of the zone that slipped stay there. */
static double move_fronts(rw_fronts *f, const rw_problem *p, rw_zones *zones, int *count,
                          free_front fronts[])
{
    static const double SMALL = 1e-6;
    const int n = *count;
    double K[RW_MOST_ZONES], moved[RW_MOST_ZONES], J[RW_MOST_ZONES * RW_MOST_ZONES], most = 0;
    pulls(f, p, zones, n, fronts, K);
    for (int j = 0; j < n; j++) {
        rw_zones beside = *zones;
        set_front(&beside, fronts[j].zone, zones->zone[fronts[j].zone].right + SMALL * p->half);
        pulls(f, p, &beside, n, fronts, moved);
        for (int i = 0; i < n; i++)
            J[i * n + j] = (K[i] - moved[i]) / SMALL;
    }
    if (!rw_solve((size_t)n, 1, J, K))
        return NAN;
    *count = 0;
    for (int j = 0; j < n; j++) {
        const rw_zone *at = &zones->zone[fronts[j].zone];
        const double step =
            fmax(-(at->right - at->left) / 2, fmin((at[1].right - at[1].left) / 2, K[j] * p->half));
        const double x = fmax(fronts[j].least, fmin(fronts[j].most, at->right + step));
        most = fmax(most, fabs(x - at->right) / p->half);
        set_front(zones, fronts[j].zone, x);
        if (x > fronts[j].least && x < fronts[j].most)
            fronts[(*count)++] = fronts[j];
    }
    return most;
}

/* Whether the fronts of these zones are found. */
static bool find_begun(rw_fronts *f, const rw_problem *p, const rw_zones *old, rw_zones *begun)
{
    enum { MOST_TURNS = 12 };
    static const double CLOSE = 1e-9;
    free_front fronts[RW_MOST_ZONES];
    int count = free_fronts(old, begun, fronts);
    double move = count > 0 ? HUGE_VAL : 0;
    for (int turn = 0; turn < MOST_TURNS && count > 0 && isgreater(move, CLOSE); turn++)
        move = move_fronts(f, p, begun, &count, fronts); /* NaN where it fails */
    return islessequal(move, CLOSE) || count == 0;
}

rw_zones rw_rates_begun(rw_fronts *f, const rw_problem *p, const rw_zones *old,
                        const rw_zones *after)
{
    const rw_zones common = common_slip(old, after);
    rw_zones begun = common;
    return find_begun(f, p, old, &begun) ? begun : common;
}

/* ---- The error at the beginning ---- */

static bool is_at_edge(const rw_zones *zones, int i)
{
    return i == 0 || i + 1 == zones->count;
}

static bool slips_so(const rw_zones *zones, rw_zone zone)
{
    const rw_zones alone = {1, {zone}}, begun = common_slip(&alone, zones);
    return zone.label == 0 || begun.count > 1 || begun.zone[0].label != 0;
}

/* Adds a zone of slip within the contact. */
static void add_zone(rw_zones *zones, rw_zone zone, rw_patch contact)
{
    zone.left = fmax(zone.left, contact.left);
    zone.right = fmin(zone.right, contact.right);
    rw_pattern_insert(zones, &(rw_zones){1, {zone}}, 0);
}

double rw_rates_error_at_start(rw_fronts *f, const rw_problem *p, const rw_zones *old,
                               const rw_zones *after)
{
    const rw_zones begun = rw_rates_begun(f, p, old, after);
    double most = rw_rates_wrong(f, p, &begun, after);
    for (int i = 0; i < after->count; i++) {
        rw_zones more = begun;
        if (!is_at_edge(after, i) || slips_so(old, after->zone[i]))
            continue;
        add_zone(&more, after->zone[i], p->to);
        most = fmax(most, rw_rates_wrong(f, p, &more, after));
    }
    for (int i = 0; i < old->count; i++) {
        rw_zones more = begun;
        if (slips_so(after, old->zone[i]))
            continue;
        add_zone(&more, old->zone[i], p->to);
        most = fmax(most, slip_in(f, p, &more, old->zone[i]));
    }
    return most;
}

/* The parts that slip before a step and stick in the zones `begun`, wider than `least`. */
static int stopped_parts(const rw_zones *old, const rw_zones *begun, double least, rw_zone parts[])
{
    int count = 0;
    for (int i = 0; i < old->count; i++)
        for (int k = 0; k < begun->count; k++) {
            const rw_zone zone = old->zone[i], other = begun->zone[k];
            const rw_zone part = {zone.label, fmax(zone.left, other.left),
                                  fmin(zone.right, other.right)};
            if (zone.label != 0 && other.label == 0 && part.right - part.left > least)
                parts[count++] = part;
        }
    return count;
}

double rw_rates_excess_at_start(rw_fronts *f, const rw_problem *p, const rw_zones *old,
                                const rw_zones *after, double least)
{
    const rw_zones begun = common_slip(old, after);
    rw_zone parts[2 * RW_MOST_ZONES];
    const int count = stopped_parts(old, &begun, least, parts);
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, mean_excess_in(f, p, &begun, parts[i]));
    return most;
}

/* The largest excess of a place whose excess is a parabola in time: 0 with this rate at the
 * beginning, -room at the end; or 0 again when the contact leaves the place. */
static double lingering_excess(const rw_problem *p, double x, double rate, rw_patch after,
                               double room)
{
    const int side = x > after.right;
    const double edge_before = rw_patch_edge(p->to, side), edge_after = rw_patch_edge(after, side);
    return rw_patch_has(after, x) ? rate * rate / (4 * (rate + fmax(0, room)))
                                  : rate / 4 * (edge_before - x) / (edge_before - edge_after);
}

/* Next to an end of the part the rate may be like 1/sqrt. Its largest value then depends on where
 * it is read: too large an error is told rather than too small a one. */
static double lingering_excess_in(rw_fronts *f, const rw_problem *p, const rw_zones *begun,
                                  rw_zone part, rw_patch after, const rw_traction *traction)
{
    double x[RW_RATE_POINTS], step[RW_RATE_POINTS], rate[RW_RATE_POINTS], F[RW_RATE_POINTS];
    double most = 0;
    if (!excess_in(f, p, begun, part, x, step, rate))
        return 0;
    rw_exact_frictions(p->frame, after, RW_RATE_POINTS, x, F);
    for (int i = 0; i < RW_RATE_POINTS; i++)
        if (rate[i] > 0)
            most = fmax(most, lingering_excess(p, x[i], rate[i], after,
                                               F[i] - part.label * rw_traction_at(traction, x[i])));
    return most;
}

double rw_rates_lingering_excess(rw_fronts *f, const rw_problem *p, const rw_zones *old,
                                 const rw_zones *after, double least, rw_patch contact_after,
                                 const rw_traction *traction_after)
{
    rw_zones begun = common_slip(old, after);
    rw_zone parts[2 * RW_MOST_ZONES];
    if (stopped_parts(old, &begun, least, parts) == 0 || !find_begun(f, p, old, &begun))
        return 0;
    const int count = stopped_parts(old, &begun, least, parts);
    double most = 0;
    for (int i = 0; i < count; i++)
        most =
            fmax(most, lingering_excess_in(f, p, &begun, parts[i], contact_after, traction_after));
    return most;
}

/* ---- Power ---- */

/* The power in a zone, from the front on. */
static double power_in(const rw_fronts *f, const rw_stuck *s, rw_zone zone)
{
    double front, slip = 0, power = 0;
    double x[RW_RATE_POINTS], step[RW_RATE_POINTS], rate[RW_RATE_POINTS], F[RW_RATE_POINTS];
    const double length = from_front(s, zone, &front);
    rate_points(front, length, x, step);
    rates_at(f, s, false, x, rate);
    rw_exact_frictions(f->problem->frame, f->problem->to, RW_RATE_POINTS, x, F);
    for (int i = 0; i < RW_RATE_POINTS; i++) {
        const double more = rate[i] * step[i];
        power -= zone.label * (slip + more / 2) * F[i] * fabs(step[i]);
        slip += more;
    }
    return fmax(0, power);
}

double rw_rates_power(rw_fronts *f, const rw_problem *p, const rw_zones *zones)
{
    const int first = first_sign(zones);
    double power = 0;
    for (int sign = first; sign != 0 && (sign == first || sign == -first); sign -= 2 * first) {
        rw_stuck s;
        if (!solve(f, p, zones, sign, &s))
            return NAN;
        for (int i = 0; i < zones->count; i++)
            if (zones->zone[i].label == sign)
                power += power_in(f, &s, zones->zone[i]);
    }
    return power;
}
