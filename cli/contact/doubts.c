/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "doubts.h"

#include "text/list.h"
#include "text/message.h"

#include <math.h>

#include <rwedge.h>

int32_t doubts_of(const contact_case *what, double b, double safety)
{
    return rwedge_validity(what->theta, b > 0 ? what->a / b : NAN, what->beta, what->f,
                           what->k / what->E1, safety);
}

/* Beside the library's bits. */
enum { DOUBT_STATE = 1 << 20 };

int32_t doubts_of_state(const contact_case *setup, const rwedge_contact *contact, double factor)
{
    load now = {0};
    const double b = rwedge_contact_half_width(contact);
    if (!(factor < 1))
        return doubts_of(setup, b, NAN);
    rwedge_contact_loads(contact, &now.P, &now.M, &now.Q, &now.sigma);
    const double P_yield =
        rwedge_yield_load(setup->theta, setup->a, setup->A, setup->f, setup->nu1, setup->k);
    return doubts_of(setup, b, P_yield / now.P) | (now.P > P_yield ? 0 : DOUBT_STATE);
}

static const char *text_of(int32_t bit)
{
    return bit == DOUBT_STATE ? "a load yields the body: its stresses exceed the yield stress"
                              : rwedge_validity_text(bit);
}

void doubts_write(int32_t doubts, char *text, size_t size)
{
    for (int32_t bit = 1; bit <= DOUBT_STATE; bit *= 2)
        if ((doubts & bit) != 0)
            list_add(text, size, "; ", "%s", text_of(bit));
}

void doubts_say(int32_t doubts, const char *where)
{
    for (int32_t bit = 1; bit <= DOUBT_STATE; bit *= 2)
        if ((doubts & bit) != 0)
            notice("%s%s", where, text_of(bit));
}
