/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "doubts.h"

#include "text/list.h"

#include <math.h>

#include <rwedge.h>

/* Beside the library's bits. */
enum { DOUBT_STATE = 1 << 20, DOUBT_SLOPE = 1 << 21 };

static const double STEEP = 0.1;

int32_t doubts_of(const contact_case *setup, double left, double right, double safety)
{
    const pad *shape = &setup->shape;
    const bool is_wedge = shape->kind == PAD_WEDGE, touches = right > left;
    const int32_t doubts =
        rwedge_validity(is_wedge ? shape->theta : NAN,
                        is_wedge && touches ? shape->a / (right / 2 - left / 2) : NAN, setup->beta,
                        setup->f, setup->k / setup->E1, safety);
    const bool is_steep = !is_wedge && touches && pad_steepest(shape, left, right) > STEEP;
    return doubts | (is_steep ? DOUBT_SLOPE : 0);
}

int32_t doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor)
{
    const pad *shape = &setup->shape;
    double P = 0, M, Q, sigma, left = 0, right = 0;
    rwedge_contact_edges(contact, &left, &right);
    if (!(factor < 1))
        return doubts_of(setup, left, right, NAN);
    rwedge_contact_loads(contact, &P, &M, &Q, &sigma);
    const double P_yield = /* not known of other pads */
        rwedge_yield_load(shape->theta, shape->a, setup->A, setup->f, setup->nu1, setup->k);
    return doubts_of(setup, left, right, P_yield / P) | (P > P_yield ? 0 : DOUBT_STATE);
}

int32_t doubts_of_state(const contact_case *setup, const rwedge_contact *contact)
{
    double factor = NAN;
    if (!isnan(setup->k))
        rwedge_contact_yield_factor(contact, setup->nu1, setup->k, &factor, NULL, NULL);
    return doubts_of_factor(setup, contact, factor);
}

const char *doubt_text(int32_t bit)
{
    return bit == DOUBT_STATE ? "a load yields the body: its stresses exceed the yield stress"
           : bit == DOUBT_SLOPE
               ? "the pad rises by more than 0.1 rad in the contact: it is hardly a half-plane"
               : rwedge_validity_text(bit);
}

void doubts_write(int32_t doubts, char *text, size_t size)
{
    for (int32_t bit = 1; bit > 0 && bit <= doubts; bit *= 2)
        if ((doubts & bit) != 0)
            list_add(text, size, "; ", "%s", doubt_text(bit));
}
