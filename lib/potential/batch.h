/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The potential at many points at once, by vector instructions. */
#ifndef RW_BATCH_H
#define RW_BATCH_H

#include "base/select.h"
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

#endif
