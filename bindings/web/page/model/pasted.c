/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tool's reader of rows asks for a file of text: here it is a text in memory. */
#include "page.h"

#include <stdlib.h>
#include <string.h>

static const char *pasted; /* what has not been read of the text */
static const char MARK[] = "\xef\xbb\xbf";

text_input *text_input_open(const char *path, const char *encoding)
{
    (void)path, (void)encoding;
    text_input *in = memory_zeroed(1, sizeof *in);
    in->name = "the rows";
    return in;
}

bool text_input_read(text_input *in, char *bytes, size_t room, size_t *count)
{
    (void)in;
    *count = strlen(pasted);
    if (*count > room)
        *count = room;
    memcpy(bytes, pasted, *count);
    pasted += *count;
    return true;
}

void text_input_close(text_input *in)
{
    free(in);
}

/* The file that wasi-libc's printf() would say in that it has no long double: it would ask for the
 * system's calls, and there is no system. Nothing prints one. */
char __stderr_FILE[256];

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

csv_input *pasted_open(const char *text, csv_row *first)
{
    text += strncmp(text, MARK, 3) == 0 ? 3 : 0;
    const char *line = text + strspn(text, "\r\n");
    const size_t length = strcspn(line, "\r\n");
    const char separator = memchr(line, '\t', length) != NULL  ? '\t'
                           : memchr(line, ';', length) != NULL ? ';'
                                                               : ',';
    pasted = text;
    csv_input *in = csv_input_open("", separator, NULL);
    in->takes_malformed = true;
    *first = (csv_row){.cell = NULL};
    if (csv_input_next(in))
        csv_row_keep(in, first);
    return in;
}
