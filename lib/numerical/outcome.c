/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/outcome.h"

#include "base/domain.h"
#include "base/sort.h"
#include "traction/transform.h"

/* Points between neighbouring breaks, for Coulomb's condition and for slip. */
enum { CHECKS = 24, SLIPS = 8 };

/* Kinks, bends and the edges. */
enum { MOST_BREAKS = RW_MOST_KINKS + RW_MOST_BENDS + 2 };

/* Of the width: breaks that are closer are one. */
static const double SAME_BREAK = 1e-8;

/* The tolerance of the fit of a traction, over that of the step. */
static const double FIT = 0.03;

void rw_shear_state_destroy(rw_shear_state *state)
{
    rw_traction_destroy(&state->traction);
}

/* ---- The new traction ---- */

typedef struct {
    const rw_problem *problem;
    const rw_zones *zones;
    const rw_fronts *fronts; /* NULL: by the grid */
    const rw_grid *grid;
    const rw_layers *layers; /* of the grid */
} after;

static int label_at(const rw_zones *zones, double x)
{
    int i = 0;
    while (i + 1 < zones->count && x > zones->zone[i].right)
        i++;
    return zones->zone[i].label;
}

static double traction_after(double x, const void *context)
{
    const after *n = context;
    const int label = label_at(n->zones, x);
    if (label != 0)
        return label * rw_friction_after(n->problem, x);
    if (n->fronts)
        return rw_fronts_stick_traction(n->fronts, n->zones, x);
    const double F = rw_friction_after(n->problem, x);
    const double t = rw_base_traction(n->problem, n->layers, x) + rw_grid_change(n->grid, x);
    return fmax(-F, fmin(F, t));
}

static bool sticks_at(const rw_zones *zones, double x, double slack)
{
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label == 0 && x > zones->zone[i].left + slack &&
            x < zones->zone[i].right - slack)
            return true;
    return false;
}

static void add_kink(rw_shear_state *s, double x)
{
    if (s->kinks < RW_MOST_KINKS)
        s->kink[s->kinks++] = x;
}

/* The kinks after the step: its fronts, and the old kinks in zones that stick. */
static void note_kinks(const rw_problem *p, rw_shear_state *s)
{
    const double slack = SAME_BREAK * (p->to.right - p->to.left);
    s->kinks = 0;
    for (int i = 0; i + 1 < s->zones.count; i++)
        add_kink(s, s->zones.zone[i].right);
    const double edge[2] = {p->from.left, p->from.right};
    for (int i = 0; i < 2; i++)
        if (p->grows[i] && sticks_at(&s->zones, edge[i], slack))
            add_kink(s, edge[i]);
    for (int i = 0; i < p->old->kinks; i++)
        if (sticks_at(&s->zones, p->old->kink[i], slack))
            add_kink(s, p->old->kink[i]);
    rw_sort(s->kink, (size_t)s->kinks);
}

static bool is_front(const rw_zones *zones, double x)
{
    for (int i = 0; i + 1 < zones->count; i++)
        if (zones->zone[i].right == x)
            return true;
    return false;
}

static double traction_of(double x, const void *context)
{
    return rw_traction_at(context, x);
}

/* Two elements are enough. */
static bool is_smooth(const rw_traction *t, double from, double to, double tolerance)
{
    rw_traction fit = {0};
    const double at[2] = {from, to};
    const bool is_fit = rw_traction_fit(&fit, traction_of, t, 2, at, tolerance) && fit.count == 2;
    rw_traction_destroy(&fit);
    return is_fit;
}

void rw_shear_state_smooth(rw_shear_state *s, rw_patch contact, double tolerance)
{
    int kept = 0;
    for (int i = 0; i < s->kinks; i++) {
        const double from = kept > 0 ? s->kink[kept - 1] : contact.left;
        const double to = i + 1 < s->kinks ? s->kink[i + 1] : contact.right;
        if (is_front(&s->zones, s->kink[i]) || !is_smooth(&s->traction, from, to, FIT * tolerance))
            s->kink[kept++] = s->kink[i];
    }
    s->kinks = kept;
}

static int breaks_of(const rw_problem *p, const rw_shear_state *s, double at[])
{
    double all[MOST_BREAKS];
    int n = 0, kept = 0;
    all[n++] = p->to.left;
    for (int i = 0; i < s->kinks; i++)
        all[n++] = s->kink[i];
    n += rw_bends_between(p->frame, p->to.left, p->to.right, all + n);
    all[n++] = p->to.right;
    rw_sort(all, (size_t)n);
    for (int i = 0; i < n; i++)
        if (kept == 0 || all[i] - at[kept - 1] > SAME_BREAK * (p->to.right - p->to.left))
            at[kept++] = all[i];
    at[kept - 1] = p->to.right;
    return kept;
}

