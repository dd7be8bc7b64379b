/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory, or the end of the command with a message. */
#ifndef CLI_MEMORY_H
#define CLI_MEMORY_H

#include <stddef.h>

/* As calloc() and realloc(), but they never return NULL. For the first thread alone. */
void *memory_zeroed(size_t count, size_t size);
void *memory_resized(void *old, size_t size);

/* Makes room for one more element of a list of `count` elements: the list doubles at powers of
 * two. */
void *memory_for_one_more(void *old, size_t count, size_t size);

/* A pointer from another function: ends the command where it is NULL. */
void *memory_checked(void *memory);

#endif
