/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/beginning.h"

#include "base/tuned.h"

#include <stdlib.h>

/* ---- The next load ---- */

/* An error while the load is small counts less at the end of the step: by the ratio of the peak
 * pressures. */
static int32_t advance_part(rw_numerical *n, const rw_frame *frame, rw_scaled_loads at, double peak,
                            double last_peak, int *effort)
{
    const double times = fmax(1, last_peak / peak);
    rw_frame loose = rw_frame_like(frame, fmin(RW_LOOSEST, frame->tolerance * times));
    loose.far_off = frame->far_off * times;
    rw_numerical_rescale(n, rw_peak_of(frame, &n->now) / peak);
    return rw_numerical_step(n, &loose, at, effort);
}

/* The edges of unlike bodies turn where their shear does. */
static rw_turns turns_of(const rw_frame *frame, rw_patch from, rw_patch to)
{
    return frame->B != 0    ? (rw_turns){{1, 1}}
           : frame->is_held ? rw_arcs_turns_of_tilt(&frame->arcs, from, to)
                            : rw_arcs_turns(&frame->arcs, from, to);
}

/* Goes to loads under which this is the contact, in parts where P grows or falls much: a contact
 * that becomes much larger or smaller errs in parts of each peak pressure that it has on the way. A
 * step ends where an edge turns, because slip counts from when a place comes into contact. */
static int32_t advance(rw_numerical *n, const rw_frame *frame, rw_scaled_loads to, rw_patch contact)
{
    const rw_scaled_loads from = n->now.at;
    const double last_peak = rw_peak_friction(frame, contact);
    const double folds = fabs(log(to.P / from.P)) / log(RW_FOLD);
    const int parts = (int)fmax(1, ceil(folds - 1e-9));
    const rw_turns turns = turns_of(frame, n->now.contact, contact);
    int32_t status = RWEDGE_OK;
    int effort = RW_MOST_EFFORT;
    double done = 0;
    for (int i = 1; done < 1 && status == RWEDGE_OK;) {
        const double P = from.P * pow(to.P / from.P, (double)i / parts);
        const double fold = i < parts ? (P - from.P) / (to.P - from.P) : 1;
        done = rw_stop_before(&turns, done, fold);
        const rw_scaled_loads at = done < 1 ? rw_part_of_line(from, to, done) : to;
        const double peak =
            done < 1 ? rw_peak_friction(frame, rw_patch_of_loads(frame, at)) : last_peak;
        int share = effort / (parts - i + 1 + (done < fold));
        effort -= share;
        status = advance_part(n, frame, at, peak, last_peak, &share);
        effort += share;
        i += done == fold;
    }
    return status;
}

static rw_scaled_loads scaled_loads_after(const rwedge_contact *c, const rw_step *step)
{
    return rw_contact_scaled_loads(c, step->to_P, c->is_held ? step->to.tilt : step->to_M,
                                   step->to.shear, step->to.stretch);
}

/* Whether the contact stays: its edges do. */
static rw_scaled_loads next_loads(const rwedge_contact *c, const rw_step *step,
                                  const rw_numerical *n)
{
    rw_scaled_loads to = scaled_loads_after(c, step);
    if (rw_patch_is_same(step->patch, n->now.contact)) {
        to.P = n->now.at.P;
        to.turn = n->now.at.turn;
    }
    return to;
}

/* The contact without its shear. */
static void forget_shear(rwedge_contact *c, const rw_step *step)
{
    rw_memory_loads pressed = step->to;
    pressed.shear = 0;
    rw_memory_restart(&c->memory, pressed, 0);
    c->memory.corners[1].patch = step->patch;
    rw_slip_origins_destroy(&c->slip.origins);
}

enum { LOADS = 4 };

/* The changes of the loads, each as a traction. */
static void changes(const rw_numerical *n, const rwedge_contact *c, rw_scaled_loads to,
                    double change[])
{
    const rw_scaled_loads from = n->now.at;
    const double f = c->f;
    const double half = rw_patch_half_width(n->now.contact);
    change[0] = f * (to.P - from.P) / half;
    change[1] = c->is_held ? RW_HALF_PI * f * (to.turn - from.turn)
                           : f * (to.turn - from.turn) / (half * half);
    change[2] = (to.shear - from.shear) / half;
    change[3] = to.stretch - from.stretch;
}

static bool is_at(const rw_numerical *n, rw_scaled_loads loads)
{
    const rw_scaled_loads at = n->now.at;
    return at.P == loads.P && at.turn == loads.turn && at.shear == loads.shear &&
           at.stretch == loads.stretch;
}

