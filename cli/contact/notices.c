/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "notices.h"

#include "text/message.h"

#include <rwedge.h>

void doubts_say(int32_t doubts, const char *where)
{
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2)
        if ((doubts & bit) != 0)
            notice("%s%s", where, rwedge_validity_text(bit));
}
