/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Some of the places of a batch, side by side: fields are computed for several at a time. */
#ifndef RW_PLACES_OF_BATCH_H
#define RW_PLACES_OF_BATCH_H

#include "potential/batch.h"

#include <stdbool.h>

enum { RW_WORTH_A_VECTOR = 3 }; /* fewer places are quicker one by one */

typedef struct {
    int count, place[RW_BATCH + 1]; /* numbers in the batch; one more is room */
} rw_places;

/* Adds a place where that is true, without a branch: it could not be foreseen. */
RW_INLINE void rw_places_put(rw_places *some, int place, bool is_one)
{
    some->place[some->count] = place;
    some->count += is_one;
}

/* Their coordinates; the first place fills the last vector. */
static inline void rw_places_read(const rw_places *some, const double of[], double each[])
{
    for (int i = 0; i < some->count; i++)
        each[i] = of[some->place[i]];
    for (int i = some->count; i % RW_LANES != 0; i++)
        each[i] = each[0];
}

static inline void rw_places_add(const rw_places *some, int i, rw_field own, rw_fields *sum)
{
    const rw_field before = rw_field_in(sum, some->place[i]);
    rw_put(sum, some->place[i],
           (rw_field){before.G_re + own.G_re, before.G_im + own.G_im, before.H_re + own.H_re,
                      before.H_im + own.H_im});
}

#endif