/* Whether the loads go on along a straight line from touching, on which all has stuck. */
static bool is_on_line_from_touching(const rwedge_contact *c, const rw_numerical *n,
                                     rw_scaled_loads to)
{
    const rw_numerical_state *now = &n->now;
    double apart[LOADS], sum = 0;
    changes(n, c, rw_part_of_line(rw_loads_before_touching(c, to), to, now->at.P / to.P), apart);
    for (int i = 0; i < LOADS; i++)
        sum += fabs(apart[i]);
    return now->is_still && (c->unlike || now->shear.zones.count == 1) &&
           sum <= RW_ROUNDING_OF_FRICTION * c->f * now->at.P / rw_patch_half_width(now->contact);
}

/* What a load adds to the error, which counts by the peak pressure after it. */
static double added(const rw_frame *frame, const rw_numerical *from, const rw_numerical *next)
{
    const double before = rw_peak_of(frame, &from->now), after = rw_peak_of(frame, &next->now);
    return rw_numerical_error(next) - rw_numerical_error(from) * before / after;
}

/* A load that adds more to the error, over the tolerance, has not converged, as the header says. */
static const double MOST_ADDED = 10;

/* A copy of the state `from`, or the state further along its line from touching. */
static int32_t start_from(const rwedge_contact *c, const rw_numerical *from, rw_scaled_loads to,
                          rw_numerical **start)
{
    bool is_whole = true;
    if (!is_at(from, to) && is_on_line_from_touching(c, from, to))
        return rw_numerical_of_touching(c, to, start);
    *start = rw_numerical_copy(from, &is_whole);
    return *start && is_whole ? RWEDGE_OK : RWEDGE_ENOMEM;
}

/* A step from the state `from`. Unless RWEDGE_OK, there is no next state. */
static int32_t reach(const rwedge_contact *c, const rw_step *step, const rw_numerical *from,
                     rw_numerical **next)
{
    const rw_frame frame = rw_contact_frame(c);
    const rw_scaled_loads to = next_loads(c, step, from);
    int32_t status = start_from(c, from, to, next);
    const bool is_there = *next && is_at(*next, to); /* all the way from touching */
    if (status == RWEDGE_OK && !is_there)
        status = advance(*next, &frame, to, step->patch);
    if (status == RWEDGE_OK && !is_there && added(&frame, from, *next) > MOST_ADDED * c->tolerance)
        status = RWEDGE_ENOCONV;
    if (status == RWEDGE_OK && !rw_numerical_cluster(*next))
        status = RWEDGE_ENOMEM;
    if (status != RWEDGE_OK) {
        rw_numerical_destroy(*next);
        *next = NULL;
    }
    return status;
}

/* ---- Straight lines ---- */

/* A load that continues a straight line is computed as one step from the start of the line. So
 * answers do not depend on how a caller cuts the line, and errors of many small steps do not add
 * up. This is how far the loads so far are off the line from its start to the next load, over
 * friction: at most the last load, and those before it off the line to the last. */
static double stray(const rwedge_contact *c, const rw_step *step)
{
    if (!c->computed.start)
        return HUGE_VAL;
    const rw_frame frame = rw_contact_frame(c);
    double last[LOADS], next[LOADS], product = 0, square = 0, apart = 0;
    changes(c->computed.start, c, c->computed.now->now.at, last);
    changes(c->computed.start, c, next_loads(c, step, c->computed.start), next);
    for (int i = 0; i < LOADS; i++) {
        product += last[i] * next[i];
        square += next[i] * next[i];
    }
    const double part = square > 0 ? fmax(0, fmin(1, product / square)) : 0;
    for (int i = 0; i < LOADS; i++)
        apart += fabs(last[i] - part * next[i]);
    return c->computed.strayed + apart / rw_peak_of(&frame, &c->computed.now->now);
}

/* What has been dissipated, of that of a computed shear. */
static double work_of(const rwedge_contact *c, double energy)
{
    return c->geometry.theta * rw_unit_stress(&c->geometry) * energy;
}

/* Keeps a copy of the contact in its last closed form. */
static bool keep_exact(rwedge_contact *c)
{
    return c->computed.now || c->memory.count == 1 || c->unlike ||
           rwedge_contact_copy(c, &c->computed.exact) == RWEDGE_OK;
}

/* The computed shear where a new line begins; NULL where there is none. */
static int32_t new_start(const rwedge_contact *c, const rw_step *step, rw_numerical **start)
{
    if (!c->computed.now && c->memory.count == 1)
        return rw_numerical_of_touching(c, scaled_loads_after(c, step), start);
    *start = c->computed.now ? c->computed.now : rw_numerical_of_closed_form(c);
    return *start ? RWEDGE_OK : RWEDGE_ENOMEM;
}

