/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bytes that grow: a script for another program, or what it answers. */
#ifndef CLI_BYTES_H
#define CLI_BYTES_H

#include <stdbool.h>
#include <stddef.h>

/* All zero is empty. Once memory runs out, nothing more is added and failed stays true. */
typedef struct {
    char *data;
    size_t length, room;
    bool failed;
} bytes;

void bytes_add(bytes *to, const void *data, size_t count);
void bytes_text(bytes *to, const char *text);

#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
void bytes_format(bytes *to, const char *format, ...); /* at most 255 characters at a time */

void bytes_free(bytes *what);

#endif
