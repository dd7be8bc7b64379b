/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a computed shear begins: from a closed form, or where the bodies touch. */
#include "computed/beginning.h"

#include "base/domain.h"
#include "base/sort.h"
#include "base/tuned.h"
#include "computed/bonded.h"
#include "computed/grown.h"

/* When the bodies touch, the first step is to this part of the load, and each step grows fourfold.
 * Below it a contact that grows sticks or slides as a whole; that of a flat does not grow. */
static const double FIRST_TOUCH = 0x1p-16;

rw_frame rw_contact_frame(const rwedge_contact *c)
{
    rw_frame frame = rw_frame_of(rw_arcs_of(&c->geometry), c->f, c->tolerance);
    frame.is_held = c->is_held;
    frame.B = c->unlike ? -c->beta : 0;
    return frame;
}

rw_scaled_loads rw_contact_scaled_loads(const rwedge_contact *c, double P, double turn,
                                        double shear, double stretch)
{
    const rw_geometry *g = &c->geometry;
    return (rw_scaled_loads){rw_as_length(g, P), c->is_held ? turn : rw_as_length(g, turn),
                             c->f * rw_as_length(g, shear), -c->f * stretch};
}

/* ---- The traction of a closed form ---- */

static void traction_at(const double x[], const void *context, double value[])
{
    static const double surface[RW_TERMS] = {0};
    const rwedge_contact *c = context;
    rw_contact_fields fields;
    rw_contact_fields_at(c, 1, c->memory.count, RW_TERMS, x, surface, &fields);
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = -c->f * fields.tangential.G_im[i];
}

/* The edges of the patches; if there are many, those of the widest patches. */
static void note_kinks(const rwedge_contact *c, rw_patch contact, rw_shear_state *s)
{
    s->kinks = 0;
    for (size_t i = c->memory.count; i-- > 1 && s->kinks + 2 <= RW_MOST_KINKS;) {
        const rw_patch patch = c->memory.corners[i].patch;
        const double edge[2] = {patch.left, patch.right};
        for (int k = 0; k < 2 && rw_patch_weight(&c->memory, i) != 0; k++)
            if (edge[k] > contact.left && edge[k] < contact.right)
                s->kink[s->kinks++] = edge[k];
    }
    rw_sort(s->kink, (size_t)s->kinks);
}

/* ---- Beginning ---- */

static void slip_at(const double x[], const void *context, double slip[])
{
    const rwedge_contact *c = context;
    rwedge_contact_slip(c, RW_TERMS, x, slip);
    for (int i = 0; i < RW_TERMS; i++)
        slip[i] /= c->geometry.theta;
}

static bool fit_traction(const rwedge_contact *c, const rw_frame *frame, rw_numerical_state *now)
{
    note_kinks(c, now->contact, &now->shear);
    double at[RW_MOST_KINKS + RW_MOST_BENDS + 2];
    const size_t n = rw_breaks_of(frame, now->contact, now->shear.kinks, now->shear.kink, at);
    const double tolerance = 0.01 * frame->tolerance * rw_peak_friction(frame, now->contact);
    return rw_traction_fit(&now->shear.traction, traction_at, c, n, at, tolerance, 0);
}

/* The pressure of unlike bodies, which slide. */
static void pressure_at(const double x[], const void *context, double value[])
{
    static const double surface[RW_TERMS] = {0};
    const rwedge_contact *c = context;
    rw_contact_fields fields;
    rw_contact_fields_at(c, 1, c->memory.count, RW_TERMS, x, surface, &fields);
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = -c->f * fields.normal.G_im[i];
}

static bool fit_pressure(const rwedge_contact *c, const rw_frame *frame, rw_numerical_state *now)
{
    double at[RW_MOST_BENDS + 2];
    if (!c->unlike)
        return true;
    const size_t n = rw_breaks_of(frame, now->contact, 0, NULL, at);
    const double tolerance =
        RW_FIT_OF_FRICTION * frame->tolerance * rw_peak_friction(frame, now->contact);
    now->coupling = frame->B / frame->f;
    now->tilt = rw_memory_end(&c->memory)->tilt;
    return rw_traction_fit(&now->pressed, pressure_at, c, n, at, tolerance, 0);
}

rw_numerical *rw_numerical_of_closed_form(const rwedge_contact *c)
{
    const rw_corner *end = rw_memory_end(&c->memory);
    const rw_frame frame = rw_contact_frame(c);
    rw_numerical_state now = {.contact = end->patch,
                              .at = rw_contact_scaled_loads(c, c->loads.P,
                                                            c->is_held ? c->held_tilt : c->loads.M,
                                                            end->shear, end->stretch)};
    now.shear.zones = rw_contact_zones(c);
    if (fit_traction(c, &frame, &now) && fit_pressure(c, &frame, &now))
        return rw_numerical_begin(&frame, &now, rw_contact_knows_slip(c), slip_at, c);
    rw_traction_destroy(&now.shear.traction);
    rw_traction_destroy(&now.pressed);
    return NULL;
}

/* ---- Touching ---- */

rw_scaled_loads rw_loads_before_touching(const rwedge_contact *c, rw_scaled_loads to)
{
    const double sigma = c->memory.count == 1 ? c->loads.sigma : c->touched_at;
    return rw_contact_scaled_loads(c, 0, c->is_held ? to.turn : 0, 0, rw_contact_stretch(c, sigma));
}

