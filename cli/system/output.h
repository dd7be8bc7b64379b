/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where results go. A file appears whole or not at all: it is written beside its target under
 * another name, flushed to the disk, and renamed. If anything goes wrong before that, the old file
 * stays as it was. Standard output, pipes and devices are written to directly; their errors are
 * noticed too. */
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>
#include <stddef.h>

enum { OUTPUT_BUFFER = 1 << 14 }; /* it is on the stack */

typedef struct {
    const char *name; /* as the user knows it */
    char *target;     /* the file to replace, links followed; NULL where written to directly */
    char *unfinished; /* the file beside it */
    int descriptor;
    int error; /* errno of the first failure; nothing is written after it */
    size_t used;
    char buffer[OUTPUT_BUFFER];
} output;

/* Opens the output; NULL or "-" is standard output. One output is open at a time. If the command
 * ends by a mistake, a file is left as it was; rows for standard output, a pipe or a device are
 * written up to there. */
void output_open(output *out, const char *path);

bool output_is_stdout(const output *out);

/* Adds bytes; false once something has gone wrong. */
bool output_write(output *out, const char *bytes, size_t count);
bool output_text(output *out, const char *text);

/* Makes the result appear. */
void output_finish(output *out);

#endif
