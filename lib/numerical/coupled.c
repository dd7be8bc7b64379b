/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/coupled.h"

#include "base/domain.h"
#include "base/tuned.h"
#include "numerical/bonding.h"
#include "traction/transform.h"

/* ---- The pressure by a shear ---- */

static void values_at(const double x[], const void *context, double value[])
{
    rw_traction_values(context, RW_TERMS, x, value);
}

/* L of the shear of a contact. */
static bool invert(const rw_frame *frame, rw_patch contact, const rw_shear_state *shear,
                   rw_bounded_inverse *inverse)
{
    double at[RW_MOST_KINKS + RW_MOST_BENDS + 2];
    const size_t breaks = rw_breaks_of(frame, contact, shear->kinks, shear->kink, at);
    return rw_bounded_inverse_create(inverse, contact, values_at, &shear->traction, breaks, at,
                                     RW_FIT_OF_INVERSE * RW_FIT_OF_FRICTION * frame->tolerance *
                                         rw_peak_friction(frame, contact) /
                                         fabs(frame->f * frame->B));
}

typedef struct {
    const rw_frame *frame;
    const rw_bounded_inverse *inverse;
} presser;

/* What a patch carries under a shear that is scaled to it. */
static rw_pressing carried(const void *context, rw_patch patch)
{
    const presser *c = context;
    const double half = rw_patch_half_width(patch), *I = c->inverse->moment, B = c->frame->B;
    rw_pressing sum = rw_arcs_pressing(&c->frame->arcs, patch);
    sum.load += B * half * I[1];
    sum.tilt += B / RW_PI * I[0];
    sum.moment += B * half * (rw_patch_middle(patch) * I[1] + half * (I[2] - I[0] / 2));
    return sum;
}

/* The contact under the loads; NaN where there is none. */
static rw_patch contact_of(const rw_frame *frame, const rw_bounded_inverse *inverse,
                           rw_scaled_loads at)
{
    const presser c = {frame, inverse};
    return rw_carried_patch(&frame->arcs, carried, &c, at.P, at.turn, !frame->is_held);
}

/* Kinks of one contact, scaled to another. */
static void scale_kinks(const rw_shear_state *s, rw_patch from, rw_patch to, double kink[])
{
    const double stretch = rw_patch_half_width(to) / rw_patch_half_width(from);
    for (int i = 0; i < s->kinks; i++)
        kink[i] = rw_patch_middle(to) + stretch * (s->kink[i] - rw_patch_middle(from));
}

/* The pressure on a contact under a shear that was found on another one. */
typedef struct {
    rw_friction alone, all; /* f times that of the pad; of both */
    double tilt;
    bool is_short;
} pressed;

static void release(pressed *p)
{
    rw_friction_destroy(&p->alone);
    rw_traction_destroy(&p->all.traction);
}

/* Where it is not done, there is no contact, or memory is short. */
static bool press(const rw_frame *frame, rw_patch known, const rw_shear_state *shear,
                  rw_scaled_loads at, pressed *p)
{
    rw_bounded_inverse inverse;
    double kink[RW_MOST_KINKS];
    *p = (pressed){.tilt = NAN, .is_short = true};
    if (!invert(frame, known, shear, &inverse))
        return false;
    const rw_patch contact = contact_of(frame, &inverse, at);
    p->is_short = !isnan(contact.left);
    bool is_done = p->is_short && rw_friction_create(&p->alone, frame, contact);
    if (is_done) {
        scale_kinks(shear, known, contact, kink);
        p->tilt = carried(&(presser){frame, &inverse}, contact).tilt;
        is_done = rw_friction_couple(&p->all, frame, &p->alone, &inverse, shear->kinks, kink);
    }
    rw_bounded_inverse_destroy(&inverse);
    if (!is_done)
        rw_friction_destroy(&p->alone);
    return is_done;
}

bool rw_coupled_press(const rw_frame *frame, rw_numerical_state *state)
{
    pressed p;
    if (!press(frame, state->contact, &state->shear, state->at, &p))
        return false;
    state->contact = p.all.contact;
    state->tilt = p.tilt;
    state->coupling = frame->B / frame->f;
    state->pressed = p.all.traction;
    p.all.traction = (rw_traction){0};
    release(&p);
    return true;
}

/* ---- The shear by a change of the pressure ---- */

/* The step, and what it has before its passes. */
typedef struct {
    rw_work *work;
    const rw_numerical_state *from;
    rw_scaled_loads to;
    rw_friction alone, before;
} coupled_step;

/* The old traction and the layer t2, and the strain of that layer. */
typedef struct {
    rw_shear_state old;
    double strain;
} base;

