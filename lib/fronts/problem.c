/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fronts/problem.h"

#include "base/domain.h"
#include "potential/pad_potential.h"

#include <float.h>
#include <string.h>

void rw_zones_insert(rw_zones *z, int i, rw_zone zone)
{
    if (z->count == RW_MOST_ZONES)
        return;
    memmove(z->zone + i + 1, z->zone + i, (size_t)(z->count - i) * sizeof *z->zone);
    z->zone[i] = zone;
    z->count++;
}

int rw_zones_label(const rw_zones *z, double x)
{
    int i = 0;
    while (i + 1 < z->count && x > z->zone[i].right)
        i++;
    return z->zone[i].label;
}

rw_patch rw_zones_widest_stick(const rw_zones *z, rw_patch patch)
{
    rw_patch widest = {patch.left, patch.left};
    for (int i = 0; i < z->count; i++) {
        const rw_patch part = {fmax(patch.left, z->zone[i].left),
                               fmin(patch.right, z->zone[i].right)};
        if (z->zone[i].label == 0 && part.right - part.left > widest.right - widest.left)
            widest = part;
    }
    return widest;
}

/* Edges that differ by less than this, over the width, count as one place. */
static const double SAME_EDGE = 1e-12;

/* F per time, from the pressure by which a moving patch changes, that of a flat punch: dp/ds =
 * (P'/pi + kappa (x - m))/sqrt((x - left)(right - x)), kappa from the moment. */
static double rate_of_friction(const rw_problem *p, double x)
{
    const double square = (x - p->to.left) * (p->to.right - x);
    return square > 0
               ? p->frame->f * (p->load[0] / RW_PI + p->tilt[0] * (x - p->middle)) / sqrt(square)
               : 0;
}

void rw_friction_after(const rw_problem *p, size_t n, const double x[], double F[])
{
    if (!p->is_rate)
        rw_traction_values(&p->after->traction, n, x, F);
    for (size_t i = 0; i < n && p->is_rate; i++)
        F[i] = rate_of_friction(p, x[i]);
}

void rw_friction_before(const rw_problem *p, size_t n, const double x[], double F[])
{
    static const rw_traction NONE = {.count = 0};
    rw_traction_values(p->is_rate ? &NONE : &p->before->traction, n, x, F);
}

/* f times the pressure of the rest of a layer, before or after the step. */
static double rest_friction(double f, const rw_layer_rest *rest, double x)
{
    const rw_patch patch = rest->patch;
    if (!(x > patch.left && x < patch.right))
        return 0;
    return f * sqrt((x - patch.left) * (patch.right - x)) / rw_patch_half_width(patch) *
           rw_layer_rest_pressure(rest, x);
}

static rw_power_scale scale_of(const rw_problem *p)
{
    return (rw_power_scale){p->middle, p->half};
}

/* The change of friction by the pad alone; F is friction after the step. */
static void own_change(const rw_problem *p, size_t n, const double x[], const double F[],
                       double change[])
{
    double after[RW_TERMS];
    const bool is_coupled = !p->is_rate && p->after->own;
    for (size_t i = 0; i < n; i += RW_TERMS) {
        const size_t block = n - i < RW_TERMS ? n - i : RW_TERMS;
        if (is_coupled) {
            rw_traction_values(p->before->own, block, x + i, change + i);
            rw_traction_values(p->after->own, block, x + i, after);
        } else
            rw_friction_before(p, block, x + i, change + i);
        for (size_t k = 0; k < block; k++)
            change[i + k] = (is_coupled ? after[k] : F[i + k]) - change[i + k];
    }
}

void rw_layer_values(const rw_problem *p, int count, size_t n, const double x[], const double F[],
                     size_t stride, double change[])
{
    if (count > 0)
        own_change(p, n, x, F, change);
    for (int k = 1; k < count; k++)
        for (size_t i = 0; i < n; i++)
            change[(size_t)k * stride + i] = rw_power(scale_of(p), k, x[i]) * change[i] +
                                             rest_friction(p->frame->f, &p->rest[k][1], x[i]) -
                                             rest_friction(p->frame->f, &p->rest[k][0], x[i]);
}

