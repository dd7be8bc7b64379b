/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static char *whole;
static size_t used, room;

static void append(const char *text, size_t length)
{
    if (room - used <= length) {
        room = 2 * (used + length) + 1000;
        whole = memory_resized(whole, room);
    }
    memcpy(whole + used, text, length);
    used += length;
    whole[used] = '\0';
}

/* Whether an option of the tool begins there: the page has none, and calls its fields by the same
 * names without dashes. */
static bool is_option(const char *text, bool begins_word)
{
    return begins_word && text[0] == '-' && text[1] == '-' && isalpha((unsigned char)text[2]);
}

/* Between quotes; a text that is not there is null. */
static void append_text(const char *text)
{
    if (text == NULL) {
        append("null", 4);
        return;
    }
    const char *whole_text = text;
    append("\"", 1);
    for (; *text != '\0'; text++) {
        char code[8];
        if (is_option(text, text == whole_text || text[-1] == ' '))
            text++;
        else if (*text == '"' || *text == '\\' || (unsigned char)*text < ' ')
            append(code, (size_t)snprintf(code, sizeof code, "\\u%04x", (unsigned)*text));
        else
            append(text, 1);
    }
    append("\"", 1);
}

const char *json_digits(double number, char text[NUMBER_SIZE])
{
    text[0] = '\0';
    if (isinf(number))
        snprintf(text, NUMBER_SIZE, number > 0 ? "inf" : "-inf");
    else if (!isnan(number))
        number_write(number, NUMBER_DIGITS, '.', text);
    return text;
}

/* JSON has no infinity, but what is too large is one. */
static void append_number(double number)
{
    char text[NUMBER_SIZE];
    const char *digits = isnan(number)   ? "null"
                         : isinf(number) ? number > 0 ? "1e999" : "-1e999"
                                         : json_digits(number, text);
    append(digits, strlen(digits));
}

void json_add(const char *form, ...)
{
    va_list values;
    va_start(values, form);
    if (used > 0 && strchr("[{:", whole[used - 1]) == NULL && strchr("]}", *form) == NULL)
        append(",", 1);
    for (; *form != '\0'; form++)
        if (*form != '%')
            append(*form == '\'' ? "\"" : form, 1);
        else if (*++form == 't')
            append_text(va_arg(values, const char *));
        else
            append_number(va_arg(values, double));
    va_end(values);
}

void json_begin(void)
{
    used = 0;
    append("[", 1);
}

bool json_refuse(const char *input, const char *format, ...)
{
    char why[1200];
    va_list values;
    va_start(values, format);
    vsnprintf(why, sizeof why, format, values);
    va_end(values);
    json_begin();
    json_fault(input, why);
    return false;
}

void json_fault(const char *input, const char *why)
{
    json_add("{'faults':[{'input':%t,'text':%t}]}", input, why);
}

const char *json_end(void)
{
    append("]", 1);
    return whole;
}
