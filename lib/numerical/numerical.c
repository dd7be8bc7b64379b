/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/numerical.h"

#include "base/domain.h"
#include "numerical/transform.h"

/* ---- Life ---- */

typedef struct {
    const rw_numerical *numerical;
    rw_function slip;
    const void *context;
} beginning;

/* The displacement that the traction and the stretch make, less the move of what sticks. */
static double displacement(const rw_stance *s, double x)
{
    return rw_traction_displacement(&s->shear.traction, x) + s->at.stretch * x - s->move;
}

static double origin_at_first(double x, const void *context)
{
    const beginning *b = context;
    return b->slip(x, b->context) - displacement(&b->numerical->now, x);
}

/* The contact's edges, and bends. */
static size_t breaks_of(const rw_frame *frame, const rw_stance *s, double at[])
{
    const int bends = rw_bends_between(frame, s->contact.left, s->contact.right, at + 1);
    at[0] = s->contact.left;
    at[bends + 1] = s->contact.right;
    return (size_t)bends + 2;
}

/* To this part of what is asked for. */
static const double FIT = 0.03;

static double slip_tolerance(const rw_frame *frame, const rw_stance *s)
{
    return FIT * frame->tolerance * rw_peak_friction(frame, s->contact) *
           rw_patch_half_width(s->contact);
}

bool rw_numerical_begin(rw_numerical *n, const rw_frame *frame, const rw_stance *now,
                        rw_function slip, const void *context)
{
    *n = (rw_numerical){.now = *now, .has_origin = slip != NULL};
    n->now.is_still = true;
    n->now.unslipped = now->contact;
    if (!slip)
        return true;
    double at[RW_MOST_BENDS + 2];
    const beginning b = {n, slip, context};
    const size_t breaks = breaks_of(frame, now, at);
    if (rw_traction_fit(&n->origin, origin_at_first, &b, breaks, at, slip_tolerance(frame, now)))
        return true;
    rw_traction_destroy(&n->origin);
    return false;
}

bool rw_numerical_copy(const rw_numerical *n, rw_numerical *copy)
{
    *copy = *n;
    if (!rw_traction_copy(&n->now.shear.traction, &copy->now.shear.traction))
        return false;
    if (rw_traction_copy(&n->origin, &copy->origin))
        return true;
    rw_traction_destroy(&copy->now.shear.traction);
    return false;
}

void rw_numerical_destroy(rw_numerical *n)
{
    rw_shear_state_destroy(&n->now.shear);
    rw_traction_destroy(&n->origin);
}

double rw_numerical_slip(const rw_numerical *n, double x)
{
    return rw_traction_at(&n->origin, x) + displacement(&n->now, x);
}

/* ---- Errors ---- */

static bool do_meet(rw_patch one, rw_patch other)
{
    return one.left < other.right && other.left < one.right;
}

/* What steps differ by is about what they err by, and may be less. */
static const double CAUTION = 1.5;

/* Errors at different places do not add up. */
double rw_numerical_error(const rw_numerical *n)
{
    double most = 0;
    for (int i = 0; i < n->errors; i++) {
        double sum = 0;
        for (int k = 0; k < n->errors; k++)
            sum += do_meet(n->error[i].place, n->error[k].place) ? n->error[k].error : 0;
        most = fmax(most, sum);
    }
    return CAUTION * most + n->rest;
}

static bool sticks_in(const rw_zones *zones, rw_patch place)
{
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label == 0 &&
            do_meet((rw_patch){zones->zone[i].left, zones->zone[i].right}, place))
            return true;
    return false;
}

/* What is left of an error where slip has passed its place: it is less distinct than that. */
static const double LEFT = 0.2;

static void note_error(rw_numerical *n, const rw_stance *s)
{
    int kept = 0;
    for (int i = 0; i < n->errors; i++)
        if (sticks_in(&s->shear.zones, n->error[i].place))
            n->error[kept++] = n->error[i];
        else
            n->rest = hypot(n->rest, LEFT * n->error[i].error);
    if (kept == RW_MOST_ERRORS)
        n->rest = hypot(n->rest, n->error[--kept].error);
    n->error[kept++] = (rw_load_error){s->error, s->uncertain};
    n->errors = kept;
}

