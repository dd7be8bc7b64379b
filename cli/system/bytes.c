/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bytes.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool make_room(bytes *to, size_t count)
{
    if (to->failed || count > SIZE_MAX / 4 || to->length > SIZE_MAX / 4) {
        to->failed = true;
        return false;
    }
    if (to->length + count <= to->room)
        return true;
    const size_t room = 2 * (to->length + count) + 1024;
    char *longer = realloc(to->data, room);
    to->failed = longer == NULL;
    if (longer == NULL)
        return false;
    to->data = longer;
    to->room = room;
    return true;
}

void bytes_add(bytes *to, const void *data, size_t count)
{
    if (count == 0 || !make_room(to, count))
        return;
    memcpy(to->data + to->length, data, count);
    to->length += count;
}

void bytes_text(bytes *to, const char *text)
{
    bytes_add(to, text, strlen(text));
}

void bytes_format(bytes *to, const char *format, ...)
{
    char line[256];
    va_list values;
    va_start(values, format);
    const int length = vsnprintf(line, sizeof line, format, values);
    va_end(values);
    if (length < 0 || (size_t)length >= sizeof line)
        to->failed = true;
    else
        bytes_add(to, line, (size_t)length);
}

void bytes_free(bytes *what)
{
    free(what->data);
    *what = (bytes){0};
}
