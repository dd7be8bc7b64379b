/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A text of several parts, such as "csv, tsv, json". */
#ifndef CLI_LIST_H
#define CLI_LIST_H

#include "printf_like.h"

#include <stddef.h>

/* Adds a part, made as by printf, to the text; the separator goes in front of all but the first.
 * What has no room is cut. */
void list_add(char *text, size_t size, const char *separator, const char *format, ...)
    PRINTF_LIKE(4, 5);

#endif
