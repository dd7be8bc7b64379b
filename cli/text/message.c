/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static const char *speaker_name = "rwedge";

void message_speaker_is(const char *speaker)
{
    speaker_name = speaker;
}

const char *message_speaker(void)
{
    return speaker_name;
}

static bool is_shown(uint32_t code)
{
    return !utf8_is_command(code);
}

/* Messages quote what the user typed: a newline or an escape sequence in it must not break the
 * line or the terminal. */
static void say(const char *format, va_list values)
{
    char line[2048], shown[2048];
    if (vsnprintf(line, sizeof line, format, values) <= 0)
        return;
    utf8_copy(line, is_shown, "?", shown, sizeof shown);
    fprintf(stderr, "%s: %s\n", speaker_name, shown);
}

int usage_error(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    exit(STATUS_USAGE);
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
    exit(STATUS_FAILED);
}
