/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/outcome.h"

#include "base/domain.h"
#include "base/sort.h"
#include "base/tuned.h"
#include "traction/transform.h"

/* Kinks, bends and the edges. */
enum { MOST_BREAKS = RW_MOST_KINKS + RW_MOST_BENDS + 2 };

/* Breaks that are closer, over the width, are one. */
static const double SAME_BREAK = 1e-8;

static double fit_tolerance(const rw_problem *p)
{
    const double part = rw_problem_change(p) / (RW_SMALL_STEP * p->scale);
    return RW_FIT * fmax(RW_BEST_FIT, fmin(1, part)) * (p->frame->tolerance * p->scale);
}

/* ---- The new traction ---- */

typedef struct {
    const rw_problem *problem;
    const rw_zones *zones;
    rw_stuck stuck;
    const rw_fronts *fronts;
    const rw_grid *grid;     /* NULL: by the fronts */
    const rw_layers *layers; /* of the grid */
} after;

/* Unlike bodies slip in a rim that runs with an edge that grows: what sticks there goes beyond
 * friction by little, and is cut off. */
static void cut_rim(const rw_problem *p, const double x[], const double F[], double t[])
{
    for (int i = 0; i < RW_TERMS && p->after->own; i++)
        if (!rw_patch_has(p->from, x[i]) && fabs(t[i]) - F[i] < RW_RIM * p->scale)
            t[i] = fmax(-F[i], fmin(F[i], t[i]));
}

/* The places are of one zone, but where the ends of a narrow one are one break. */
static void traction_after(const double x[], const void *context, double t[])
{
    const after *n = context;
    int label[RW_TERMS];
    double F[RW_TERMS];
    bool sticks = false;
    for (int i = 0; i < RW_TERMS; i++) {
        label[i] = rw_zones_label(n->zones, x[i]);
        sticks = sticks || label[i] == 0;
    }
    if (sticks && n->grid)
        rw_base_traction(n->problem, n->layers, RW_TERMS, x, t);
    else if (sticks)
        rw_fronts_stick_traction(n->fronts, &n->stuck, RW_TERMS, x, t);
    rw_friction_after(n->problem, RW_TERMS, x, F);
    if (sticks)
        cut_rim(n->problem, x, F, t);
    for (int i = 0; i < RW_TERMS; i++)
        if (label[i] != 0)
            t[i] = label[i] * F[i];
        else if (n->grid)
            t[i] = fmax(-F[i], fmin(F[i], t[i] + rw_grid_change(n->grid, x[i])));
}

static bool sticks_at(const rw_zones *zones, double x, double slack)
{
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label == 0 && x > zones->zone[i].left + slack &&
            x < zones->zone[i].right - slack)
            return true;
    return false;
}

/* Takes out the kink with the nearest neighbours: many are of a front that receded step by step,
 * and weak. One alone may be of an earlier cycle, where the traction is like a root. */
static void thin_kinks(double kink[], int *n)
{
    int out = 1;
    for (int i = 2; i + 1 < *n; i++)
        if (kink[i + 1] - kink[i - 1] < kink[out + 1] - kink[out - 1])
            out = i;
    --*n;
    for (int i = out; i < *n; i++)
        kink[i] = kink[i + 1];
}

/* The kinks after the step: its fronts, and the old kinks in zones that stick. */
static void note_kinks(const rw_problem *p, rw_shear_state *s)
{
    const double slack = SAME_BREAK * (p->to.right - p->to.left);
    const double edge[2] = {p->from.left, p->from.right};
    double kink[RW_MOST_KINKS + 2];
    int n = 0;
    for (int i = 0; i < 2; i++)
        if (p->grows[i] && sticks_at(&s->zones, edge[i], slack))
            kink[n++] = edge[i];
    for (int i = 0; i < p->old->kinks; i++)
        if (sticks_at(&s->zones, p->old->kink[i], slack))
            kink[n++] = p->old->kink[i];
    rw_sort(kink, (size_t)n);
    s->kinks = s->zones.count - 1;
    for (int i = 0; i < s->kinks; i++)
        s->kink[i] = s->zones.zone[i].right;
    while (n > RW_MOST_KINKS - s->kinks)
        thin_kinks(kink, &n);
    for (int i = 0; i < n; i++)
        s->kink[s->kinks++] = kink[i];
    rw_sort(s->kink, (size_t)s->kinks);
}