/* ---- New places in contact ---- */

typedef struct {
    const rw_numerical *numerical; /* before the step */
    const rw_stance *now;
} growth;

/* A place that comes into contact has not slipped. */
static double origin_after(double x, const void *context)
{
    const growth *g = context;
    const rw_patch before = g->numerical->now.contact;
    if (x >= before.left && x <= before.right)
        return rw_traction_at(&g->numerical->origin, x);
    return -displacement(g->now, x);
}

static bool renew_origin(rw_numerical *n, const rw_frame *frame, const rw_stance *now)
{
    const rw_patch before = n->now.contact, contact = now->contact;
    const bool is_inside = contact.left >= before.left && contact.right <= before.right;
    if (!n->has_origin || is_inside)
        return true;
    double at[6];
    size_t count = 0;
    rw_traction origin = {0};
    const growth g = {n, now};
    const double all[] = {contact.left, fmax(contact.left, before.left),
                          fmin(contact.right, before.right), contact.right};
    for (size_t i = 0; i < 4; i++)
        if (count == 0 || all[i] > at[count - 1])
            at[count++] = all[i];
    if (!rw_traction_fit(&origin, origin_after, &g, count, at, slip_tolerance(frame, now))) {
        rw_traction_destroy(&origin);
        return false;
    }
    rw_traction_destroy(&n->origin);
    n->origin = origin;
    return true;
}

/* ---- Steps ---- */

/* Halvings of a load. */
enum { HALVINGS = 6 };

/* The error of the elements, of the tolerance; step by step it is another one. */
static const double ELEMENTS = 1e-2;

/* Takes over where a step has led. */
static bool accept(rw_work *w, rw_numerical *n, rw_stance *now)
{
    if (!renew_origin(n, w->frame, now)) {
        w->is_short = true;
        rw_shear_state_destroy(&now->shear);
        return false;
    }
    const double elements = ELEMENTS * w->frame->tolerance;
    n->rest = hypot(n->rest, elements);
    if (now->error > 0.01 * elements)
        note_error(n, now);
    rw_shear_state_destroy(&n->now.shear);
    n->now = *now;
    return true;
}

/* Of the half-width: nearer to a front tractions are not compared. They rise there like a root. */
static const double AT_FRONT = 0.01;

static bool is_at_front(const rw_stance *s, double x)
{
    bool is_near = false;
    for (int i = 0; i + 1 < s->shear.zones.count; i++)
        is_near = is_near || fabs(x - s->shear.zones.zone[i].right) <
                                 AT_FRONT * rw_patch_half_width(s->contact);
    return is_near;
}

/* The largest difference of two tractions, over the scale, and where it is not much less. */
static double difference(double scale, const rw_stance *one, const rw_stance *other,
                         rw_patch *place)
{
    enum { POINTS = 121 };
    double at[POINTS], apart[POINTS], most = 0;
    for (int i = 0; i < POINTS; i++) {
        const double x = at[i] =
            rw_patch_middle(one->contact) -
            rw_patch_half_width(one->contact) * cos(RW_PI * (i + 0.5) / POINTS);
        apart[i] = is_at_front(one, x) || is_at_front(other, x)
                       ? 0
                       : fabs(rw_traction_at(&one->shear.traction, x) -
                              rw_traction_at(&other->shear.traction, x));
        most = fmax(most, apart[i]);
    }
    *place = (rw_patch){one->contact.right, one->contact.left};
    for (int i = 0; i < POINTS; i++)
        if (apart[i] > 0.1 * most) {
            place->left = fmin(place->left, at[i]);
            place->right = fmax(place->right, at[i]);
        }
    return most / scale;
}

/* Energies may differ by so many times what tractions may, over the square of scale and
 * half-width; that of the halves is of second order. */
static const double ENERGY = 30;

/* How far the halves are from the whole: the error of the halves is of that size. Whether that is
 * little, and so is the difference of the energies. */
static const double SAFETY = 4;

