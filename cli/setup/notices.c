/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

void doubts_say(doubts all, const char *where)
{
    char text[DOUBT_SIZE];
    while (doubts_next(&all, text))
        notice("%s%s", where, text);
}

void status_check(int32_t status, const char *subject)
{
    if (status != RWEDGE_OK)
        failure("%s: %s", subject, rwedge_strerror(status));
}

void unused_say(const header *names, const char *file)
{
    char text[600] = "";
    header_write_unused(names, text, sizeof text);
    if (text[0] != '\0')
        notice("%s: %s", file, text);
}