static bool is_front(const rw_zones *zones, double x)
{
    for (int i = 0; i + 1 < zones->count; i++)
        if (zones->zone[i].right == x)
            return true;
    return false;
}

void rw_shear_state_smooth(rw_shear_state *s, rw_patch contact, double tolerance)
{
    int kept = 0;
    for (int i = 0; i < s->kinks; i++) {
        const double from = kept > 0 ? s->kink[kept - 1] : contact.left;
        const double to = i + 1 < s->kinks ? s->kink[i + 1] : contact.right;
        if (is_front(&s->zones, s->kink[i]) ||
            !rw_traction_is_smooth(&s->traction, from, s->kink[i], to, RW_FIT * tolerance))
            s->kink[kept++] = s->kink[i];
    }
    s->kinks = kept;
}

static int breaks_of(const rw_problem *p, const rw_shear_state *s, double at[])
{
    double all[MOST_BREAKS];
    const size_t n = rw_breaks_of(p->frame, p->to, s->kinks, s->kink, all);
    int kept = 0;
    for (size_t i = 0; i < n; i++)
        if (kept == 0 || all[i] - at[kept - 1] > SAME_BREAK * (p->to.right - p->to.left))
            at[kept++] = all[i];
    at[kept - 1] = p->to.right;
    return kept;
}

/* ---- Conditions ---- */

static void add_wrong(rw_outcome *o, int label, double left, double right)
{
    rw_zones_insert(&o->wrong, o->wrong.count, (rw_zone){label, left, right});
}

/* Notes slip where the traction is too large, and a little beyond: next to a kink the traction may
 * be too large over less than the distance of points. */
static void add_slip(rw_outcome *o, int label, double left, double right)
{
    const double margin = 0.05 * (right - left);
    add_wrong(o, label, left - margin, right + margin);
}

/* Notes where the traction of a zone that sticks exceeds friction, between two breaks. */
static void check_friction(const rw_problem *p, rw_outcome *o, double from, double to)
{
    double begun = NAN, before = from, node[RW_CHECKS], weight[RW_CHECKS];
    double x[RW_CHECKS], t[RW_CHECKS], F[RW_CHECKS];
    int label = 0;
    rw_half_circle(RW_CHECKS, node, weight);
    for (int i = 0; i < RW_CHECKS; i++)
        x[i] = from + (to - from) * node[i];
    rw_traction_values(&o->state.traction, RW_CHECKS, x, t);
    rw_friction_after(p, RW_CHECKS, x, F);
    for (int i = 0; i < RW_CHECKS; i++) {
        const double excess = (fabs(t[i]) - F[i]) / p->scale;
        o->violation = fmax(o->violation, excess);
        if (excess > p->allowed && isnan(begun)) {
            begun = before;
            label = t[i] > 0 ? 1 : -1;
        } else if (!(excess > p->allowed) && !isnan(begun)) {
            add_slip(o, label, begun, x[i]);
            begun = NAN;
        }
        before = x[i];
    }
    if (!isnan(begun))
        add_slip(o, label, begun, to);
}

/* The move of a place that sticks and was in contact before: dw is the constant of all that sticks.
 * NaN where no such place is left. */
static double rigid_move(const rw_problem *p, const rw_shear_state *s)
{
    const rw_patch stuck = rw_zones_widest_stick(&s->zones, p->from);
    const double width = stuck.right - stuck.left, x = stuck.left + 0.37 * width;
    return width > 0 ? rw_traction_displacement(&s->traction, x) -
                           rw_traction_displacement(&p->old->traction, x) + p->stretch * x
                     : NAN;
}

/* ---- Slip ---- */

/* The way through the parts of a slip zone, from where it sticks outwards. */
typedef struct {
    const after *after;
    rw_outcome *outcome;
    int label;
    double slip; /* at the end of the last part */
} slipping;

/* Places that the contact takes in or leaves as it slips move by less than dw, because they touch
 * for a part of the time: by less than under friction that changes as a layer. */
