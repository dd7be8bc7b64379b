/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fronts/frame.h"

#include "base/domain.h"
#include "base/sort.h"
#include "base/tuned.h"
#include "potential/pad_potential.h"

#include <float.h>
#include <string.h>

/* ---- Bends ---- */

/* A jump of the curvature, over its larger value, from which on the place is a bend. A pressure
 * that is taken for smooth across such a jump errs by less than 1e-3 of it. */
static double least_jump(double tolerance)
{
    return fmin(20 * tolerance, 0.02);
}

/* A place of the profile, and the curvatures beside it. */
typedef struct {
    double x, before, after;
} place;

/* The largest jumps, in order of size. */
typedef struct {
    rw_frame *frame;
    double jump[RW_MOST_BENDS];
} bends;

static void note_bend(bends *b, place at)
{
    rw_frame *f = b->frame;
    const double jump = fabs(at.after - at.before);
    int i = f->bends;
    if (!(jump > least_jump(f->tolerance) * fmax(at.before, at.after)))
        return;
    while (i > 0 && jump > b->jump[i - 1])
        i--;
    if (i == RW_MOST_BENDS)
        return;
    f->bends += f->bends < RW_MOST_BENDS;
    const size_t moved = (size_t)(f->bends - 1 - i) * sizeof *f->bend;
    memmove(f->bend + i + 1, f->bend + i, moved);
    memmove(b->jump + i + 1, b->jump + i, moved);
    f->bend[i] = at.x;
    b->jump[i] = jump;
}

/* The curvature of an arc; a kink has no length. */
static double curvature_of(double weight, double half_length)
{
    return half_length > DBL_MIN ? fmin(weight / half_length, DBL_MAX) : DBL_MAX;
}

rw_frame rw_frame_of(rw_arcs arcs, double f, double tolerance)
{
    rw_frame frame = {.arcs = arcs, .f = f, .tolerance = tolerance, .far_off = 0.1};
    bends all = {.frame = &frame};
    place last = {.x = rw_arc_at(&arcs, 0).left};
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        if (arc.left > last.x) {
            note_bend(&all, last);
            last = (place){.x = arc.left};
        }
        last.after = curvature_of(rw_arc_weight(&arcs, i), rw_arc_half_length(arc));
        note_bend(&all, last);
        last = (place){arc.right, last.after, 0};
    }
    note_bend(&all, last);
    rw_sort(frame.bend, (size_t)frame.bends);
    return frame;
}

rw_frame rw_frame_like(const rw_frame *frame, double tolerance)
{
    rw_frame like = rw_frame_of(frame->arcs, frame->f, tolerance);
    like.is_held = frame->is_held;
    like.B = frame->B;
    return like;
}

/* A bend this near to an end, over the distance of the two ends, counts as at the end: rounding
 * would move the points between. */
static const double AT_END = 1e-11;

int rw_bends_between(const rw_frame *frame, double from, double to, double at[])
{
    const double margin = AT_END * (to - from);
    int n = 0;
    for (int i = 0; i < frame->bends; i++)
        if (frame->bend[i] > from + margin && frame->bend[i] < to - margin)
            at[n++] = frame->bend[i];
    return n;
}

size_t rw_breaks_of(const rw_frame *frame, rw_patch contact, int kinks, const double kink[],
                    double at[])
{
    int n = rw_bends_between(frame, contact.left, contact.right, at);
    at[n++] = contact.left;
    at[n++] = contact.right;
    for (int i = 0; i < kinks; i++)
        at[n++] = kink[i];
    rw_sort(at, (size_t)n);
    return (size_t)n;
}

/* ---- Friction ---- */

void rw_exact_frictions(const rw_frame *frame, rw_patch contact, size_t n, const double x[],
                        double F[])
{
    static const double surface[RW_TERMS] = {0};
    for (size_t first = 0; first < n; first += RW_TERMS) {
        const size_t count = n - first < RW_TERMS ? n - first : RW_TERMS;
        rw_fields fields;
        rw_pad_fields(&frame->arcs, contact, (int)count, x + first, surface, &fields);
        for (size_t i = 0; i < count; i++)
            F[first + i] = -frame->f * fields.G_im[i];
    }
}

double rw_exact_friction(const rw_frame *frame, rw_patch contact, double x)
{
    double pressure;
    rw_pad_pressures(&frame->arcs, contact, 1, &x, &pressure);
    return frame->f * pressure;
}

double rw_peak_friction(const rw_frame *frame, rw_patch contact)
{
    enum { PLACES = 31 };
    double x[PLACES], F[PLACES], peak = 0;
    for (int i = 0; i < PLACES; i++)
        x[i] = contact.left + (contact.right - contact.left) * (i + 1.3) / 32.6;
    rw_exact_frictions(frame, contact, PLACES, x, F);
    for (int i = 0; i < PLACES; i++)
        peak = fmax(peak, F[i]);
    return peak;
}

typedef struct {
    const rw_frame *frame;
    rw_patch contact;
    double mean, slope;
} pressed;

static void traction_at(const double x[], const void *context, double value[])
{
    static const double surface[RW_TERMS] = {0};
    const pressed *p = context;
    const double middle = rw_patch_middle(p->contact);
    rw_fields fields;
    rw_pad_fields(&p->frame->arcs, p->contact, RW_TERMS, x, surface, &fields);
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = -(p->mean + p->slope * (x[i] - middle)) * fields.G_im[i];
}

bool rw_frame_fit(const rw_frame *frame, rw_patch contact, double mean, double slope, double peak,
                  rw_traction *traction)
{
    const pressed p = {frame, contact, mean, slope};
    double at[RW_MOST_BENDS + 2];
    const size_t breaks = rw_breaks_of(frame, contact, 0, NULL, at);
    *traction = (rw_traction){0};
    const bool is_done = rw_traction_fit(traction, traction_at, &p, breaks, at,
                                         RW_FIT_OF_FRICTION * frame->tolerance * peak, 0);
    if (!is_done)
        rw_traction_destroy(traction);
    return is_done;
}

bool rw_friction_create(rw_friction *friction, const rw_frame *frame, rw_patch contact)
{
    *friction = (rw_friction){.contact = contact,
                              .tolerance = frame->tolerance,
                              .peak = rw_peak_friction(frame, contact)};
    return rw_frame_fit(frame, contact, frame->f, 0, friction->peak, &friction->traction);
}

bool rw_friction_couple(rw_friction *friction, const rw_frame *frame, const rw_friction *alone,
                        const rw_bounded_inverse *inverse, int kinks, const double kink[])
{
    double at[RW_MOST_KINKS + RW_MOST_BENDS + 2];
    const size_t breaks = rw_breaks_of(frame, alone->contact, kinks, kink, at);
    *friction = *alone;
    friction->traction = (rw_traction){0};
    friction->own = &alone->traction;
    const bool is_done = rw_bounded_inverse_add(
        &friction->traction, &alone->traction, inverse, alone->contact, frame->f * frame->B, breaks,
        at, RW_FIT_OF_FRICTION * frame->tolerance * alone->peak);
    if (!is_done)
        rw_friction_destroy(friction);
    return is_done;
}

void rw_friction_destroy(rw_friction *friction)
{
    rw_traction_destroy(&friction->traction);
    *friction = (rw_friction){.peak = 0};
}
