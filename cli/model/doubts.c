/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "doubts.h"

#include "text/list.h"

#include <math.h>

#include <rwedge.h>

int32_t doubts_of(const contact_case *setup, double b, double safety)
{
    return rwedge_validity(setup->theta, b > 0 ? setup->a / b : NAN, setup->beta, setup->f,
                           setup->k / setup->E1, safety);
}

/* Beside the library's bits. */
enum { DOUBT_STATE = 1 << 20 };

int32_t doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor)
{
    double P = 0, M, Q, sigma;
    const double b = rwedge_contact_half_width(contact);
    if (!(factor < 1))
        return doubts_of(setup, b, NAN);
    rwedge_contact_loads(contact, &P, &M, &Q, &sigma);
    const double P_yield =
        rwedge_yield_load(setup->theta, setup->a, setup->A, setup->f, setup->nu1, setup->k);
    return doubts_of(setup, b, P_yield / P) | (P > P_yield ? 0 : DOUBT_STATE);
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
                              : rwedge_validity_text(bit);
}

void doubts_write(int32_t doubts, char *text, size_t size)
{
    for (int32_t bit = 1; bit > 0 && bit <= doubts; bit *= 2)
        if ((doubts & bit) != 0)
            list_add(text, size, "; ", "%s", doubt_text(bit));
}
