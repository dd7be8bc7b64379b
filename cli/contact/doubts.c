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

void doubts_write(int32_t doubts, char *text, size_t size)
{
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2)
        if ((doubts & bit) != 0)
            list_add(text, size, "; ", "%s", rwedge_validity_text(bit));
}

void doubts_say(int32_t doubts, const char *where)
{
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2)
        if ((doubts & bit) != 0)
            notice("%s%s", where, rwedge_validity_text(bit));
}
