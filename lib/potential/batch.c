/* SPDX-License-Identifier: GPL-3.0-or-later */
#define RW_VECTORS
#include "potential/batch.h"

#include "potential/closed_form.h"

void rw_clear_fields(int count, rw_fields *fields)
{
    for (int i = 0; i < count; i++)
        rw_put(fields, i, (rw_field){0, 0, 0, 0});
}

static void add(int n, double weight, const double *restrict part, double *restrict sum)
{
    for (int i = 0; i < n; i++)
        sum[i] += weight * part[i];
}

void rw_add_fields(const rw_fields *fields, double weight, int count, rw_fields *sum)
{
    add(count, weight, fields->G_re, sum->G_re);
    add(count, weight, fields->G_im, sum->G_im);
    add(count, weight, fields->H_re, sum->H_re);
    add(count, weight, fields->H_im, sum->H_im);
}

enum { WORTH_A_VECTOR = 3 }; /* fewer points are quicker one by one */

typedef rw_field formula(const rw_potential *p, rw_place at, rw_elliptic e);

/* The compiler inlines this for each formula and processor. It makes vector instructions of the
 * inner loop. */
RW_INLINE void apply(formula *right_field, const rw_potential *restrict p, int count,
                     const double *restrict x, const double *restrict y, rw_fields *restrict fields)
{
    for (int first = 0; first < count; first += RW_LANES)
        for (int i = first; i < first + RW_LANES; i++) {
            const rw_place at = rw_place_of(p, x[i], y[i]);
            const rw_field right = right_field(p, at, rw_elliptic_at(at.x, at.y, at.beyond));
            rw_put(fields, i, rw_mirrored(p, x[i], y[i], right));
        }
}

RW_INLINE void apply_its_formula(const rw_potential *p, int count, const double x[],
                                 const double y[], rw_fields *fields)
{
    if (p->alpha >= 1)
        apply(rw_hertz_field, p, count, x, y, fields);
    else
        apply(rw_rounded_field, p, count, x, y, fields);
}

RW_BEST_PROCESSOR(apply_best, apply_its_formula, rw_potential)

static bool is_remote(const rw_potential *p, double x, double y)
{
    const rw_place at = rw_place_of(p, x, y);
    return rw_is_remote(at.x, at.y);
}

void rw_potential_fields(const rw_potential *potential, int count, const double x[],
                         const double y[], rw_fields *fields)
{
    if (count < WORTH_A_VECTOR) {
        for (int i = 0; i < count; i++)
            rw_put(fields, i, rw_potential_at(potential, x[i], y[i]));
        return;
    }
    double near_x[RW_BATCH], near_y[RW_BATCH];
    bool all_near = true;
    for (int i = 0; i < count; i++) { /* the edge takes the place of a remote point */
        const bool near = !is_remote(potential, x[i], y[i]);
        near_x[i] = near ? x[i] : potential->half_width;
        near_y[i] = near ? y[i] : 0;
        all_near = all_near && near;
    }
    for (int i = count; i % RW_LANES != 0; i++) { /* fills the last vector */
        near_x[i] = near_x[count - 1];
        near_y[i] = near_y[count - 1];
    }
    apply_best(potential, count, near_x, near_y, fields);
    for (int i = 0; !all_near && i < count; i++)
        if (is_remote(potential, x[i], y[i]))
            rw_put(fields, i, rw_potential_at(potential, x[i], y[i]));
}