/* ---- Conditions ---- */

static void add_wrong(rw_outcome *o, int label, double left, double right)
{
    if (o->wrong.count < RW_MOST_ZONES && right > left)
        o->wrong.zone[o->wrong.count++] = (rw_zone){label, left, right};
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
    double begun = NAN, before = from;
    int label = 0;
    for (int i = 0; i < CHECKS; i++) {
        const double half = sin(RW_HALF_PI * (i + 0.5) / CHECKS),
                     x = from + (to - from) * half * half;
        const double t = rw_traction_at(&o->state.traction, x);
        const double excess = (fabs(t) - rw_friction_after(p, x)) / p->scale;
        o->violation = fmax(o->violation, excess);
        if (excess > p->allowed && isnan(begun)) {
            begun = before;
            label = t > 0 ? 1 : -1;
        } else if (!(excess > p->allowed) && !isnan(begun)) {
            add_slip(o, label, begun, x);
            begun = NAN;
        }
        before = x;
    }
    if (!isnan(begun))
        add_slip(o, label, begun, to);
}

/* dw, up to the constant. */
static double change_of_displacement(const rw_problem *p, const rw_outcome *o, double x)
{
    return rw_traction_displacement(&o->state.traction, x) -
           rw_traction_displacement(&p->old->traction, x) + p->stretch * x;
}

/* The displacement of places that a growing contact takes in as it slips: they move by less than
 * dw, because they touch later. It is that of f times the added pressure. */
typedef struct {
    rw_traction layer;
    double constant;
} attached;

static double layer_at(double x, const void *context)
{
    const rw_problem *p = context;
    return rw_friction_after(p, x) - rw_friction_before(p, x);
}

static double attached_displacement(const rw_problem *p, const attached *a, double x)
{
    return rw_traction_displacement(&a->layer, x) - p->f * p->tilt[0] * (x - p->middle) -
           a->constant;
}

static bool attach(const rw_problem *p, attached *a, double origin)
{
    double all[4 + RW_MOST_BENDS] = {p->from.left, p->to.left, p->from.right, p->to.right},
                   at[4 + RW_MOST_BENDS];
    const int count = 4 + rw_bends_between(p->frame, p->both.left, p->both.right, all + 4);
    int n = 0;
    rw_sort(all, (size_t)count);
    for (int i = 0; i < count; i++)
        if (n == 0 || all[i] > at[n - 1])
            at[n++] = all[i];
    *a = (attached){{0}, 0};
    if (!rw_traction_fit(&a->layer, layer_at, p, (size_t)n, at, FIT * p->tolerance))
        return false;
    a->constant = attached_displacement(p, a, origin);
    return true;
}

/* A place that sticks and was in contact before: its dw is the constant of all that sticks. */
static bool anchor(const rw_problem *p, const rw_zones *zones, double *x)
{
    double widest = 0;
    for (int i = 0; i < zones->count; i++) {
        const double left = fmax(zones->zone[i].left, p->from.left);
        const double right = fmin(zones->zone[i].right, p->from.right);
        if (zones->zone[i].label == 0 && right - left > widest) {
            widest = right - left;
            *x = left + 0.37 * widest;
        }
    }
    return widest > 0;
}

typedef struct {
    const rw_problem *problem;
    rw_outcome *outcome;
    const attached *attached; /* NULL where the edge does not grow */
    int label;                /* 0: the contact has left it */
    double node[SLIPS], weight[SLIPS];
} slipping;

static void check_slip_part(slipping *s, double from, double to)
{
    const rw_problem *p = s->problem;
    /* what is wrong on both sides of a break is one part; but an edge that does not grow slips */
    const double least = p->grows[0] ? -HUGE_VAL : p->to.left;
    const double most = p->grows[1] ? HUGE_VAL : p->to.right;
    double begun = NAN, last = from;
    for (int i = 0; i < SLIPS; i++) {
        const double half = sin(RW_HALF_PI * s->node[i]), x = from + (to - from) * half * half;
        const double step = s->weight[i] * RW_HALF_PI * (to - from) * sin(RW_PI * s->node[i]);
        double slip = change_of_displacement(p, s->outcome, x) - s->outcome->move;
        const double now = rw_friction_after(p, x);
        const double before = p->is_still ? now : rw_friction_before(p, x);
        if (s->attached)
            slip -= s->label * attached_displacement(p, s->attached, x);
        if (s->label == 0) {
            s->outcome->energy += fabs(slip) * before / 2 * step;
            continue;
        }
        s->outcome->energy -= s->label * slip * (before + now) / 2 * step;
        const double excess = s->label * slip / (p->scale * p->half);
        s->outcome->violation = fmax(s->outcome->violation, excess);
        if (excess > p->allowed) {
            begun = !isnan(begun) ? begun : i == 0 && from > least ? from : x;
            last = i + 1 == SLIPS && to < most ? to : x;
        }
    }
    if (!isnan(begun))
        add_wrong(s->outcome, 0, begun, last);
}

