/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays that grow, and their copies. */
#ifndef RW_ARRAY_H
#define RW_ARRAY_H

#include "base/always.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* An array of `count` things of a size, with room for `more`, at least one: the array itself, or
 * where its capacity was too small, the larger one in its place. NULL where memory is short; the
 * array is as before. */
static inline void *rw_grown(void *array, size_t count, size_t *capacity, size_t more, size_t size)
{
    if (*capacity - count >= more)
        return array;
    if (NEVER(count > SIZE_MAX / size / 2 - more)) /* memory ends before */
        return NULL;
    const size_t larger = count + count / 2 + more;
    void *grown = realloc(array, larger * size);
    if (grown)
        *capacity = larger;
    return grown;
}

/* A copy of an array of `count` things of a size; NULL of none. Where memory is short it is NULL
 * too, and `is_whole` becomes false. */
static inline void *rw_copied(const void *array, size_t count, size_t size, bool *is_whole)
{
    void *copy = count > 0 ? malloc(count * size) : NULL;
    if (copy)
        memcpy(copy, array, count * size);
    *is_whole = *is_whole && (copy || count == 0);
    return copy;
}

#endif
