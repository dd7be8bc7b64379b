/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A load in steps: each as long as its error allows. */
#include "base/tuned.h"
#include "numerical/energy.h"
#include "numerical/onset.h"
#include "numerical/origin.h"
#include "numerical/passing.h"

#include <stdlib.h>

/* A load is divided so many times at most, each time into halves or shorter parts. */
enum { DIVISIONS = 9 };

static const double SHORTEST = 1.0 / (1 << DIVISIONS);

/* A step as a whole, its first half and both halves, where they are known. */
typedef struct {
    rw_numerical_state whole, half, both;
} trial;

/* What a load needs. The stack of some threads, 64 KiB, would not hold it. */
typedef struct {
    rw_work work;
    rw_numerical *next;
    trial at[DIVISIONS + 1]; /* by how often the load was divided */
} load_work;

static bool is_known(const rw_numerical_state *s)
{
    return s->shear.traction.count > 0;
}

static void drop(rw_numerical_state *s)
{
    rw_traction_destroy(&s->shear.traction);
    rw_traction_destroy(&s->pressed);
}

/* Takes the place of another state, which is not known. */
static void move(rw_numerical_state *to, rw_numerical_state *from)
{
    *to = *from;
    from->shear.traction = from->pressed = (rw_traction){0};
}

/* Makes the end of a step the present state. */
static bool accept(load_work *j, const rw_numerical_state *half, rw_numerical_state *now)
{
    rw_numerical *n = j->next;
    const rw_frame *frame = j->work.frame;
    if (!rw_origin_renew(n, frame, half, now)) {
        j->work.is_short = true;
        return false;
    }
    if (frame->B == 0)
        rw_settle_energy(&j->work, &n->now, half, now);
    rw_shear_state_smooth(&now->shear, now->contact, frame->tolerance * rw_peak_of(frame, now));
    rw_numerical_note_error(n, half, now, frame->tolerance);
    drop(&n->now);
    move(&n->now, now);
    return true;
}

/* Ends a step, known as a whole or not, if its error is small enough or it is the last attempt. The
 * difference of the whole from two halves is the error, over the allowed one. If it is too large
 * only the first half stays. */
static bool end_step(load_work *j, trial *t, rw_scaled_loads to, bool is_last, double *error)
{
    rw_work *w = &j->work;
    const rw_numerical_state *from = &j->next->now;
    const bool knows_whole = is_known(&t->whole);
    const rw_zones *guess = knows_whole ? &t->whole.shear.zones : &from->shear.zones;
    *error = 0;
    if (knows_whole && t->whole.is_exact) {
        t->whole.error += t->whole.rate_error;
        return accept(j, &t->whole, &t->whole);
    }
    *error = HUGE_VAL;
    if (rw_implicit_step(w, from, rw_part_of_line(from->at, to, 0.5), guess, is_last, &t->half) &&
        knows_whole) {
        if (rw_step_goes_on(w, from, &t->half, &t->whole)) {
            move(&t->both, &t->whole);
            *error = 0;
        } else if (rw_implicit_step(w, &t->half, to, guess, is_last, &t->both))
            *error = rw_compare(w, from, &t->whole, &t->half, &t->both);
    }
    drop(&t->whole);
    const bool is_done =
        is_known(&t->both) && (*error <= 1 || is_last) && accept(j, &t->half, &t->both);
    drop(&t->both);
    if (is_done)
        drop(&t->half);
    return is_done;
}

/* The length of a step, over that of one with this error over the allowed one: in a step errors are
 * of second order or more, and growth is careful. Unknown errors are HUGE_VAL. */
static double better_length(double error)
{
    static const double ORDER = 2;
    return error == HUGE_VAL
               ? RW_IF_UNKNOWN
               : fmax(RW_SHORTER, fmin(RW_LONGER, RW_CAREFUL * pow(fmax(error, 0.1), -1 / ORDER)));
}

/* About this part, so that what is left has a whole number of them. */
static double part_of(double left, double part)
{
    return left / fmax(1, floor(left / part + 0.5));
}

static bool advance_in_parts(load_work *j, int division, rw_scaled_loads to, double length,
                             int effort, double *error);
static bool advance_to_cut(load_work *j, int division, rw_scaled_loads to, double length,
                           int effort, double cut);

