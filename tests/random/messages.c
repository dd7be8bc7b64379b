/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Takes the place of cli/text/message.c. Messages are formatted and thrown away. */
#include "text/message.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

const char *message_speaker(void)
{
    return "rwedge";
}

static void say(const char *format, va_list values)
{
    char line[4096];
    vsnprintf(line, sizeof line, format, values);
}

int usage_error(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    exit(STATUS_USAGE);
}

int failure(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    exit(STATUS_FAILED);
}

void notice(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
}
