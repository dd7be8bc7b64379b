/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Takes the place of cli/text/message.c. Messages are formatted and thrown away. */
#include "text/message.h"

#include <stdarg.h>
#include <stdio.h>

const char *message_speaker(void)
{
    return "rwedge";
}

static int say(const char *format, va_list values, int status)
{
    char line[4096];
    vsnprintf(line, sizeof line, format, values);
    return status;
}

#define SAYS(name, status)                                                                         \
    {                                                                                              \
        va_list values;                                                                            \
        va_start(values, format);                                                                  \
        const int said = say(format, values, status);                                              \
        va_end(values);                                                                            \
        return said;                                                                               \
    }

int usage_error(const char *format, ...) SAYS(usage_error, STATUS_USAGE)

    int failure(const char *format, ...) SAYS(failure, STATUS_FAILED)

        void notice(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values, STATUS_DONE);
    va_end(values);
}