/* The part of a straight line from touching after which the edges slip. Where all sticks t grows by
 * (dQ/pi - dstretch x)/sqrt(b^2 - x^2), if the contact has a middle that stays: by the pressure's
 * growth times mean + slope x. */
static double stuck_part(const rwedge_contact *c, rw_scaled_loads change, rw_patch contact)
{
    if (!rw_is_symmetric(&c->geometry) || contact.left != -contact.right)
        return FIRST_TOUCH;
    const double rest = (c->f * change.P - fabs(change.shear)) / RW_PI;
    const double half = rest / fabs(change.stretch);
    if (!(half < contact.right))
        return 1;
    const double load = rw_pressing_of(&c->geometry, (rw_patch){-half, half}).load;
    return fmax(FIRST_TOUCH, load / change.P);
}

/* Begins where all sticks, with a traction of mean + slope x times the pressure. */
static rw_numerical *begin_stuck(const rw_frame *frame, double mean, double slope,
                                 rw_numerical_state *now)
{
    now->shear.zones = (rw_zones){1, {{0, now->contact.left, now->contact.right}}};
    return rw_frame_fit(frame, now->contact, mean, slope, rw_peak_friction(frame, now->contact),
                        &now->shear.traction)
               ? rw_numerical_begin(frame, now, true, NULL, NULL)
               : NULL;
}

/* Where all has stuck since the bodies touched, on a straight line to the loads. Where not even a
 * small contact sticks, the traction is in proportion to friction. */
static rw_numerical *begin_in_proportion(const rwedge_contact *c, const rw_frame *frame,
                                         rw_scaled_loads change, rw_numerical_state *now)
{
    const double mean = change.shear / change.P, slope = -RW_PI * change.stretch / change.P;
    const double most = fabs(mean) + fabs(slope) * rw_patch_half_width(now->contact);
    const bool sticks = most < (1 + RW_ROUNDING_OF_FRICTION) * c->f;
    rw_numerical *n = begin_stuck(frame, mean, sticks ? slope : 0, now);
    if (n)
        rw_numerical_add_error(n, RW_TOUCH_ERROR * c->tolerance);
    return n;
}

/* Whether the contact that begins is that of a flat, which hardly grows. */
static bool is_flat(const rw_frame *frame, rw_scaled_loads from, const rw_numerical_state *now)
{
    const rw_patch before = rw_patch_of_loads(frame, rw_part_of_line(from, now->at, 0.25));
    return rw_patch_half_width(now->contact) < 1.1 * rw_patch_half_width(before);
}

/* A flat is pressed first, and then takes its shear in one step: that is as if both had grown
 * together. A step that fails is left to those that follow. */
static rw_numerical *begin_flat(const rw_frame *frame, double stretch, rw_numerical_state *now)
{
    const rw_scaled_loads at = now->at;
    int effort = RW_MOST_EFFORT;
    now->at.shear = 0;
    now->at.stretch = stretch;
    rw_numerical *n = begin_stuck(frame, 0, 0, now);
    if (!n || rw_numerical_step(n, frame, at, &effort) != RWEDGE_ENOMEM)
        return n;
    rw_numerical_destroy(n);
    return NULL;
}

/* Pressed alone, a pad that is symmetric and not tilted: in closed form. */
static rw_numerical *press_alone(const rw_frame *frame, rw_scaled_loads to)
{
    rw_numerical_state now = {.at = to};
    if (!rw_press_bonded(frame, &now)) {
        rw_traction_destroy(&now.shear.traction);
        rw_traction_destroy(&now.pressed);
        return NULL;
    }
    rw_numerical *n = rw_numerical_begin(frame, &now, true, NULL, NULL);
    if (n)
        rw_numerical_add_error(n, rw_bonded_error(frame));
    return n;
}

static int32_t begin_unlike(const rwedge_contact *c, const rw_frame *frame, rw_scaled_loads from,
                            rw_scaled_loads to, rw_numerical **begun)
{
    const bool is_alone = rw_is_symmetric(&c->geometry) && to.turn == 0 && to.shear == 0 &&
                          to.stretch == from.stretch;
    if (!is_alone || rw_bonded_error(frame) > frame->tolerance)
        return rw_numerical_of_growth(frame, from, to, begun);
    *begun = press_alone(frame, to);
    return *begun ? RWEDGE_OK : RWEDGE_ENOMEM;
}

int32_t rw_numerical_of_touching(const rwedge_contact *c, rw_scaled_loads to, rw_numerical **begun)
{
    const rw_frame frame = rw_contact_frame(c);
    const rw_scaled_loads from = rw_loads_before_touching(c, to);
    if (frame.B != 0)
        return begin_unlike(c, &frame, from, to, begun);
    const rw_scaled_loads change = {to.P, to.turn - from.turn, to.shear, to.stretch - from.stretch};
    rw_numerical_state now = {.contact = rw_patch_of_loads(&frame, to), .at = to};
    const double part = stuck_part(c, change, now.contact);
    if (part < 1) {
        now.at = rw_part_of_line(from, to, part);
        now.contact = rw_patch_of_loads(&frame, now.at);
    }
    *begun = part == FIRST_TOUCH && is_flat(&frame, from, &now)
                 ? begin_flat(&frame, from.stretch, &now)
                 : begin_in_proportion(c, &frame, change, &now);
    return *begun ? RWEDGE_OK : RWEDGE_ENOMEM;
}
