/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same as batch.c for patches off the centre. */
#define RW_VECTORS
#include "stress/eccentric.h"

#include "stress/eccentric_form.h"

RW_INLINE void put(rw_fields *fields, int i, rw_field field)
{
    fields->G_re[i] = field.G_re;
    fields->G_im[i] = field.G_im;
    fields->H_re[i] = field.H_re;
    fields->H_im[i] = field.H_im;
}

enum { LANES = 8 };

/* Inlined for each formula and processor, the loop becomes vector instructions. */
RW_INLINE void apply(rw_side_formula *right_field, const rw_eccentric *restrict p, int count,
                     const double *restrict x, const double *restrict y, rw_fields *restrict fields)
{
    const rw_eccentric own = *p;
    const rw_half_view right = p->view[0], left = p->view[1];
    for (int first = 0; first < count; first += LANES)
        for (int i = first; i < first + LANES; i++) {
            put(fields, i, rw_eccentric_by(right_field, &own, &right, &left, x[i], y[i]));
        }
}

RW_INLINE void apply_its_formula(const rw_eccentric *p, int count, const double x[],
                                 const double y[], rw_fields *fields)
{
    if (p->inside == 0)
        apply(rw_side_hertz_field, p, count, x, y, fields);
    else if (p->inside == 1)
        apply(rw_side_half_rounded_field, p, count, x, y, fields);
    else if (p->corners.per_alpha == 0)
        apply(rw_side_sharp_field, p, count, x, y, fields);
    else
        apply(rw_side_rounded_field, p, count, x, y, fields);
}

static void apply_baseline(const rw_eccentric *p, int count, const double x[], const double y[],
                           rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(RW_BASELINE)
__attribute__((target("avx2"))) static void
apply_avx2(const rw_eccentric *p, int count, const double x[], const double y[], rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

static void apply_best(const rw_eccentric *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    (__builtin_cpu_supports("avx2") ? apply_avx2 : apply_baseline)(p, count, x, y, fields);
}
#else
static void apply_best(const rw_eccentric *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    apply_baseline(p, count, x, y, fields);
}
#endif

void rw_eccentric_fields(const rw_eccentric *p, int count, const double x[], const double y[],
                         rw_fields *fields)
{
    if (p->is_centred) {
        rw_potential_fields(&p->centred, count, x, y, fields);
        return;
    }
    double near_x[RW_BATCH], near_y[RW_BATCH];
    for (int i = 0; i < count; i++) {
        const bool far = rw_eccentric_is_far(p, x[i], y[i]);
        near_x[i] = far ? p->patch.right : x[i];
        near_y[i] = far ? 0 : y[i];
    }
    for (int i = count; i % LANES != 0; i++) { /* fills the last vector */
        near_x[i] = p->patch.right;
        near_y[i] = 0;
    }
    apply_best(p, count, near_x, near_y, fields);
    for (int i = 0; i < count; i++)
        if (rw_eccentric_is_far(p, x[i], y[i])) {
            put(fields, i, rw_eccentric_at(p, x[i], y[i]));
        }
}
