/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "notices.h"

#include "model/doubts.h"
#include "text/message.h"

void doubts_say(int32_t doubts, const char *where)
{
    for (int32_t bit = 1; bit > 0 && bit <= doubts; bit *= 2)
        if ((doubts & bit) != 0)
            notice("%s%s", where, doubt_text(bit));
}
