/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "options.h"

#include "text/text.h"
#include "system/system.h"

int threads_read(const arguments *line)
{
    const char *text = line->value[OPTION_THREADS];
    int64_t number = processors() < AHEAD_THREADS_MAX ? processors() : AHEAD_THREADS_MAX;
    if (text != NULL && !number_read_whole(text, 1, AHEAD_THREADS_MAX, &number))
        usage_error("--threads %s: must be a whole number from 1 to %d", text, AHEAD_THREADS_MAX);
    return (int)number;
}
