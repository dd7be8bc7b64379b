/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "message.h"

#include <stdarg.h>
#include <stdio.h>

static const char *speaker_name = "rwedge";

void message_speaker_is(const char *speaker)
{
    speaker_name = speaker;
}

const char *message_speaker(void)
{
    return speaker_name;
}

/* Messages quote what the user typed: a newline or an escape sequence in it must not break the
 * line or the terminal. */
static void say(const char *format, va_list values)
{
    char line[2048];
    if (vsnprintf(line, sizeof line, format, values) < 0)
        return;
    for (char *c = line; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            *c = '?';
    fprintf(stderr, "%s: %s\n", speaker_name, line);
}

int usage_error(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    return STATUS_USAGE;
}

void notice(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
}

int failure(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    return STATUS_FAILED;
}
