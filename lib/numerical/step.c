/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/step.h"

#include "base/always.h"
#include "base/domain.h"
#include "base/tuned.h"
#include "numerical/coupled.h"
#include "numerical/rates.h"
#include "traction/transform.h"

double rw_place(rw_patch contact, int i)
{
    return rw_patch_middle(contact) -
           rw_patch_half_width(contact) * cos(RW_PI * (i + 0.5) / RW_PLACES);
}

double rw_peak_of(const rw_frame *frame, const rw_numerical_state *s)
{
    return s->peak > 0 ? s->peak : rw_peak_friction(frame, s->contact);
}

bool rw_edge_grows(const rw_numerical_state *from, const rw_numerical_state *there, int side)
{
    static const double LEAST = 1e-6;
    const double way = rw_patch_edge(there->contact, side) - rw_patch_edge(from->contact, side);
    return (side ? way : -way) > LEAST * rw_patch_half_width(there->contact);
}

rw_patch rw_patch_of_loads(const rw_frame *frame, rw_scaled_loads at)
{
    return frame->is_held ? rw_arcs_patch_of_tilt(&frame->arcs, at.P, at.turn)
                          : rw_arcs_patch_of_moment(&frame->arcs, at.P, at.turn);
}

/* How fast the moment changes on a contact that the step passes. */
static double moment_rate(const rw_frame *frame, rw_patch contact, double P, double turn)
{
    const double half = rw_patch_half_width(contact);
    return frame->is_held ? rw_patch_middle(contact) * P + RW_HALF_PI * half * half * turn : turn;
}

/* Steps share their contacts. NULL where memory is short. */
static const rw_friction *friction_of(rw_work *w, rw_patch contact)
{
    for (int i = 0; i < RW_FRICTIONS; i++)
        if (rw_patch_is_same(w->friction[i].contact, contact) &&
            w->friction[i].tolerance == w->frame->tolerance)
            return &w->friction[i];
    rw_friction *oldest = &w->friction[w->frictions++ % RW_FRICTIONS];
    rw_friction_destroy(oldest);
    const bool is_done = rw_friction_create(oldest, w->frame, contact);
    w->is_short = w->is_short || !is_done;
    return is_done ? oldest : NULL;
}

static bool set_problem(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to,
                        rw_patch contact, rw_problem *p)
{
    const rw_friction *after = friction_of(w, contact), *before = friction_of(w, from->contact);
    if (before && after)
        rw_problem_init(p, w->frame, before, after, &from->shear,
                        to.shear - rw_traction_total(&from->shear.traction),
                        to.stretch - from->at.stretch);
    return before && after;
}

/* What had not slipped before the step, with the places that come into contact beside it. */
static rw_patch never_slipped(const rw_numerical_state *from, const rw_problem *p)
{
    rw_patch patch = from->unslipped;
    patch.left = patch.left == from->contact.left ? p->to.left : patch.left;
    patch.right = patch.right == from->contact.right ? p->to.right : patch.right;
    return patch;
}

void rw_step_rates(const rw_work *w, rw_scaled_loads from, rw_scaled_loads to, rw_patch contact,
                   rw_problem *rates)
{
    const double P = to.P - from.P;
    const double moment = moment_rate(w->frame, contact, P, to.turn - from.turn);
    rw_problem_init_rates(rates, w->frame, contact, P, moment, to.shear - from.shear,
                          to.stretch - from.stretch);
}

/* Sets the step as a problem, with the rates at its ends. */
static bool set_step(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to, rw_problem *p)
{
    const bool is_still = to.P == from->at.P && to.turn == from->at.turn;
    const rw_patch contact = is_still ? from->contact : rw_patch_of_loads(w->frame, to);
    rw_step_rates(w, from->at, to, from->contact, &w->start);
    rw_step_rates(w, from->at, to, contact, &w->end);
    rw_fronts_forget(&w->fronts);
    return set_problem(w, from, to, contact, p);
}

static void note_rate_errors(rw_work *w, const rw_problem *p, const rw_numerical_state *from,
                             rw_numerical_state *there)
{
    const rw_zones *before = &from->shear.zones, *after = &there->shear.zones;
    const double at_start = rw_rates_error_at_start(&w->fronts, &w->start, before, after),
                 at_end = rw_rates_wrong(&w->fronts, &w->end, after, after);
    there->start_error = at_start / p->scale;
    there->end_error = at_end / p->scale;
    there->rate_error = fmax(there->start_error, there->end_error);
}