/* The start of a line, its last state and how far loads strayed from it. */
static void take(rwedge_contact *c, rw_numerical *start, rw_numerical *next, double strayed)
{
    if (start != c->computed.start)
        rw_numerical_destroy(c->computed.start);
    if (start != c->computed.now)
        rw_numerical_destroy(c->computed.now);
    c->computed.start = start;
    c->computed.now = next;
    c->computed.strayed = strayed;
    rw_numerical_add_error(next, strayed);
}

/* Where a step of unlike bodies has led: the contact, the tilt or the moment. */
static void note_end(const rw_numerical_state *now, rw_step *step)
{
    double load = 0, moment = 0;
    for (size_t i = 0; i < now->pressed.count; i++)
        for (int k = 0; k < RW_TERMS; k++) {
            load += now->pressed.elements[i].load[k];
            moment += now->pressed.elements[i].load[k] * now->pressed.elements[i].x[k];
        }
    step->patch = now->contact;
    if (step->is_held)
        step->to_M = moment / load * step->to_P;
    else
        step->to.tilt = now->tilt;
}

int32_t rw_numerical_go(rwedge_contact *c, rw_step *step, double *energy)
{
    rw_numerical *start = c->computed.start, *next = NULL;
    double strayed = stray(c, step);
    int32_t status =
        strayed <= RW_STRAY * c->tolerance ? reach(c, step, start, &next) : RWEDGE_ENOCONV;
    if (status == RWEDGE_ENOCONV) {
        strayed = 0;
        status = new_start(c, step, &start);
        if (status == RWEDGE_OK)
            status = reach(c, step, start, &next);
    }
    if (status == RWEDGE_OK && c->unlike) {
        note_end(&next->now, step);
        const double reach = c->geometry.reach;
        if (reach > 0 && !(fmax(-step->patch.left, step->patch.right) <= reach))
            status = RWEDGE_ERANGE;
    }
    if (status == RWEDGE_OK && !(rw_memory_reserve(&c->memory, 2) && keep_exact(c)))
        status = RWEDGE_ENOMEM;
    if (status != RWEDGE_OK) {
        if (start != c->computed.start && start != c->computed.now)
            rw_numerical_destroy(start);
        rw_numerical_destroy(next);
        return status;
    }
    *energy = work_of(c, next->now.energy - (c->computed.now ? c->computed.now->now.energy : 0));
    take(c, start, next, strayed);
    forget_shear(c, step);
    return RWEDGE_OK;
}

/* A copy of the computed shear, or that of the closed form; NULL where memory is short. */
static rw_numerical *start_of(const rwedge_contact *c)
{
    bool is_whole = true;
    rw_numerical *n = c->computed.now ? rw_numerical_copy(c->computed.now, &is_whole)
                                      : rw_numerical_of_closed_form(c);
    if (is_whole)
        return n;
    rw_numerical_destroy(n);
    return NULL;
}

/* What may be left of the load where nothing sticks any more under a tension. */
static const double LAST_STICK = 1.0 / 32;

/* The work of the last part of the load is negligible. */
int32_t rw_numerical_energy_to_separation(const rwedge_contact *c, double *energy)
{
    const rw_frame frame = rw_contact_frame(c);
    double left = 1;
    int effort = RW_MOST_EFFORT;
    rw_numerical *n = start_of(c);
    if (!n)
        return RWEDGE_ENOMEM;
    const double before = n->now.energy;
    const rw_scaled_loads from = n->now.at,
                          away = {.turn = c->is_held ? from.turn : 0, .stretch = from.stretch};
    int32_t status = RWEDGE_OK;
    while (left > RW_LAST_TOUCH && status == RWEDGE_OK) {
        status = rw_numerical_step(n, &frame, rw_part_of_line(away, from, left / 2), &effort);
        left = status == RWEDGE_OK ? left / 2 : left;
    }
    *energy = left <= LAST_STICK ? work_of(c, n->now.energy - before) : NAN;
    rw_numerical_destroy(n);
    return status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : RWEDGE_OK;
}

bool rw_numerical_is_passed(const rwedge_contact *c)
{
    if (!c->computed.now || !c->computed.exact)
        return false;
    const rw_numerical *n = c->computed.now;
    const rw_zones *z = &n->now.shear.zones;
    return n->now.is_still && z->count == 3 && z->zone[0].label == z->zone[2].label &&
           z->zone[1].left >= n->now.unslipped.left && z->zone[1].right <= n->now.unslipped.right;
}

bool rw_numerical_agrees(const rwedge_contact *c, const rwedge_contact *exact)
{
    const rw_zones *z = &c->computed.now->now.shear.zones, other = rw_contact_zones(exact);
    const double slack = c->tolerance * (z->zone[2].right - z->zone[0].left);
    return other.count == 3 && other.zone[0].label == z->zone[0].label &&
           fabs(other.zone[1].left - z->zone[1].left) < slack &&
           fabs(other.zone[1].right - z->zone[1].right) < slack;
}
