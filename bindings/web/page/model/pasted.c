/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tool's reader of rows asks for a file of text: here it is a text in memory. */
#include "page.h"

#include <stdlib.h>
#include <string.h>

struct text_input {
    const char *text;
};

static const char *pasted; /* the text that is opened next */
static const char MARK[] = "\xef\xbb\xbf";

text_input *text_input_open(const char *path, const char *encoding)
{
    (void)path, (void)encoding;
    text_input *in = malloc(sizeof *in);
    if (in != NULL)
        in->text = pasted;
    return in;
}

bool text_input_read(text_input *in, char *bytes, size_t room, size_t *count)
{
    *count = strlen(in->text);
    if (*count > room)
        *count = room;
    memcpy(bytes, in->text, *count);
    in->text += *count;
    return true;
}

const char *text_input_problem(const text_input *in)
{
    (void)in;
    return "";
}

bool text_input_has_mark(const text_input *in)
{
    (void)in;
    return false;
}

const char *text_input_name(const text_input *in)
{
    (void)in;
    return "the rows";
}

void text_input_close(text_input *in)
{
    free(in);
}

/* The reader says it where memory is short: nothing goes on then. */
int failure(const char *format, ...)
{
    (void)format;
    abort();
}

void pasted_offer(const char *text)
{
    pasted = text;
}

csv_input *pasted_open(const char *text)
{
    text += strncmp(text, MARK, 3) == 0 ? 3 : 0;
    text += strspn(text, "\r\n");
    const size_t line = strcspn(text, "\r\n");
    const char separator = memchr(text, '\t', line) != NULL  ? '\t'
                           : memchr(text, ';', line) != NULL ? ';'
                                                             : ',';
    pasted = text;
    return csv_input_open("", separator, NULL);
}

bool pasted_next(csv_input *in, csv_row *row, const char **problem)
{
    *problem = "";
    const csv_event event = csv_input_next(in);
    if (event == CSV_FAILED)
        *problem = csv_input_problem(in);
    if (event != CSV_ROW && event != CSV_MALFORMED)
        return false;
    csv_row_keep(in, event == CSV_MALFORMED, row);
    return true;
}
