/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/compare.h"

#include <math.h>

/* Tractions are not compared nearer to a front than this part of the half-width: they rise there
 * like a square root, and a front moves with the error. */
static const double AT_FRONT = 0.01;

static bool is_at_front(const rw_numerical_state *s, double x)
{
    bool is_near = false;
    for (int i = 0; i + 1 < s->shear.zones.count; i++)
        is_near = is_near || fabs(x - s->shear.zones.zone[i].right) <
                                 AT_FRONT * rw_patch_half_width(s->contact);
    return is_near;
}

/* Places next to a front get the difference of the places beside them. */
static void spread(bool left_out[], double apart[])
{
    for (int i = 1; i < RW_PLACES; i++)
        if (left_out[i])
            apart[i] = apart[i - 1];
    for (int i = RW_PLACES - 1; i-- > 0;)
        if (left_out[i])
            apart[i] = fmax(apart[i], apart[i + 1]);
}

/* The error is at most this many times the difference of a step from its halves, in 97 of 100
 * histories (tests/proof/test_history_survey.c). Steps are of second order, or of a lower one where
 * a front runs back into a zone that slipped, and such errors add up. */
static const double DOUBT = 2;

/* Of places that came into contact in the step and stick: each errs in this step alone, and the
 * halves by 0.18 times as much as the whole. The error is largest at this part of the way from the
 * edge to where it was before. */
static const double DOUBT_IF_NEW = 0.5, WORST = 0.2;

/* Where the tractions at a place are compared. */
static double compared(rw_patch before, rw_patch now, double x)
{
    const double edge = x < before.left ? now.left : now.right;
    const double old = x < before.left ? before.left : before.right;
    return rw_patch_has(before, x) ? x : edge + WORST * (old - edge);
}

/* The differences of two tractions over the scale, by place, after a step from the contact
 * `before`. Returns the largest. */
static double difference(double scale, rw_patch before, const rw_numerical_state *a,
                         const rw_numerical_state *b, double apart[])
{
    bool left_out[RW_PLACES];
    double most = 0;
    for (int i = 0; i < RW_PLACES; i++) {
        const double place = rw_place(a->contact, i), x = compared(before, a->contact, place);
        const double doubt = rw_patch_has(before, place) ? DOUBT : DOUBT_IF_NEW;
        left_out[i] = is_at_front(a, place) || is_at_front(b, place);
        apart[i] = left_out[i] ? 0
                               : doubt *
                                     fabs(rw_traction_at(&a->shear.traction, x) -
                                          rw_traction_at(&b->shear.traction, x)) /
                                     scale;
        most = fmax(most, apart[i]);
    }
    spread(left_out, apart);
    return most;
}

/* Energies, over the square of scale and half-width, may differ by this many times the tolerance of
 * tractions. The energy of the halves is of second order. */
static const double ENERGY = 30;

double rw_compare(const rw_frame *frame, rw_patch before, const rw_numerical_state *whole,
                  const rw_numerical_state *half, rw_numerical_state *both)
{
    const double scale = rw_peak_friction(frame, whole->contact);
    const double unit = scale * rw_patch_half_width(whole->contact);
    const double energy = (both->energy - whole->energy) / (unit * unit);
    both->error += half->error + half->rate_error + both->rate_error;
    const double apart = difference(scale, before, whole, both, both->apart);
    both->energy += (both->energy - whole->energy) / 3;
    return fmax(both->error + apart, fabs(energy) / ENERGY) / frame->tolerance;
}