/* The part of a step after which an edge that grows takes another course: it comes to a kink, or
 * slip begins there. 1 where it does not, and where the whole is not known. */
static double cut_in(load_work *j, const rw_numerical_state *whole)
{
    if (!is_known(whole) || j->work.frame->B != 0)
        return 1;
    const double passing = rw_passing_of_kink(&j->work, &j->next->now, whole);
    return passing < 1 ? passing : rw_onset_of_slip(&j->work, &j->next->now, whole);
}

/* Goes on over each moment at which an edge takes another course. `length` becomes that of what is
 * left, which is tried as a whole; it may be the last attempt. False where there is no answer. */
static bool pass_cuts(load_work *j, int division, rw_scaled_loads to, int effort, double *length,
                      bool *is_last)
{
    trial *t = &j->at[division];
    for (;;) {
        *is_last = division == DIVISIONS || *length <= SHORTEST || j->work.effort > effort;
        if (*is_last && !is_known(&t->whole))
            rw_implicit_step(&j->work, &j->next->now, to, NULL, true, &t->whole);
        const double cut = *is_last ? 1 : cut_in(j, &t->whole);
        if (cut == 1)
            return true;
        if (!advance_to_cut(j, division, to, *length, effort, cut))
            return false;
        *length *= 1 - cut;
    }
}

/* Goes on to a load. It is cut at such moments, and divided until the error of each part is small,
 * or the effort is spent. `length` is that of the load as a part of all. `error` on
 * return: of the step, if it was one. */
static bool advance(load_work *j, int division, rw_scaled_loads to, double length, int effort,
                    double *error)
{
    double left = length;
    bool is_last;
    if (!pass_cuts(j, division, to, effort, &left, &is_last))
        return false;
    const bool is_done =
        end_step(j, &j->at[division], to, is_last, error) ||
        (!is_last && !j->work.is_short && advance_in_parts(j, division, to, left, effort, error));
    *error = left < length ? HUGE_VAL : *error;
    return is_done;
}

/* `error` is that of the load at once, whose first half stands ready, if it is known. A part may
 * take half of the effort left. */
static bool advance_in_parts(load_work *j, int division, rw_scaled_loads to, double length,
                             int effort, double *error)
{
    rw_work *w = &j->work;
    rw_numerical_state *whole = &j->at[division + 1].whole;
    const rw_scaled_loads from = j->next->now.at;
    double done = 0, part = part_of(1, fmin(0.5, better_length(*error)));
    bool is_done = true;
    move(whole, &j->at[division].half);
    if (part < 0.5)
        drop(whole);
    while (is_done && done < 1) {
        const bool is_end = part > 0.9 * (1 - done);
        const rw_scaled_loads at = is_end ? to : rw_part_of_line(from, to, done + part);
        const int share = (effort - w->effort) / (is_end ? 1 : 2);
        if (done > 0 || part < 0.5)
            rw_implicit_step(w, &j->next->now, at, &j->next->now.shear.zones, false, whole);
        is_done = advance(j, division + 1, at, length * part, w->effort + share, error);
        done = is_end ? 1 : done + part;
        part = is_end ? 0 : part_of(1 - done, part * (*error > 1 ? 1 : better_length(*error)));
    }
    *error = HUGE_VAL;
    return is_done;
}

/* Goes to such a moment, and tries what is left as a whole. */
static bool advance_to_cut(load_work *j, int division, rw_scaled_loads to, double length,
                           int effort, double cut)
{
    const rw_scaled_loads at = rw_part_of_line(j->next->now.at, to, cut);
    const int half = j->work.effort + (effort - j->work.effort) / 2;
    double error;
    drop(&j->at[division].whole);
    rw_implicit_step(&j->work, &j->next->now, at, NULL, false, &j->at[division + 1].whole);
    if (!advance(j, division + 1, at, length * cut, half, &error))
        return false;
    rw_implicit_step(&j->work, &j->next->now, to, NULL, false, &j->at[division].whole);
    return true;
}

/* The friction of a contact goes from load to load. The last place is the last to be given to
 * another contact. */
static void lend_friction(rw_numerical *n, rw_work *w)
{
    w->friction[RW_FRICTIONS - 1] = n->friction;
    n->friction = (rw_friction){.peak = 0};
}

