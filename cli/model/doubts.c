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

void doubts_write(int32_t doubts, char *text, size_t size)
{
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2)
        if ((doubts & bit) != 0)
            list_add(text, size, "; ", "%s", rwedge_validity_text(bit));
}
