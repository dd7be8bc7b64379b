/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/problem.h"

#include "base/domain.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Edges that differ by less, over the width, do not. */
static const double SAME_EDGE = 1e-12;

/* ---- Bends ---- */

/* Jumps of the curvature, over its larger value, that are a bend: the error of a pressure that is
 * taken for smooth is below 1e-3 of it. */
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

static int by_size(const void *a, const void *b)
{
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

rw_frame rw_frame_of(rw_arcs arcs, double f, double tolerance)
{
    rw_frame frame = {.arcs = arcs, .f = f, .tolerance = tolerance};
    bends all = {.frame = &frame};
    place last = {.x = rw_arc_at(&arcs, 0).left};
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        if (arc.left > last.x) {
            note_bend(&all, last);
            last = (place){.x = arc.left};
        }
        last.after = fmin(rw_arc_weight(&arcs, i) / rw_arc_half_length(arc), DBL_MAX);
        note_bend(&all, last);
        last = (place){arc.right, last.after, 0};
    }
    note_bend(&all, last);
    qsort(frame.bend, (size_t)frame.bends, sizeof *frame.bend, by_size);
    return frame;
}

int rw_bends_between(const rw_frame *frame, double from, double to, double at[])
{
    int n = 0;
    for (int i = 0; i < frame->bends; i++)
        if (frame->bend[i] > from && frame->bend[i] < to)
            at[n++] = frame->bend[i];
    return n;
}

/* ---- One step ---- */

double rw_friction_after(const rw_problem *p, double x)
{
    return p->f * rw_pad_pressure(&p->to_pressure, x);
}

double rw_friction_before(const rw_problem *p, double x)
{
    return p->f * rw_pad_pressure(&p->from_pressure, x);
}

/* Of the profile whose slope is ((x - x_0)/half)^2. */
static double second_pressure(const rw_problem *p, rw_patch patch, double x)
{
    if (!(x > patch.left && x < patch.right))
        return 0;
    const double m = rw_patch_middle(patch);
    return sqrt((x - patch.left) * (patch.right - x)) * (x - m + 2 * (m - p->middle)) /
           (p->half * p->half);
}

static double second_layer(const rw_problem *p, double x)
{
    return p->f * (second_pressure(p, p->to, x) - second_pressure(p, p->from, x));
}

double rw_base_traction(const rw_problem *p, rw_layers layers, double x)
{
    double t = rw_traction_at(&p->old->traction, x);
    if (layers.first != 0)
        t += layers.first * (rw_friction_after(p, x) - rw_friction_before(p, x));
    if (layers.second != 0)
        t += layers.second * second_layer(p, x);
    return t;
}

double rw_angle_of(const rw_problem *p, double x)
{
    const double part = (x - p->to.left) / (p->to.right - p->to.left);
    return 2 * asin(sqrt(fmax(0, fmin(1, part))));
}

double rw_place_of(const rw_problem *p, double angle)
{
    const double half = sin(angle / 2);
    return p->to.left + (p->to.right - p->to.left) * half * half;
}

/* Load and tilt that the second profile takes. */
static void second_pressing(const rw_problem *p, rw_patch patch, double *load, double *tilt)
{
    const double m = rw_patch_middle(patch) - p->middle, s = rw_patch_half_width(patch);
    const double unit = p->half * p->half;
    *load = RW_PI * m * (s * s / unit);
    *tilt = (m * m + s * s / 2) / unit;
}

bool rw_problem_create(rw_problem *p, const rw_frame *frame, rw_patch from, rw_patch to,
                       const rw_shear_state *old, double shear, double stretch)
{
    const double slack = SAME_EDGE * (to.right - to.left);
    *p = (rw_problem){.frame = frame, .f = frame->f, .from = from, .to = to, .old = old};
    if (!rw_pad_potential_create(&p->from_pressure, &frame->arcs, from))
        return false;
    if (!rw_pad_potential_create(&p->to_pressure, &frame->arcs, to)) {
        rw_pad_potential_destroy(&p->from_pressure);
        return false;
    }
    p->both = (rw_patch){fmin(from.left, to.left), fmax(from.right, to.right)};
    p->is_still = from.left == to.left && from.right == to.right;
    p->grows[0] = to.left < from.left - slack;
    p->grows[1] = to.right > from.right + slack;
    const rw_pressing before = rw_arcs_pressing(&frame->arcs, from);
    const rw_pressing after = rw_arcs_pressing(&frame->arcs, to);
    p->load = after.load - before.load;
    p->tilt = after.tilt - before.tilt;
    p->middle = rw_patch_middle(to);
    p->half = rw_patch_half_width(to);
    double load, tilt;
    second_pressing(p, to, &p->layer_load, &p->layer_tilt);
    second_pressing(p, from, &load, &tilt);
    p->layer_load -= load;
    p->layer_tilt -= tilt;
    p->shear = shear;
    p->stretch = stretch;
    return true;
}

void rw_problem_destroy(rw_problem *p)
{
    rw_pad_potential_destroy(&p->from_pressure);
    rw_pad_potential_destroy(&p->to_pressure);
}
