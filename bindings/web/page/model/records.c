/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include "number/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Control characters for just this, which no text has. */
static const char BETWEEN_FIELDS[] = "\x1f", BETWEEN_RECORDS[] = "\x1e";

static char *whole;
static size_t used, room;

static void append(const char *text)
{
    const size_t length = strlen(text);
    if (room - used <= length) {
        char *larger = realloc(whole, 2 * (used + length) + 1000);
        if (larger == NULL)
            return;
        whole = larger;
        room = 2 * (used + length) + 1000;
    }
    memcpy(whole + used, text, length + 1);
    used += length;
}

void records_begin(void)
{
    used = 0;
}

void records_text(const char *text)
{
    append(BETWEEN_FIELDS);
    append(text);
}

void records_number(double number)
{
    char text[NUMBER_SIZE] = "";
    if (isinf(number))
        snprintf(text, sizeof text, number > 0 ? "inf" : "-inf");
    else if (!isnan(number))
        number_write(number, NUMBER_DIGITS, '.', text);
    records_text(text);
}

void records_add(const char *kind, const char *form, ...)
{
    va_list fields;
    va_start(fields, form);
    if (used > 0)
        append(BETWEEN_RECORDS);
    append(kind);
    for (; *form != '\0'; form++)
        if (*form == 't')
            records_text(va_arg(fields, const char *));
        else
            records_number(va_arg(fields, double));
    va_end(fields);
}

void records_refuse(const char *input, const char *why)
{
    records_begin();
    records_add("refused", "tt", input, why);
}

const char *records_end(void)
{
    return used > 0 ? whole : "";
}