typedef struct {
    const rw_friction *before, *after;
} change;

/* f times what shears have added to the pressure, after a step less before it. */
static void change_at(const double x[], const void *context, double value[])
{
    const change *c = context;
    const rw_traction *with[] = {&c->after->traction, c->before->own},
                      *less[] = {c->after->own, &c->before->traction};
    double more[RW_TERMS];
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = 0;
    for (int k = 0; k < 2; k++) {
        rw_traction_values(with[k], RW_TERMS, x, more);
        for (int i = 0; i < RW_TERMS; i++)
            value[i] += more[i];
        rw_traction_values(less[k], RW_TERMS, x, more);
        for (int i = 0; i < RW_TERMS; i++)
            value[i] -= more[i];
    }
}

typedef struct {
    const rw_traction *old;
    rw_bonding bonding;
} bonded;

static void bonded_at(const double x[], const void *context, double value[])
{
    const bonded *b = context;
    rw_traction_values(b->old, RW_TERMS, x, value);
    for (int i = 0; i < RW_TERMS; i++)
        value[i] += rw_bonding_at(&b->bonding, x[i]);
}

/* The edges of both contacts, bends and kinks. */
enum { MOST_BREAKS = RW_MOST_KINKS + RW_MOST_BENDS + 4 };

static size_t breaks_of(const rw_frame *frame, rw_patch a, rw_patch b, const rw_shear_state *s,
                        double at[])
{
    const rw_patch both = {fmin(a.left, b.left), fmax(a.right, b.right)};
    double kink[RW_MOST_KINKS + 2];
    int n = 0;
    kink[n++] = fmax(a.left, b.left);
    kink[n++] = fmin(a.right, b.right);
    for (int i = 0; i < s->kinks; i++)
        kink[n++] = s->kink[i];
    return rw_breaks_of(frame, both, n, kink, at);
}

static bool make_base(const coupled_step *s, const rw_friction *after, base *b)
{
    const rw_numerical_state *from = s->from;
    const rw_frame *frame = s->work->frame;
    const rw_patch to = after->contact;
    const rw_patch both = {fmin(from->contact.left, to.left), fmax(from->contact.right, to.right)};
    const double tolerance = RW_FIT_OF_FRICTION * frame->tolerance * after->peak;
    const double B_over_f = frame->B / frame->f;
    double at[MOST_BREAKS];
    const bonded stuck = {&from->shear.traction,
                          rw_bonding_of(&frame->arcs, from->contact, to, frame->B)};
    rw_bounded_inverse inverse;
    rw_traction own = {0};
    const size_t breaks = breaks_of(frame, from->contact, to, &from->shear, at);
    if (!rw_bounded_inverse_create(&inverse, both, change_at, &(change){&s->before, after}, breaks,
                                   at, RW_FIT_OF_INVERSE * tolerance / fabs(B_over_f)))
        return false;
    b->old = from->shear;
    b->old.traction = (rw_traction){0};
    b->strain = -B_over_f / RW_PI * inverse.moment[0];
    const bool is_done =
        rw_traction_fit(&own, bonded_at, &stuck, breaks, at, tolerance, RW_FIT_NOISE) &&
        rw_bounded_inverse_add(&b->old.traction, &own, &inverse, both, -B_over_f, breaks, at,
                               tolerance);
    rw_bounded_inverse_destroy(&inverse);
    rw_traction_destroy(&own);
    if (!is_done)
        rw_traction_destroy(&b->old.traction);
    return is_done;
}

/* The rates of the pad alone, as its patch moves. */
static void set_rates(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to,
                      rw_patch contact)
{
    const rw_pressing first = rw_arcs_pressing(&w->frame->arcs, from->contact),
                      last = rw_arcs_pressing(&w->frame->arcs, contact);
    const double P = last.load - first.load, M = last.moment - first.moment;
    const double shear = to.shear - from->at.shear, stretch = to.stretch - from->at.stretch;
    rw_problem_init_rates(&w->start, w->frame, from->contact, P, M, shear, stretch);
    rw_problem_init_rates(&w->end, w->frame, contact, P, M, shear, stretch);
}

/* The layer makes places move that stick: by how much, beside its strain. */
static double move_of_layer(const coupled_step *s, const base *b, const rw_friction *after)
{
    const rw_numerical_state *from = s->from;
    const double x = rw_patch_middle(after->contact);
    return rw_traction_displacement(&b->old.traction, x) -
           rw_traction_displacement(&from->shear.traction, x) - b->strain * x -
           s->work->frame->B / s->work->frame->f *
               (rw_traction_load_to(&after->traction, x) - rw_traction_load_to(&from->pressed, x));
}