/* Whether what slips at the edges of the contact begins in the contact before. */
static bool sticks_in_old_contact(const rw_problem *p, const rw_zones *after)
{
    const rw_zone first = after->zone[0], last = after->zone[after->count - 1];
    return first.label != 0 && last.label != 0 && first.right > p->from.left &&
           last.left < p->from.right;
}

/* Whether a step has the right end whatever the way there. Where it slips the traction is that of
 * friction. What sticks must have stuck all the time, and must have been in contact. */
static bool is_exact(rw_work *w, const rw_problem *p, const rw_numerical_state *from,
                     const rw_numerical_state *there)
{
    const rw_zones *after = &there->shear.zones;
    return rw_problem_change(p) <= RW_LARGE_STEP * p->scale &&
           fmax(there->error, there->rate_error) <= p->allowed && sticks_in_old_contact(p, after) &&
           rw_rates_excess_at_start(&w->fronts, &w->start, &from->shear.zones, after,
                                    p->allowed * p->half) <=
               RW_LITTLE_EXCESS * p->allowed * p->scale;
}

void rw_note_outcome(const rw_problem *p, const rw_numerical_state *from, rw_scaled_loads to,
                     const rw_outcome *outcome, rw_numerical_state *there)
{
    *there = (rw_numerical_state){
        .shear = outcome->state,
        .contact = p->to,
        .peak = p->scale,
        .at = to,
        .is_still = from->is_still && p->is_still,
        .unslipped = rw_zones_widest_stick(&outcome->state.zones, never_slipped(from, p)),
        .move = from->move + outcome->move,
        .energy = from->energy + outcome->energy,
        .doubt = outcome->doubt,
        .layers = outcome->layers,
        .D = {outcome->D[0], outcome->D[1]},
        .error = outcome->violation,
        .drift = outcome->drift};
}

void rw_displacements_of(const rw_numerical_state *s, size_t n, const double x[], double w[])
{
    rw_traction_displacements(&s->shear.traction, n, x, w);
    for (size_t i = 0; i < n; i++) {
        const double shear = w[i] + s->at.stretch * x[i];
        w[i] = s->coupling == 0
                   ? shear - s->move
                   : shear - s->coupling * rw_traction_load_to(&s->pressed, x[i]) - s->move;
    }
}

double rw_displacement_of(const rw_numerical_state *s, double x)
{
    double w;
    rw_displacements_of(s, 1, &x, &w);
    return w;
}

static bool step_to(rw_work *w, const rw_problem *p, const rw_numerical_state *from,
                    rw_scaled_loads to, const rw_zones *guess, bool coarse,
                    rw_numerical_state *there)
{
    rw_outcome outcome;
    if (!rw_search(w, p, guess, coarse || w->effort > w->most_effort, &outcome))
        return false;
    rw_note_outcome(p, from, to, &outcome, there);
    note_rate_errors(w, p, from, there);
    there->is_exact = is_exact(w, p, from, there);
    return true;
}

bool rw_implicit_step(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to,
                      const rw_zones *guess, bool coarse, rw_numerical_state *there)
{
    rw_problem p;
    if (w->frame->B != 0)
        return rw_coupled_step(w, from, to, guess, coarse || w->effort > w->most_effort, there);
    if (!set_step(w, from, to, &p))
        return false;
    return step_to(w, &p, from, to, guess, coarse, there);
}

bool rw_step_zones(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to,
                   const rw_zones *guess, bool by_grid, rw_patch *contact, rw_zones *zones)
{
    rw_problem p;
    if (!set_step(w, from, to, &p))
        return false;
    *contact = p.to;
    return rw_search_zones(w, &p, guess, by_grid, zones);
}

/* Slip that lingers: a place slips on for a while, and sticks at the end of the step, which has it
 * sticking from the beginning. The step does not see it, nor do its halves if it has ended
 * half-way. */
static double lingering_error(rw_work *w, const rw_numerical_state *from,
                              const rw_numerical_state *there)
{
    rw_problem rates;
    if (there->is_exact || w->frame->B != 0)
        return 0;
    rw_step_rates(w, from->at, there->at, from->contact, &rates);
    return rw_rates_lingering_excess(&w->fronts, &rates, &from->shear.zones, &there->shear.zones,
                                     RW_ALLOWED * w->frame->tolerance * rates.half, there->contact,
                                     &there->shear.traction) /
           rw_peak_of(w->frame, there);
}