/* The slip and its work between two breaks, in parts between the old kinks and edges there. */
static void check_slip(slipping *s, double from, double to)
{
    const rw_problem *p = s->problem;
    double begun = from;
    for (int i = -1; i <= p->old->kinks; i++) {
        const double at = i < 0               ? p->from.left
                          : i < p->old->kinks ? p->old->kink[i]
                                              : p->from.right;
        if (at > begun && at < to) {
            check_slip_part(s, begun, at);
            begun = at;
        }
    }
    check_slip_part(s, begun, to);
}

static bool check(const rw_problem *p, rw_outcome *o, int breaks, const double at[])
{
    double origin = p->middle;
    if (!anchor(p, &o->state.zones, &origin))
        return false;
    o->move = change_of_displacement(p, o, origin);
    attached growth = {{0}, 0};
    const bool grows = p->grows[0] || p->grows[1];
    if (grows && !attach(p, &growth, origin))
        return false;
    slipping s = {.problem = p, .outcome = o};
    rw_gauss(SLIPS, s.node, s.weight);
    for (int i = 0; i + 1 < breaks; i++) {
        s.label = label_at(&o->state.zones, at[i] / 2 + at[i + 1] / 2);
        const bool at_left = at[i + 1] <= o->state.zones.zone[0].right;
        const bool at_right = at[i] >= o->state.zones.zone[o->state.zones.count - 1].left;
        s.attached = (at_left && p->grows[0]) || (at_right && p->grows[1]) ? &growth : NULL;
        if (s.label == 0)
            check_friction(p, o, at[i], at[i + 1]);
        else
            check_slip(&s, at[i], at[i + 1]);
    }
    s.label = 0;
    s.attached = NULL;
    if (p->both.left < p->to.left)
        check_slip(&s, p->both.left, p->to.left);
    if (p->both.right > p->to.right)
        check_slip(&s, p->to.right, p->both.right);
    rw_traction_destroy(&growth.layer);
    return true;
}

static bool is_finite(const rw_outcome *o)
{
    for (size_t i = 0; i < o->state.traction.count; i++)
        for (int k = 0; k < RW_TERMS; k++)
            if (!isfinite(o->state.traction.elements[i].coefficient[k]))
                return false;
    return isfinite(o->violation) && isfinite(o->energy) && isfinite(o->move);
}

/* The fit changes the load a little: the difference is spread evenly over the zones that stick. */
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
            rw_traction_shift(&s->traction, zone.left, zone.right, lost / width);
    }
}

static bool complete(const after *n, rw_outcome *o)
{
    const rw_problem *p = n->problem;
    double at[MOST_BREAKS];
    note_kinks(p, &o->state);
    const int breaks = breaks_of(p, &o->state, at);
    if (rw_traction_fit(&o->state.traction, traction_after, n, (size_t)breaks, at,
                        FIT * p->tolerance)) {
        balance(p, &o->state);
        if (check(p, o, breaks, at) && is_finite(o))
            return true;
    }
    rw_shear_state_destroy(&o->state);
    return false;
}

bool rw_outcome_of_fronts(rw_fronts *f, rw_outcome *o)
{
    *o = (rw_outcome){.violation = 0};
    const rw_layers layers = rw_fronts_zones(f, &o->state.zones);
    if (!rw_fronts_prepare_stick(f, &o->state.zones, &layers))
        return false;
    const after n = {f->problem, &o->state.zones, f, NULL, NULL};
    return complete(&n, o);
}

bool rw_outcome_of_grid(const rw_grid *g, const rw_problem *p, const rw_layers *layers,
                        rw_outcome *o)
{
    *o = (rw_outcome){.violation = 0};
    if (!rw_grid_zones(g, p, &o->state.zones))
        return false;
    const after n = {p, &o->state.zones, NULL, g, layers};
    return complete(&n, o);
}

bool rw_outcome_of_state(const rw_problem *p, const rw_shear_state *state, rw_outcome *o)
{
    double at[MOST_BREAKS];
    *o = (rw_outcome){.state = *state};
    return check(p, o, breaks_of(p, state, at), at);
}