/* The rest of the polynomial slope of a layer, outside of its patch. */
static double rest_slope(const rw_problem *p, const rw_layer_rest *rest, double x)
{
    const rw_patch patch = rest->patch;
    return copysign(p->frame->f, x - patch.left) * sqrt((x - patch.left) * (x - patch.right)) /
           rw_patch_half_width(patch) * rw_layer_rest_pressure(rest, x);
}

/* The surface outside of a patch, relative to the profile of the layer there. */
static void slopes_beside(const rw_problem *p, int after, int k, size_t n, const double x[],
                          double slope[])
{
    static const double SURFACE[RW_TERMS] = {0};
    const rw_patch patch = after ? p->to : p->from;
    const double tilt = rw_arcs_pressing(&p->frame->arcs, patch).tilt;
    rw_fields fields;
    rw_pad_fields(&p->frame->arcs, patch, (int)n, x, SURFACE, &fields);
    for (size_t i = 0; i < n; i++) {
        slope[i] = -p->frame->f * rw_power(scale_of(p), k, x[i]) * (fields.G_re[i] + tilt);
        if (k > 0 && (x[i] < patch.left || x[i] > patch.right))
            slope[i] += rest_slope(p, &p->rest[k][after], x[i]);
    }
}

void rw_layer_slopes(const rw_problem *p, int k, size_t n, const double x[], double slope[])
{
    double before[RW_TERMS];
    slopes_beside(p, 0, k, n, x, before);
    slopes_beside(p, 1, k, n, x, slope);
    for (size_t i = 0; i < n; i++)
        slope[i] -= before[i];
}

void rw_beside_layers(const rw_problem *p, const rw_layers *layers, double *shear, double *stretch)
{
    *shear = p->shear;
    *stretch = p->stretch;
    for (int k = 0; k < layers->count; k++) {
        *shear -= p->frame->f * layers->weight[k] * p->load[k];
        *stretch += p->frame->f * layers->weight[k] * p->tilt[k];
    }
}

