/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of an elastic-limit table, as what they state. Numbers are the decimals that are
 * printed, not doubles near them. */
#ifndef ENTRY_H
#define ENTRY_H

#include "field.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum {
    PROVED,
    /* a point has a higher J2, hence a lower limit, than is stated or than the stated place has */
    EXCEEDED,
    NOT_REACHED, /* J2 at the stated place is lower */
    MISNAMED,    /* the branch is not where the place is */
    OPEN         /* neither proved nor refuted */
} verdict;
enum { VERDICTS = OPEN + 1 };

typedef struct {
    char a_over_b[32]; /* as printed: what entries of one contact share */
    const char *file;
    size_t line;
    arb_t alpha, f, kappa; /* kappa = (1-2nu)^2/3 */
    arb_t limit;           /* P/(bk) */
    acb_t place;           /* where, over b */
    bool at_surface;       /* what the column `branch` says */

    /* What is found of it. */
    /* J2, (theta/A)^2, to be proved an upper bound: a little above that at the place */
    double ceiling;
    arb_t least, most;         /* the enclosure of the limit, if PROVED */
    double beyond_x, beyond_y; /* where it is exceeded, if EXCEEDED */
    verdict is;
} entry;

/* Appends the rows of the file to entries[0..*count); false, with a message, where it is not
 * such a table. */
bool entries_read(entry **entries, size_t *count, const char *file);
void entries_free(entry *entries, size_t count);

/* Groups the entries by a/b, in the order of a/b. */
void entries_sort(entry *entries, size_t count);

/* The limit that the stated place alone gives. */
double entry_limit_there(const entry *e);

/* How far the enclosure of the limit reaches from what is stated, relatively. */
double entry_distance(const entry *e);

/* Is the whole enclosure within half a unit of the tenth digit, so that the rounding is proved
 * too? */
bool entry_is_rounded(const entry *e);

#endif