/* Whether all places that stick in `inner` stick in `outer` too. */
static bool is_nested(const rw_zones *inner, const rw_zones *outer, double slack)
{
    for (int i = 0, k = 0; i < inner->count; i++) {
        if (inner->zone[i].label != 0)
            continue;
        while (k + 1 < outer->count && outer->zone[k].right < inner->zone[i].right - slack)
            k++;
        if (outer->zone[k].label != 0 || outer->zone[k].left > inner->zone[i].left + slack)
            return false;
    }
    return true;
}

bool rw_step_goes_on(rw_work *w, const rw_numerical_state *start, const rw_numerical_state *from,
                     rw_numerical_state *there)
{
    rw_problem p;
    rw_outcome outcome;
    if (w->frame->B != 0) /* the pressure changes */
        return false;
    if (!set_problem(w, from, there->at, there->contact, &p) || !p.is_still)
        return false;
    const double lingering = lingering_error(w, start, from);
    rw_fronts_forget(&w->fronts);
    if (fmax(lingering, fmax(from->rate_error, there->rate_error)) > p.allowed ||
        !is_nested(&there->shear.zones, &from->shear.zones, p.allowed * p.half) ||
        !rw_fronts_begin(&w->fronts, &p, &there->shear.zones, (double[2]){NAN, NAN}))
        return false;
    rw_outcome_of_slip(&w->fronts, &outcome);
    if (outcome.violation > p.allowed)
        return false;
    there->energy = from->energy + outcome.energy;
    there->error = fmax(lingering, fmax(from->error, fmax(there->error, outcome.violation)));
    return true;
}

/* ---- The error of a step ---- */

/* Tractions are not compared there: they rise like a square root, and a front moves with the
 * error. */
static bool is_at_front(const rw_numerical_state *s, double x)
{
    bool is_near = false;
    for (int i = 0; i + 1 < s->shear.zones.count; i++)
        is_near = is_near || fabs(x - s->shear.zones.zone[i].right) <
                                 RW_AT_FRONT * rw_patch_half_width(s->contact);
    return is_near;
}

/* Places next to a front get the difference of the places beside them. */
static void spread(bool left_out[], double apart[])
{
    for (int i = 1; i < RW_PLACES; i++)
        if (left_out[i])
            apart[i] = apart[i - 1];
    for (int i = RW_PLACES - 1; i-- > 0;)
        if (left_out[i])
            apart[i] = fmax(apart[i], apart[i + 1]);
}

/* The error at a place over the difference of a step from its halves. Steps are of second order, or
 * of a lower one where a front runs back into a zone that slipped, or where the contact changes. A
 * place that came into contact in the step and sticks errs in this step alone, and the halves by
 * 0.18 times as much as the whole. */
static double doubt_at(rw_patch before, rw_patch now, double x)
{
    return !rw_patch_has(before, x)        ? RW_DOUBT_IF_NEW
           : rw_patch_is_same(before, now) ? RW_DOUBT
                                           : RW_DOUBT_IF_CHANGED;
}

/* Where the tractions at a place are compared. */
static double compared(rw_patch before, rw_patch now, double x)
{
    const double edge = x < before.left ? now.left : now.right;
    const double old = x < before.left ? before.left : before.right;
    return rw_patch_has(before, x) ? x : edge + RW_WORST_PLACE * (old - edge);
}

/* The differences of two tractions over the scale, by place, after a step from the contact
 * `before`. Returns the largest. */
static double difference(double scale, rw_patch before, const rw_numerical_state *a,
                         const rw_numerical_state *b, double apart[])
{
    bool left_out[RW_PLACES];
    double most = 0;
    for (int i = 0; i < RW_PLACES; i++) {
        const double place = rw_place(a->contact, i), x = compared(before, a->contact, place);
        const double doubt = doubt_at(before, a->contact, place);
        left_out[i] = is_at_front(a, place) || is_at_front(b, place);
        apart[i] = left_out[i] ? 0
                               : doubt *
                                     fabs(rw_traction_at(&a->shear.traction, x) -
                                          rw_traction_at(&b->shear.traction, x)) /
                                     scale;
        most = fmax(most, apart[i]);
    }
    spread(left_out, apart);
    return most;
}