void rw_base_traction(const rw_problem *p, const rw_layers *layers, size_t n, const double x[],
                      double t[])
{
    double F[RW_TERMS], change[RW_LAYERS][RW_TERMS];
    rw_traction_values(&p->old->traction, n, x, t);
    if (layers->count > 0)
        rw_friction_after(p, n, x, F);
    rw_layer_values(p, layers->count, n, x, F, RW_TERMS, change[0]);
    for (int k = 0; k < layers->count; k++)
        for (size_t i = 0; i < n; i++)
            t[i] += layers->weight[k] * change[k][i];
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

/* The distance from an edge, over the half-width, at which layers are compared with friction. */
static const double AT_EDGE = 1e-6;

/* The integral of u^k p. */
static double moment_of(double f, rw_power_scale scale, const rw_friction *friction, int k)
{
    const rw_traction *t = rw_own_friction(friction);
    double sum = 0;
    for (size_t i = 0; i < t->count; i++)
        for (int j = 0; j < RW_TERMS; j++)
            sum += t->elements[i].load[j] * rw_power(scale, k, t->elements[i].x[j]);
    return sum / f;
}

/* The rests of the layers on a patch, and the integrals of u^k p. */
static void find_rests(const rw_frame *frame, const rw_friction *friction, rw_power_scale scale,
                       int count, rw_layer_rest rest[], double moment[])
{
    const rw_pressing own = rw_arcs_pressing(&frame->arcs, friction->contact);
    for (int k = 0; k < count; k++) {
        moment[k] = k == 0 ? own.load : moment_of(frame->f, scale, friction, k);
        rest[k] = rw_layer_rest_of(scale, friction->contact, own.tilt, moment, k);
    }
}

/* Each layer over friction at an edge: D of that layer there. */
static void find_ratios(const rw_frame *frame, rw_patch patch, rw_power_scale scale, int count,
                        const rw_layer_rest rest[], int side, double ratio[])
{
    const double inside = AT_EDGE * rw_patch_half_width(patch);
    const double x = side ? patch.right - inside : patch.left + inside;
    const double friction = fmax(rw_exact_friction(frame, patch, x), DBL_MIN);
    for (int k = 0; k < count; k++)
        ratio[k] =
            k == 0 ? 1 : rw_power(scale, k, x) + rest_friction(frame->f, &rest[k], x) / friction;
}

double rw_layers_ratio(const rw_frame *frame, const rw_friction *friction, rw_patch to,
                       const rw_layers *layers, int side)
{
    const rw_power_scale scale = {rw_patch_middle(to), rw_patch_half_width(to)};
    rw_layer_rest rest[RW_LAYERS];
    double moment[RW_LAYERS], ratio[RW_LAYERS], D = 0;
    find_rests(frame, friction, scale, layers->count, rest, moment);
    find_ratios(frame, friction->contact, scale, layers->count, rest, side, ratio);
    for (int k = 0; k < layers->count; k++)
        D += layers->weight[k] * ratio[k];
    return D;
}

/* Adds the layers' loads and tilts on the patch after the step, or takes away those before it. */
static void note_patch(rw_problem *p, int after)
{
    const rw_friction *friction = after ? p->after : p->before;
    const rw_power_scale scale = scale_of(p);
    const int sign = after ? 1 : -1;
    rw_layer_rest rest[RW_LAYERS];
    double moment[RW_LAYERS], ratio[RW_LAYERS];
    find_rests(p->frame, friction, scale, RW_LAYERS, rest, moment);
    for (int k = 0; k < RW_LAYERS; k++) {
        const rw_pressing share = rw_layer_rest_pressing(&rest[k]);
        p->rest[k][after] = rest[k];
        p->load[k] += sign * (moment[k] + share.load);
        p->tilt[k] += sign * share.tilt;
    }
    for (int side = 0; side < 2; side++) {
        find_ratios(p->frame, friction->contact, scale, RW_LAYERS, rest, side, ratio);
        for (int k = 0; k < RW_LAYERS; k++)
            p->ratio[k][side][after] = ratio[k];
    }
}

void rw_problem_init(rw_problem *p, const rw_frame *frame, const rw_friction *before,
                     const rw_friction *after, const rw_shear_state *old, double shear,
                     double stretch)
{
    const rw_patch from = before->contact, to = after->contact;
    const double slack = SAME_EDGE * (to.right - to.left);
    *p = (rw_problem){.frame = frame,
                      .scale = after->peak,
                      .allowed = RW_ALLOWED * frame->tolerance,
                      .from = from,
                      .to = to,
                      .both = {fmin(from.left, to.left), fmax(from.right, to.right)},
                      .before = before,
                      .after = after,
                      .is_still = rw_patch_is_same(from, to),
                      .growth = {from.left - to.left, to.right - from.right},
                      .middle = rw_patch_middle(to),
                      .half = rw_patch_half_width(to),
                      .shear = shear,
                      .stretch = stretch,
                      .old = old};
    for (int i = 0; i < 2; i++)
        p->grows[i] = p->growth[i] > slack;
    for (int i = 0; i < 2 && (p->grows[0] || p->grows[1]); i++)
        note_patch(p, i);
}

double rw_problem_change(const rw_problem *p)
{
    return fabs(p->shear) / p->half + fabs(p->stretch) + fabs(p->after->peak - p->before->peak);
}

static const rw_shear_state NO_SHEAR = {.kinks = 0};

void rw_problem_init_rates(rw_problem *p, const rw_frame *frame, rw_patch contact, double load,
                           double moment, double shear, double stretch)
{
    *p = (rw_problem){.frame = frame,
                      .from = contact,
                      .to = contact,
                      .both = contact,
                      .is_rate = true,
                      .load = {load},
                      .middle = rw_patch_middle(contact),
                      .half = rw_patch_half_width(contact),
                      .shear = shear,
                      .stretch = stretch,
                      .old = &NO_SHEAR};
    p->tilt[0] = 2 * (moment - p->middle * load) / (RW_PI * p->half * p->half);
}
