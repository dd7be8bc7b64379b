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
    pasted = text + (strncmp(text, MARK, 3) == 0 ? 3 : 0);
}

/* The problem of a table, without the name of its file, which has none. */
const char *pasted_problem(const table_input *rows)
{
    const char *text = rows->in->problem.text, *name = rows->in->name;
    const size_t length = strlen(name);
    return strncmp(text, name, length) == 0 && strncmp(text + length, ": ", 2) == 0
               ? text + length + 2
               : text;
}
