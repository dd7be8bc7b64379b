/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/computed_shear.h"

#include "base/array.h"
#include "base/domain.h"
#include "base/tuned.h"

#include <stdlib.h>
#include <string.h>

bool rw_numerical_cluster(rw_numerical *n)
{
    return rw_traction_cluster(&n->now.shear.traction) && rw_traction_cluster(&n->now.pressed);
}

rw_numerical *rw_numerical_begin(const rw_frame *frame, const rw_numerical_state *now,
                                 bool has_origin, rw_values slip, const void *context)
{
    rw_numerical_state begun = *now;
    begun.is_still = true;
    begun.peak = rw_peak_friction(frame, now->contact);
    begun.unslipped = now->contact;
    rw_numerical *n = malloc(sizeof *n);
    if (!n) {
        rw_traction_destroy(&begun.shear.traction);
        rw_traction_destroy(&begun.pressed);
        return NULL;
    }
    *n = (rw_numerical){.now = begun};
    if (rw_numerical_cluster(n) &&
        (!has_origin || rw_numerical_count_slip(n, frame, slip, context)))
        return n;
    rw_numerical_destroy(n);
    return NULL;
}

rw_numerical *rw_numerical_copy(const rw_numerical *n, bool *is_whole)
{
    rw_numerical *copy = rw_copied(n, n != NULL, sizeof *copy, is_whole);
    if (!copy)
        return NULL;
    copy->now.shear.traction = rw_traction_copy(&n->now.shear.traction, is_whole);
    copy->now.pressed = rw_traction_copy(&n->now.pressed, is_whole);
    copy->origin = rw_traction_copy(&n->origin, is_whole);
    copy->friction.traction = rw_traction_copy(&n->friction.traction, is_whole);
    return copy;
}

void rw_numerical_destroy(rw_numerical *n)
{
    if (!n)
        return;
    rw_traction_destroy(&n->now.shear.traction);
    rw_traction_destroy(&n->now.pressed);
    rw_traction_destroy(&n->origin);
    rw_friction_destroy(&n->friction);
    free(n);
}

/* ---- Errors ---- */

double rw_numerical_error(const rw_numerical *n)
{
    double most = n->now.error; /* states of 1.2.0 have the other errors alone */
    for (int i = 0; i < RW_PLACES; i++)
        most = fmax(most, n->error[i]);
    return most;
}

/* Both the traction and the true one are within friction. */
static const double MOST_ERROR = 2;

void rw_numerical_rescale(rw_numerical *n, double factor)
{
    for (int i = 0; i < RW_PLACES; i++)
        n->error[i] = fmin(MOST_ERROR, factor * n->error[i]);
    n->now.error = fmin(MOST_ERROR, factor * n->now.error);
}

void rw_numerical_add_error(rw_numerical *n, double error)
{
    if (error == 0)
        return;
    for (int i = 0; i < RW_PLACES; i++)
        if (rw_zones_label(&n->now.shear.zones, rw_place(n->now.contact, i)) == 0)
            n->error[i] = hypot(n->error[i], error);
    n->now.error = hypot(n->now.error, error);
}

static double error_at(const rw_numerical *n, double x)
{
    const rw_patch contact = n->now.contact;
    const double cosine = (rw_patch_middle(contact) - x) / rw_patch_half_width(contact);
    return fabs(cosine) < 1 ? n->error[(int)(acos(cosine) * RW_PLACES / RW_PI)] : 0;
}

/* Whether a place that sticks after a step stuck all the time, as far as its halves tell. */
static bool has_stuck(const rw_numerical_state *from, const rw_numerical_state *half, double x)
{
    return rw_patch_has(from->contact, x) && rw_zones_label(&from->shear.zones, x) == 0 &&
           rw_zones_label(&half->shear.zones, x) == 0;
}

/* Where it sticks the relative displacement is that of the moment when it began to stick, and so is
 * its error. The traction follows from that displacement and from the tractions of all other
 * places: these errors are of the present step, whatever the steps before it were. But what sticks
 * by the grid moves a little, and slip that has gone too far shows when it ends. What fits lose
 * does not add up: it changes its sign within an element, and the fit of the next step takes its
 * mean. */
void rw_numerical_note_error(rw_numerical *n, const rw_numerical_state *half, rw_numerical_state *s,
                             double tolerance)
{
    const double at_most = hypot(s->error, RW_FIT_AT_MOST * tolerance);
    double error[RW_PLACES], most = at_most;
    for (int i = 0; i < RW_PLACES; i++) {
        const double x = rw_place(s->contact, i), before = error_at(n, x);
        const bool slips = rw_zones_label(&s->shear.zones, x) != 0;
        const bool is_old = has_stuck(&n->now, half, x);
        const bool slipped = rw_zones_label(&n->now.shear.zones, x) != 0;
        error[i] = slips    ? s->end_error
                   : is_old ? hypot(before, s->drift)
                            : s->error + s->apart[i] + (slipped ? before : 0);
        most = slips ? most : fmax(most, (is_old ? hypot(before, at_most) : at_most) + s->apart[i]);
    }
    memcpy(n->error, error, sizeof error);
    s->error = most;
}
