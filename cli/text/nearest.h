/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which of several names was meant by one that does not exist. */
#ifndef CLI_NEAREST_H
#define CLI_NEAREST_H

#include <stddef.h>

typedef struct {
    const char *typed, *name; /* NULL where none is near */
    size_t distance;
} nearest;

nearest nearest_to(const char *typed);

/* Offers one of the names. */
void nearest_try(nearest *to, const char *name);

#endif
