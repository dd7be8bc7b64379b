/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "text.h"

#include <stdlib.h>

void *memory_checked(void *memory)
{
    if (memory == NULL)
        failure("out of memory");
    return memory;
}

/* Nothing may be NULL, which is no lack of memory. */
static size_t some(size_t size)
{
    return size > 0 ? size : 1;
}

void *memory_zeroed(size_t count, size_t size)
{
    return memory_checked(calloc(some(count), some(size)));
}

void *memory_resized(void *old, size_t size)
{
    return memory_checked(realloc(old, some(size)));
}

void *memory_for_one_more(void *old, size_t count, size_t size)
{
    const bool is_full = (count & (count - 1)) == 0;
    return is_full ? memory_resized(old, (count > 0 ? 2 * count : 1) * size) : old;
}