/* Whether the ring of new contact at an edge is compared. Where slip has just ended there the whole
 * ring may be next to a front, where tractions are not compared. */
static bool ring_counts(const rw_numerical_state *from, const rw_numerical_state *there, int side)
{
    const double old = rw_patch_edge(from->contact, side),
                 edge = rw_patch_edge(there->contact, side);
    const bool slipped = rw_zones_at_edge(&from->shear.zones, side).label != 0;
    return rw_patch_has(there->contact, old) &&
           !(slipped && fabs(edge - old) < RW_AT_FRONT * rw_patch_half_width(there->contact));
}

/* How much D half-way differs from that of the whole, at an edge that sticks, as a traction at the
 * place of the old edge. */
static double growth_error(rw_work *w, const rw_numerical_state *from,
                           const rw_numerical_state *whole, const rw_numerical_state *half,
                           const rw_numerical_state *both)
{
    const rw_patch before = from->contact;
    double most = 0;
    for (int side = 0; side < 2; side++) {
        const double old = rw_patch_edge(before, side);
        const rw_friction *friction = isnan(whole->D[side] + half->D[side] + both->D[side])
                                          ? NULL
                                          : friction_of(w, half->contact);
        if (!friction || !ring_counts(from, whole, side))
            continue;
        const double D = rw_layers_ratio(w->frame, friction, whole->contact, &whole->layers, side);
        most =
            fmax(most, fabs(D - half->D[side]) * rw_exact_friction(w->frame, whole->contact, old));
    }
    return RW_OF_RATIO * most / rw_peak_of(w->frame, whole);
}

/* Shear over friction at an edge, from two places in the ring that is new in contact. */
static double ratio_at_edge(const rw_frame *frame, const rw_numerical_state *s, double edge,
                            double old)
{
    double ratio[2];
    for (int i = 0; i < 2; i++) {
        const double x = edge + (i + 1) * RW_BESIDE_EDGE * (old - edge);
        ratio[i] = rw_traction_at(&s->shear.traction, x) / rw_exact_friction(frame, s->contact, x);
    }
    return 2 * ratio[0] - ratio[1];
}

/* Shear over friction, at an edge that grows and sticks, is D at the end of the step. Its layers
 * and the rest meet that where D is linear along the way. What they lack is an error, as a traction
 * at the place of the old edge. */
static double edge_error(rw_work *w, const rw_numerical_state *from,
                         const rw_numerical_state *there)
{
    rw_problem rates;
    double D[2], most = 0;
    if ((isnan(there->D[0]) && isnan(there->D[1])) || w->frame->B != 0)
        return 0;
    rw_step_rates(w, from->at, there->at, there->contact, &rates);
    rw_rates_ratio(&w->fronts, &rates, &there->shear.zones, D);
    for (int side = 0; side < 2; side++) {
        const double old = rw_patch_edge(from->contact, side),
                     edge = rw_patch_edge(there->contact, side);
        if (!isnan(D[side] + there->D[side]) && ring_counts(from, there, side))
            most = fmax(most, fabs(ratio_at_edge(w->frame, there, edge, old) - D[side]) *
                                  rw_exact_friction(w->frame, there->contact, old));
    }
    return RW_OF_RATIO_AT_END * most / rw_peak_of(w->frame, there);
}

double rw_compare(rw_work *w, const rw_numerical_state *from, const rw_numerical_state *whole,
                  const rw_numerical_state *half, rw_numerical_state *both)
{
    const rw_frame *frame = w->frame;
    const rw_patch before = from->contact;
    const double scale = rw_peak_of(frame, whole);
    const double unit = scale * rw_patch_half_width(whole->contact);
    const double energy = (both->energy - whole->energy) / (unit * unit);
    /* the halves are asked where it lingers in the whole: that is seldom */
    const double lingering = lingering_error(w, from, whole) > 0
                                 ? lingering_error(w, from, half) + lingering_error(w, half, both)
                                 : 0;
    both->error += half->error + half->rate_error + both->rate_error + lingering +
                   fmax(growth_error(w, from, whole, half, both),
                        fmax(edge_error(w, from, half), edge_error(w, half, both)));
    const double apart = difference(scale, before, whole, both, both->apart);
    both->energy += (both->energy - whole->energy) / 3;
    both->doubt += half->doubt;
    both->drift += half->drift;
    return fmax(both->error + apart, fabs(energy) / RW_ENERGY_APART) / frame->tolerance;
}
