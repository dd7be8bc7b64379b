/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same as batch.c for patches off the centre. */
#define RW_VECTORS
#include "potential/eccentric.h"

#include "potential/eccentric_form.h"

/* Inlined for each formula and processor, the loop becomes vector instructions. */
RW_INLINE void apply(rw_side_formula *right_field, const rw_eccentric *restrict p, int count,
                     const double *restrict x, const double *restrict y, rw_fields *restrict fields)
{
    const rw_eccentric own = *p;
    const rw_half_view right = p->view[0], left = p->view[1];
    for (int first = 0; first < count; first += RW_LANES)
        for (int i = first; i < first + RW_LANES; i++)
            rw_put(fields, i, rw_eccentric_by(right_field, &own, &right, &left, x[i], y[i]));
}

RW_INLINE void apply_its_formula(const rw_eccentric *p, int count, const double x[],
                                 const double y[], rw_fields *fields)
{
    if (p->inside == 0)
        apply(rw_side_hertz_field, p, count, x, y, fields);
    else if (p->inside == 1)
        apply(rw_side_half_rounded_field, p, count, x, y, fields);
    else if (p->ends.per_alpha == 0)
        apply(rw_side_sharp_field, p, count, x, y, fields);
    else
        apply(rw_side_rounded_field, p, count, x, y, fields);
}

RW_BEST_PROCESSOR(apply_best, apply_its_formula, rw_eccentric)

void rw_eccentric_fields(const rw_eccentric *p, int count, const double x[], const double y[],
                         rw_fields *fields)
{
    if (p->is_centred) {
        rw_potential_fields(&p->centred, count, x, y, fields);
        return;
    }
    double near_x[RW_BATCH], near_y[RW_BATCH];
    const int far = rw_near_points(p, count, x, y, near_x, near_y);
    apply_best(p, count, near_x, near_y, fields);
    for (int i = 0; far > 0 && i < count; i++)
        if (rw_eccentric_is_far(p, x[i], y[i]))
            rw_put(fields, i, rw_eccentric_at(p, x[i], y[i]));
}