/* One pass, with a pressure. */
static bool pass(coupled_step *s, const rw_friction *after, const rw_zones *guess, bool coarse,
                 rw_numerical_state *there)
{
    rw_work *w = s->work;
    rw_problem p;
    rw_outcome outcome;
    base b;
    if (!make_base(s, after, &b)) {
        w->is_short = true;
        return false;
    }
    rw_spend(w, RW_EFFORT_OF_PASS * (double)(after->traction.count * b.old.traction.count));
    set_rates(w, s->from, s->to, after->contact);
    rw_problem_init(&p, w->frame, &s->before, after, &b.old,
                    s->to.shear - rw_traction_total(&b.old.traction),
                    s->to.stretch - s->from->at.stretch + b.strain);
    p.is_still = false;
    rw_fronts_forget(&w->fronts);
    const bool is_found = rw_search(w, &p, guess, coarse, &outcome);
    if (is_found) {
        outcome.move += move_of_layer(s, &b, after);
        rw_note_outcome(&p, s->from, s->to, &outcome, there);
    }
    rw_traction_destroy(&b.old.traction);
    return is_found;
}

/* ---- Passes ---- */

/* Whether a place is next to a front, where a traction is steep. */
static bool is_at_front(const rw_zones *zones, double x, double near)
{
    for (int i = 0; i + 1 < zones->count; i++)
        if (fabs(zones->zone[i].right - x) < near)
            return true;
    return false;
}

/* How far two tractions are apart, each at places of its own contact, over the scale. */
static double apart(const rw_frame *frame, const rw_numerical_state *a, const rw_numerical_state *b)
{
    double most = 0;
    for (int i = 0; i < RW_PLACES; i++) {
        const double x = rw_place(a->contact, i), y = rw_place(b->contact, i);
        const double near = RW_AT_FRONT * rw_patch_half_width(a->contact);
        if (!is_at_front(&a->shear.zones, x, near) && !is_at_front(&b->shear.zones, y, near))
            most = fmax(most, fabs(rw_traction_at(&a->shear.traction, x) -
                                   rw_traction_at(&b->shear.traction, y)));
    }
    return most / rw_peak_of(frame, a);
}

/* Takes over the pressure that the pass had. */
static void keep_pressure(const rw_frame *frame, pressed *p, rw_numerical_state *there)
{
    there->tilt = p->tilt;
    there->coupling = frame->B / frame->f;
    there->pressed = p->all.traction;
    p->all.traction = (rw_traction){0};
}

static void drop(rw_numerical_state *s)
{
    rw_traction_destroy(&s->shear.traction);
    rw_traction_destroy(&s->pressed);
}

/* A pass divides the change of the shear by 6 to 100. */
enum { MOST_PASSES = 20 };

/* Passes until the shear stays. */
static bool go(coupled_step *s, const rw_zones *guess, bool coarse, rw_numerical_state *there)
{
    const rw_frame *frame = s->work->frame;
    rw_numerical_state last = {.contact = s->from->contact};
    const rw_numerical_state *known = s->from;
    bool is_done = false;
    for (int i = 0; i < MOST_PASSES && !is_done; i++) {
        pressed p;
        if (!press(frame, known->contact, &known->shear, s->to, &p)) {
            s->work->is_short = s->work->is_short || p.is_short;
            break;
        }
        const bool is_found = pass(s, &p.all, i == 0 ? guess : &last.shear.zones, coarse, there);
        if (is_found)
            keep_pressure(frame, &p, there);
        release(&p);
        if (!is_found)
            break;
        const double moved = apart(frame, there, known);
        is_done = i > 0 && moved <= RW_SAME_SHEAR * frame->tolerance;
        there->error += is_done ? moved : 0;
        if (is_done)
            break;
        drop(&last);
        last = *there;
        known = &last;
    }
    drop(&last);
    return is_done;
}

bool rw_coupled_step(rw_work *w, const rw_numerical_state *from, rw_scaled_loads to,
                     const rw_zones *guess, bool coarse, rw_numerical_state *there)
{
    coupled_step s = {.work = w, .from = from, .to = to};
    if (!rw_friction_create(&s.alone, w->frame, from->contact)) {
        w->is_short = true;
        return false;
    }
    s.before = s.alone;
    s.before.traction = from->pressed;
    s.before.own = &s.alone.traction;
    const bool is_done = go(&s, guess, coarse, there);
    if (!is_done)
        *there = (rw_numerical_state){.contact = from->contact};
    rw_friction_destroy(&s.alone);
    return is_done;
}