static void keep_friction(rw_work *w, rw_numerical *n)
{
    for (int i = 0; i < RW_FRICTIONS && n->friction.peak == 0; i++)
        if (rw_patch_is_same(w->friction[i].contact, n->now.contact)) {
            n->friction = w->friction[i];
            w->friction[i] = (rw_friction){.peak = 0};
        }
}

/* No state is known yet. The rest of one, some thousand bytes, is set with it. */
static void forget_all(load_work *j)
{
    for (int i = 0; i <= DIVISIONS; i++) {
        rw_numerical_state *const all[] = {&j->at[i].whole, &j->at[i].half, &j->at[i].both};
        for (int k = 0; k < 3; k++)
            all[k]->shear.traction = all[k]->pressed = (rw_traction){0};
    }
}

/* A copy that has gone to a load, in `next`; NULL where memory is short, or there is no answer. */
static int32_t try_load(const rw_numerical *n, const rw_frame *frame, rw_scaled_loads to,
                        int *effort, rw_numerical **next)
{
    load_work *j = malloc(sizeof *j);
    *next = NULL;
    if (!j)
        return RWEDGE_ENOMEM;
    rw_work_init(&j->work, frame, *effort);
    forget_all(j);
    int32_t status = RWEDGE_ENOMEM;
    bool is_whole = true;
    j->next = rw_numerical_copy(n, &is_whole);
    if (is_whole) {
        lend_friction(j->next, &j->work);
        double error;
        rw_implicit_step(&j->work, &j->next->now, to, NULL, false, &j->at[0].whole);
        const bool is_done = advance(j, 0, to, 1, *effort / 2, &error);
        *effort -= j->work.effort;
        keep_friction(&j->work, j->next);
        status = j->work.is_short || j->work.fronts.is_short ? RWEDGE_ENOMEM
                 : is_done                                   ? RWEDGE_OK
                                                             : RWEDGE_ENOCONV;
    }
    if (status == RWEDGE_OK)
        *next = j->next;
    else
        rw_numerical_destroy(j->next);
    for (int i = 0; i <= DIVISIONS; i++) {
        drop(&j->at[i].whole);
        drop(&j->at[i].half);
    }
    rw_work_destroy(&j->work);
    free(j);
    return status;
}

/* The better of two tries, of which the other is freed. NULL is none. */
static rw_numerical *better_of(rw_numerical *a, rw_numerical *b)
{
    const bool is_first = !b || (a && rw_numerical_error(a) <= rw_numerical_error(b));
    rw_numerical_destroy(is_first ? b : a);
    return is_first ? a : b;
}

/* What a try adds to the error; HUGE_VAL where there is none. */
static double added(const rw_numerical *n, const rw_numerical *next)
{
    return next ? rw_numerical_error(next) - rw_numerical_error(n) : HUGE_VAL;
}

/* What a load adds to the error before it is tried once more, and the tolerance then, over the
 * tolerance. */
static const double TRY_AGAIN = 2, LOOSER = 10;

/* A load that adds much to the error is tried once more, with more tolerance and a quarter of the
 * effort: larger steps may err less where the effort did not suffice for small ones. */
int32_t rw_numerical_step(rw_numerical *n, const rw_frame *frame, rw_scaled_loads to, int *effort)
{
    const rw_frame looser = rw_frame_like(frame, fmin(LOOSER * frame->tolerance, RW_LOOSEST));
    int rest = *effort / 4;
    rw_numerical *next, *other;
    int32_t status = try_load(n, frame, to, effort, &next);
    if (status != RWEDGE_ENOMEM && added(n, next) > TRY_AGAIN * frame->tolerance &&
        looser.tolerance > frame->tolerance) {
        *effort -= rest;
        status = try_load(n, &looser, to, &rest, &other);
        *effort += rest;
        next = better_of(next, other);
    }
    const bool is_done = status != RWEDGE_ENOMEM && added(n, next) <= frame->far_off;
    if (is_done) {
        const rw_numerical before = *n;
        *n = *next;
        *next = before;
    }
    rw_numerical_destroy(next);
    return status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : is_done ? RWEDGE_OK : RWEDGE_ENOCONV;
}
