/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "records.h"

#include "text/message.h"

bool records_go_on(const records *rows)
{
    return rows->out->error == 0 && rows->problem == NULL;
}

bool records_are_sound(const records *rows)
{
    if (rows->problem != NULL)
        failure("%s: %s", rows->out->name, rows->problem);
    return rows->problem == NULL;
}
