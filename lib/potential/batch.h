/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential at many points at once, by vector instructions. */
#ifndef RW_BATCH_H
#define RW_BATCH_H

#include "base/processor.h"
#include "potential/potential.h"

/* The bits of rw_potential_at(), at count <= RW_BATCH points: several times faster. */
enum { RW_BATCH = 32 };
typedef struct {
    double G_re[RW_BATCH], G_im[RW_BATCH], H_re[RW_BATCH], H_im[RW_BATCH];
} rw_fields;

static inline rw_field rw_field_in(const rw_fields *fields, int i)
{
    return (rw_field){fields->G_re[i], fields->G_im[i], fields->H_re[i], fields->H_im[i]};
}

RW_INLINE void rw_put(rw_fields *fields, int i, rw_field field)
{
    fields->G_re[i] = field.G_re;
    fields->G_im[i] = field.G_im;
    fields->H_re[i] = field.H_re;
    fields->H_im[i] = field.H_im;
}

/* Sums of fields. */
void rw_clear_fields(int count, rw_fields *fields);
void rw_add_fields(const rw_fields *fields, double weight, int count, rw_fields *sum);

void rw_potential_fields(const rw_potential *potential, int count, const double x[],
                         const double y[], rw_fields *fields);

/* The loops over many points take so many at a time, a multiple of the numbers in a vector. */
enum { RW_LANES = 8 };

/* Defines NAME(potential, count, x, y, fields), which does LOOP for the processor at hand. */
#define RW_BEST_PROCESSOR(NAME, LOOP, POTENTIAL)                                                   \
    RW_DISPATCH(                                                                                   \
        NAME, LOOP,                                                                                \
        (const POTENTIAL *p, int count, const double x[], const double y[], rw_fields *fields),    \
        (p, count, x, y, fields))

#endif
