/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/bonded.h"

#include "base/domain.h"
#include "base/root.h"
#include "base/sort.h"
#include "base/tuned.h"

typedef struct {
    const rw_frame *frame;
    rw_patch contact;
    double middle, half, scale, e;
    const rw_traction *friction; /* the limit; NULL at first */
    double node[RW_TERMS], weight[RW_TERMS];
} bonded;

/* dP/ds of a patch of this half-width. */
static double growth(const rw_arcs *arcs, double s)
{
    return 2 * rw_arcs_edge_rates(arcs, (rw_patch){-s, s}).at_right;
}

/* The integral over a part of s = x cosh(u), where dP/ds is smooth. Next to u = 0 the integrand
 * turns with the logarithm of u. */
static double part_of(const bonded *b, double x, double from, double to)
{
    double sum = 0;
    for (int i = 0; i < RW_TERMS; i++) {
        const double v = b->node[i], u = from + (to - from) * (from == 0 ? v * v * v : v);
        const double du = (to - from) * (from == 0 ? 3 * v * v : 1) * b->weight[i];
        sum += sin(2 * b->e * log(1 / tanh(u / 2))) * growth(&b->frame->arcs, x * cosh(u)) * du;
    }
    return sum;
}

/* The traction at a place x > 0. */
static double traction_at_place(const bonded *b, double x)
{
    enum { PANELS = 4 };
    double at[RW_MOST_BENDS + 2], sum = 0;
    int n = 0;
    at[n++] = 0;
    for (int i = 0; i < b->frame->bends; i++)
        if (b->frame->bend[i] > x && b->frame->bend[i] < b->half)
            at[n++] = acosh(b->frame->bend[i] / x);
    at[n++] = x < b->half ? acosh(b->half / x) : 0;
    rw_sort(at, (size_t)n);
    for (int i = 0; i + 1 < n; i++)
        for (int k = 0; k < PANELS; k++)
            sum += part_of(b, x, at[i] + (at[i + 1] - at[i]) * k / PANELS,
                           at[i] + (at[i + 1] - at[i]) * (k + 1) / PANELS);
    return b->scale * cosh(RW_PI * b->e) / RW_PI * sum;
}

static void traction_at(const double x[], const void *context, double value[])
{
    const bonded *b = context;
    double limit[RW_TERMS];
    if (b->friction)
        rw_traction_values(b->friction, RW_TERMS, x, limit);
    for (int i = 0; i < RW_TERMS; i++) {
        const double off = x[i] - b->middle;
        const double there = off == 0 ? 0 : traction_at_place(b, fabs(off));
        const double t = off < 0 ? -there : there;
        value[i] = b->friction ? fmax(-limit[i], fmin(limit[i], t)) : t;
    }
}

/* Fits the traction on the contact of the state. */
static bool fit(bonded *b, rw_numerical_state *state)
{
    const rw_frame *frame = b->frame;
    double at[RW_MOST_BENDS + 3];
    b->contact = state->contact;
    b->middle = rw_patch_middle(state->contact);
    const size_t breaks = rw_breaks_of(frame, state->contact, 1, &b->middle, at);
    b->half = rw_patch_half_width(state->contact);
    b->scale = state->at.P / rw_arcs_pressing(&frame->arcs, state->contact).load;
    rw_traction_destroy(&state->shear.traction);
    return rw_traction_fit(&state->shear.traction, traction_at, b, breaks, at,
                           RW_FIT * RW_BEST_FIT * frame->tolerance *
                               rw_peak_friction(frame, state->contact),
                           RW_FIT_NOISE);
}

bool rw_press_bonded(const rw_frame *frame, rw_numerical_state *state)
{
    enum { TURNS = 4 };
    bonded b = {.frame = frame, .e = log((1 + frame->B) / (1 - frame->B)) / (2 * RW_PI)};
    rw_gauss(RW_TERMS, b.node, b.weight);
    state->contact = rw_patch_of_loads(frame, state->at);
    state->shear.kinks = 0;
    if (isnan(state->contact.left))
        return false;
    for (int turn = 0; turn < TURNS; turn++) {
        rw_traction_destroy(&state->pressed);
        if (!fit(&b, state) || !rw_coupled_press(frame, state))
            return false;
    }
    b.friction = &state->pressed;
    state->shear.zones = (rw_zones){1, {{0, state->contact.left, state->contact.right}}};
    return fit(&b, state);
}

/* The error of the factor, and where the rim, which is about so wide, slips: beside coupled
 * boundary elements. With B = 0.143 and f = 0.1, 0.15, 0.2 the shear differs by 0.047, 0.020 and
 * 0.012 in the mean, by up to 0.12, 0.04 and 0.04. */
double rw_bonded_error(const rw_frame *frame)
{
    static const double OF_FACTOR = 0.1;
    const double B = fabs(frame->B);
    return OF_FACTOR * B * B * B / frame->f + exp(-RW_PI * frame->f / B);
}
