/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Memory, or the end of the command with a message. */
#ifndef CLI_MEMORY_H
#define CLI_MEMORY_H

#include <stddef.h>

/* As calloc() and realloc(), for the first thread alone. They do not return NULL. */
void *memory_zeroed(size_t count, size_t size);
void *memory_resized(void *old, size_t size);

/* Of so many things of a size, with room for one more: it doubles at powers of two. */
void *memory_for_one_more(void *old, size_t count, size_t size);

/* What another function gives: the end where it is NULL. */
void *memory_checked(void *memory);

#endif