static void add_slopes_of_layers(const slipping *s, size_t n, const double x[], double slope[])
{
    const rw_problem *p = s->after->problem;
    const rw_layers *layers = &s->after->fronts->layers;
    double sum[RW_TERMS] = {0}, layer[RW_TERMS];
    for (int k = 0; k < layers->count; k++) {
        rw_layer_slopes(p, k, n, x, layer);
        for (size_t i = 0; i < n; i++)
            sum[i] += layers->weight[k] * layer[i];
    }
    rw_layer_slopes(p, 0, n, x, layer);
    for (size_t i = 0; i < n; i++)
        slope[i] += sum[i] - s->label * layer[i];
}

/* The slip at the nodes between two places. */
static void add_slip_between(slipping *s, double from, double to, const double x[], double slip[])
{
    const after *n = s->after;
    const rw_fronts *f = n->fronts;
    const bool is_passed =
        !rw_patch_has(n->problem->from, x[0]) || !rw_patch_has(n->problem->to, x[0]);
    double slope[RW_TERMS];
    for (int i = 0; i < f->order && n->grid; i++)
        slip[i] = rw_grid_slip(n->grid, x[i]);
    if (n->grid)
        return;
    rw_fronts_slope(f, &n->stuck, s->label, (size_t)f->order, x, slope);
    if (is_passed)
        add_slopes_of_layers(s, (size_t)f->order, x, slope);
    for (int i = 0; i <= f->order; i++) {
        slip[i] = s->slip;
        for (int j = 0; j < f->order; j++)
            slip[i] += (to - from) * f->integral[i][j] * slope[j];
    }
    s->slip = slip[f->order];
}

/* The mean of friction over a step. Next to an edge that moves, its square is linear in time. */
static double mean_friction(double first, double last)
{
    return first + last > 0
               ? 2.0 / 3 * (first * first + first * last + last * last) / (first + last)
               : 0;
}

/* How far friction is from its mean, at most. Where an edge passes dw is not slip alone. */
static double friction_doubt(const rw_problem *p, double x, double first, double last)
{
    const bool is_passed = !rw_patch_has(p->from, x) || !rw_patch_has(p->to, x);
    return is_passed ? fmax(first, last) : fabs(last - first);
}

/* The part of a step in which a place is in contact. */
static double time_in_contact(const rw_problem *p, double x)
{
    const double left = fmax(p->from.left, p->to.left), right = fmin(p->from.right, p->to.right);
    return x < left    ? (x - p->both.left) / (left - p->both.left)
           : x > right ? (p->both.right - x) / (p->both.right - right)
                       : 1;
}

static void check_slip_part(slipping *s, double from, double to)
{
    const rw_problem *p = s->after->problem;
    const rw_fronts *f = s->after->fronts;
    /* what is wrong on both sides of a break is one part; but an edge that does not grow slips */
    const double least = p->grows[0] ? -HUGE_VAL : p->to.left;
    const double most = p->grows[1] ? HUGE_VAL : p->to.right;
    double begun = NAN, last = from;
    double x[RW_TERMS], now[RW_TERMS], before[RW_TERMS], slip[RW_TERMS + 1];
    for (int i = 0; i < f->order; i++)
        x[i] = from + (to - from) * f->node[i];
    add_slip_between(s, from, to, x, slip);
    rw_friction_after(p, (size_t)f->order, x, now);
    rw_friction_before(p, (size_t)f->order, x, before);
    for (int i = 0; i < f->order; i++) {
        const double step = fabs(to - from) * f->weight[i];
        s->outcome->energy -=
            s->label * slip[i] * mean_friction(before[i], now[i]) * time_in_contact(p, x[i]) * step;
        s->outcome->doubt += fabs(slip[i]) * friction_doubt(p, x[i], before[i], now[i]) * step;
        if (!rw_patch_has(p->to, x[i]))
            continue;
        const double excess = s->label * slip[i] / (p->scale * p->half);
        s->outcome->violation = fmax(s->outcome->violation, excess);
        if (excess > p->allowed) {
            begun = !isnan(begun) ? begun : i == 0 ? from : x[i];
            last = i + 1 == f->order && to > least && to < most ? to : x[i];
        }
    }
    if (!isnan(begun))
        add_wrong(s->outcome, 0, fmin(begun, last), fmax(begun, last));
}

