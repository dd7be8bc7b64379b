/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "computed/grown.h"

#include "base/domain.h"
#include "base/tuned.h"
#include "computed/growing_contact.h"
#include "numerical/coupled.h"
#include "potential/pad_potential.h"

/* The cells in contact; half of them tell the error. */
enum { CELLS = 160 };

typedef struct {
    const rw_frame *frame;
    const rw_growth *growth;
    rw_patch contact;
    const rw_traction *friction; /* NULL: that of the pad alone */
    double more;                 /* what sticks takes, of what friction leaves */
} shape;

static void traction_at(const double x[], const void *context, double value[])
{
    const shape *s = context;
    if (s->friction)
        rw_traction_values(s->friction, RW_TERMS, x, value);
    else
        rw_pad_pressures(&s->frame->arcs, s->contact, RW_TERMS, x, value);
    for (int i = 0; i < RW_TERMS; i++) {
        const double ratio = rw_growth_ratio(s->growth, x[i]);
        value[i] *= (s->friction ? 1 : s->frame->f) * (ratio + s->more * (1 - ratio * ratio));
    }
}

static void slip_at(const double x[], const void *context, double slip[])
{
    const rw_growth *g = context;
    for (int i = 0; i < RW_TERMS; i++)
        slip[i] = rw_growth_slip(g, x[i]);
}

/* The zones of the cells, whose fronts are kinks. */
static void set_zones(const rw_growth *g, rw_numerical_state *now)
{
    rw_zones *z = &now->shear.zones;
    *z = (rw_zones){1, {{g->label[g->from], now->contact.left, now->contact.right}}};
    for (size_t i = g->from + 1; i < g->to; i++) {
        const double front = g->end[i];
        rw_zone *last = &z->zone[z->count - 1];
        if (g->label[i] == last->label || front <= last->left || front >= now->contact.right)
            continue;
        last->right = front;
        rw_zones_insert(z, z->count, (rw_zone){g->label[i], front, now->contact.right});
    }
    now->shear.kinks = 0;
    for (int i = 0; i + 1 < z->count; i++)
        now->shear.kink[now->shear.kinks++] = z->zone[i].right;
}

static bool fit(shape *s, rw_numerical_state *now)
{
    double at[RW_MOST_KINKS + RW_MOST_BENDS + 2];
    s->contact = now->contact;
    set_zones(s->growth, now);
    const size_t breaks =
        rw_breaks_of(s->frame, now->contact, now->shear.kinks, now->shear.kink, at);
    rw_traction_destroy(&now->shear.traction);
    return rw_traction_fit(&now->shear.traction, traction_at, s, breaks, at,
                           RW_FIT_AT_MOST * s->frame->tolerance *
                               rw_peak_friction(s->frame, now->contact),
                           RW_FIT_NOISE);
}

/* What sticks carries what lacks of the shear. */
static void carry_all(shape *s, const rw_numerical_state *now)
{
    const rw_growth *g = s->growth;
    double room = 0;
    for (size_t i = g->from; i < g->to; i++)
        room +=
            (g->end[i + 1] - g->end[i]) * (g->f * g->N[i] - g->t[i] * g->t[i] / (g->f * g->N[i]));
    s->more += (now->at.shear - rw_traction_total(&now->shear.traction)) / room;
}

/* The pressure follows from the shear, which follows friction. */
static bool settle(const rw_frame *frame, const rw_growth *growth, rw_numerical_state *now)
{
    enum { TURNS = 6 };
    shape s = {.frame = frame, .growth = growth};
    for (int turn = 0; turn < TURNS; turn++) {
        if (!fit(&s, now))
            return false;
        carry_all(&s, now);
        rw_traction_destroy(&now->pressed);
        if (!rw_coupled_press(frame, now))
            return false;
        s.friction = &now->pressed;
    }
    return fit(&s, now);
}

/* Whether a cell is one of the outermost, or next to a front. */
static bool is_at_front(const rw_growth *g, size_t i)
{
    enum { NEXT = 2 };
    return i < g->from + NEXT || i + NEXT >= g->to || g->label[i - NEXT] != g->label[i + NEXT];
}

/* By how much the shear differs at most, over f times the peak pressure, away from fronts. */
static double difference(const rw_growth *coarse, const rw_growth *fine)
{
    double most = 0, peak = 0;
    for (size_t i = fine->from; i < fine->to; i++)
        peak = fmax(peak, fine->N[i]);
    for (size_t i = coarse->from; i < coarse->to; i++) {
        const double x = coarse->x[i];
        if (!is_at_front(coarse, i))
            most = fmax(most, coarse->N[i] / peak *
                                  fabs(rw_growth_ratio(coarse, x) - rw_growth_ratio(fine, x)));
    }
    return most;
}

static rw_numerical *numerical_of(const rw_frame *frame, const rw_growth *growth,
                                  rw_scaled_loads to)
{
    rw_numerical_state now = {.at = to, .contact = rw_patch_of_loads(frame, to)};
    if (settle(frame, growth, &now)) {
        now.energy = growth->energy;
        return rw_numerical_begin(frame, &now, true, slip_at, growth);
    }
    rw_traction_destroy(&now.shear.traction);
    rw_traction_destroy(&now.pressed);
    return NULL;
}

/* What the fine cells err by, of what the coarse ones differ from them. */
static const double OF_DIFFERENCE = 0.5;

int32_t rw_numerical_of_growth(const rw_frame *frame, rw_scaled_loads from, rw_scaled_loads to,
                               rw_numerical **grown)
{
    rw_growth fine, coarse;
    *grown = NULL;
    int32_t status = rw_growth_create(&coarse, frame, from, to, CELLS / 2);
    if (status != RWEDGE_OK)
        return status;
    status = rw_growth_create(&fine, frame, from, to, CELLS);
    if (status == RWEDGE_OK) {
        *grown = numerical_of(frame, &fine, to);
        status = *grown ? RWEDGE_OK : RWEDGE_ENOMEM;
        if (*grown)
            rw_numerical_add_error(*grown, OF_DIFFERENCE * difference(&coarse, &fine));
        rw_growth_destroy(&fine);
    }
    rw_growth_destroy(&coarse);
    return status;
}