static bool compare(const rw_frame *frame, const rw_stance *whole, const rw_stance *half,
                    rw_stance *both)
{
    const double scale = rw_peak_friction(frame, whole->contact);
    const double unit = scale * rw_patch_half_width(whole->contact);
    const double energy = (both->energy - whole->energy) / (unit * unit);
    both->error += half->error + half->haste + both->haste +
                   SAFETY * difference(scale, whole, both, &both->uncertain);
    both->energy += (both->energy - whole->energy) / 3;
    return both->error <= frame->tolerance && fabs(energy) <= ENERGY * frame->tolerance;
}

static rw_course half_way(rw_course from, rw_course to)
{
    return (rw_course){from.P / 2 + to.P / 2, from.M / 2 + to.M / 2, from.shear / 2 + to.shear / 2,
                       from.stretch / 2 + to.stretch / 2};
}

/* A step that may be there or not. */
typedef struct {
    bool is_known;
    rw_stance stance;
} trial;

static void drop(trial *t)
{
    if (t->is_known)
        rw_shear_state_destroy(&t->stance.shear);
    t->is_known = false;
}

static trial try_step(rw_work *w, const rw_stance *from, rw_course to, bool coarse)
{
    trial t;
    t.is_known = rw_implicit_step(w, from, to, coarse, &t.stance);
    return t;
}

/* The step as a whole, if it is known, and by way of the middle: how far these are apart is the
 * error. Both halves are divided again until it is small, or the effort is spent: the first may
 * take half of what is left. */
static bool advance(rw_work *w, rw_numerical *n, rw_course to, trial *whole, int halvings,
                    int effort)
{
    const bool is_last = halvings == 0 || w->effort > effort;
    const rw_course middle = half_way(n->now.at, to);
    if (is_last && !whole->is_known)
        *whole = try_step(w, &n->now, to, true);
    trial half = try_step(w, &n->now, middle, is_last), both = {.is_known = false};
    if (half.is_known && whole->is_known && rw_step_goes_on(w, &half.stance, &whole->stance)) {
        whole->is_known = false;
        drop(&half);
        return accept(w, n, &whole->stance);
    }
    if (half.is_known && whole->is_known)
        both = try_step(w, &half.stance, to, is_last);
    const bool is_close =
        both.is_known && compare(w->frame, &whole->stance, &half.stance, &both.stance);
    drop(whole);
    if (is_close || (both.is_known && is_last)) {
        drop(&half);
        return accept(w, n, &both.stance);
    }
    drop(&both);
    if (is_last || w->is_short) {
        drop(&half);
        return false;
    }
    if (!advance(w, n, middle, &half, halvings - 1, w->effort + (effort - w->effort) / 2))
        return false;
    trial rest = try_step(w, &n->now, to, false);
    return advance(w, n, to, &rest, halvings - 1, effort);
}

/* A load that adds a larger error has not converged: it is no answer. */
static const double FAR_OFF = 0.1;

static rw_step_result try_load(rw_numerical *n, const rw_frame *frame, rw_course to)
{
    rw_work w;
    rw_numerical next;
    if (!rw_work_create(&w, frame))
        return RW_STEP_NO_MEMORY;
    if (!rw_numerical_copy(n, &next)) {
        rw_work_destroy(&w);
        return RW_STEP_NO_MEMORY;
    }
    trial whole = try_step(&w, &next.now, to, false);
    const bool is_done = advance(&w, &next, to, &whole, HALVINGS, RW_MOST_EFFORT / 2) &&
                         rw_numerical_error(&next) - rw_numerical_error(n) <= FAR_OFF;
    rw_work_destroy(&w);
    rw_numerical_destroy(is_done ? n : &next);
    if (is_done)
        *n = next;
    return is_done ? RW_STEP_DONE : w.is_short ? RW_STEP_NO_MEMORY : RW_STEP_FAILED;
}

/* What cannot be had to the tolerance may be had to ten times as much: the error tells. */
rw_step_result rw_numerical_step(rw_numerical *n, const rw_frame *frame, rw_course to)
{
    static const double LOOSEST = 1e-2;
    const rw_frame looser =
        rw_frame_of(frame->arcs, frame->f, fmin(10 * frame->tolerance, LOOSEST));
    const rw_step_result result = try_load(n, frame, to);
    return result == RW_STEP_FAILED && looser.tolerance > frame->tolerance
               ? try_load(n, &looser, to)
               : result;
}