/* The slip and its work in a zone, and where the contact has left places beyond. */
static void check_slip(slipping *s, int zone)
{
    const rw_problem *p = s->after->problem;
    const rw_zones *zones = s->after->zones;
    const rw_zone z = zones->zone[zone];
    double at[RW_MOST_BREAKS];
    const bool is_leftmost = zone == 0;
    const int n = rw_breaks_between(p, is_leftmost ? p->both.left : z.left,
                                    zone + 1 == zones->count ? p->both.right : z.right, at);
    s->slip = 0;
    s->label = z.label;
    for (int i = 0; i + 1 < n; i++) {
        const double *part = at + (is_leftmost ? n - 2 - i : i);
        if (part[1] > part[0] && z.label != 0)
            check_slip_part(s, part[is_leftmost], part[!is_leftmost]);
    }
}

static void check_slips(const after *n, rw_outcome *o)
{
    slipping s = {.after = n, .outcome = o};
    for (int i = 0; i < n->zones->count; i++)
        check_slip(&s, i);
}

/* The fit changes the load a little: the difference is spread over the zones that stick, evenly but
 * for their ends: next to a jump of the traction the stress would have no bound. */
static void balance(const rw_problem *p, rw_shear_state *s)
{
    const double lost =
        rw_traction_total(&p->old->traction) + p->shear - rw_traction_total(&s->traction);
    double width = 0;
    for (int i = 0; i < s->zones.count; i++)
        if (s->zones.zone[i].label == 0)
            width += s->zones.zone[i].right - s->zones.zone[i].left;
    for (int i = 0; i < s->zones.count; i++) {
        const rw_zone zone = s->zones.zone[i];
        if (zone.label == 0)
            rw_traction_raise(&s->traction, zone.left, zone.right, lost / width);
    }
}

static bool complete(const after *n, double tolerance, rw_outcome *o)
{
    const rw_problem *p = n->problem;
    double at[MOST_BREAKS];
    note_kinks(p, &o->state);
    const int breaks = breaks_of(p, &o->state, at);
    o->is_short = !rw_traction_fit(&o->state.traction, traction_after, n, (size_t)breaks, at,
                                   tolerance, RW_FIT_NOISE);
    if (!o->is_short) {
        balance(p, &o->state);
        for (int i = 0; i + 1 < breaks; i++)
            if (rw_zones_label(n->zones, at[i] / 2 + at[i + 1] / 2) == 0)
                check_friction(p, o, at[i], at[i + 1]);
        check_slips(n, o);
        o->move = rigid_move(p, &o->state); /* a sum over all elements, as the energy is */
        if (isfinite(o->move + o->energy))
            return true;
    }
    rw_traction_destroy(&o->state.traction);
    return false;
}

/* The zones of fronts, with the quadrature for what is between them. */
static after prepare(rw_fronts *f, rw_outcome *o)
{
    *o = (rw_outcome){.violation = 0};
    o->layers = rw_fronts_zones(f, &o->state.zones);
    for (int side = 0, i = f->fronts; side < 2; side++)
        o->D[side] = f->sticks_to_edge[side] ? f->y[i++] : NAN;
    rw_fronts_collect(f, &o->state.zones, &o->layers, f->finest);
    rw_fronts_prepare(f);
    return (after){f->problem, &o->state.zones, rw_stuck_of(f, &o->state.zones), f, NULL, NULL};
}

bool rw_outcome_of_fronts(rw_fronts *f, rw_outcome *o)
{
    const after n = prepare(f, o);
    return complete(&n, fit_tolerance(f->problem), o);
}

void rw_outcome_of_slip(rw_fronts *f, rw_outcome *o)
{
    const after n = prepare(f, o);
    check_slips(&n, o);
}

/* The error of a grid of n places, times n, over friction. */
static const double GRID_ERROR = 0.3;

bool rw_outcome_of_grid(const rw_fronts *f, const rw_grid *g, const rw_problem *p,
                        const rw_layers *layers, rw_outcome *o)
{
    const double error = GRID_ERROR / g->n;
    *o = (rw_outcome){.violation = error, .drift = error, .layers = *layers, .D = {NAN, NAN}};
    rw_grid_zones_met(g, p, &o->state.zones);
    const after n = {p, &o->state.zones, {.count = 0}, f, g, layers};
    return complete(&n, fmax(fit_tolerance(p), RW_FIT * error * p->scale), o);
}
