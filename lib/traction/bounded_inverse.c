/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "traction/bounded_inverse.h"

#include "base/tuned.h"
#include "traction/transform.h"

typedef struct {
    rw_patch patch;
    rw_values t;
    const void *context;
} divided;

/* |X| */
static double root_at(rw_patch patch, double x)
{
    return sqrt(fmax(0, x - patch.left)) * sqrt(fmax(0, patch.right - x));
}

static void density_at(const double x[], const void *context, double value[])
{
    const divided *d = context;
    d->t(x, d->context, value);
    for (int i = 0; i < RW_TERMS; i++) {
        const double root = root_at(d->patch, x[i]);
        value[i] = root > 0 ? value[i] / root : 0;
    }
}

static void add_moments(rw_bounded_inverse *inverse)
{
    const double middle = rw_patch_middle(inverse->patch),
                 half = rw_patch_half_width(inverse->patch);
    for (size_t i = 0; i < inverse->density.count; i++) {
        const rw_element *e = &inverse->density.elements[i];
        for (int k = 0; k < RW_TERMS; k++) {
            const double u = (e->x[k] - middle) / half;
            inverse->moment[0] += e->load[k];
            inverse->moment[1] += u * e->load[k];
            inverse->moment[2] += u * u * e->load[k];
        }
    }
}

bool rw_bounded_inverse_create(rw_bounded_inverse *inverse, rw_patch patch, rw_values t,
                               const void *context, size_t breaks, const double at[],
                               double tolerance)
{
    const divided d = {patch, t, context};
    *inverse = (rw_bounded_inverse){.patch = patch};
    if (!rw_traction_fit(&inverse->density, density_at, &d, breaks, at,
                         tolerance / rw_patch_half_width(patch), RW_FIT_NOISE)) {
        rw_bounded_inverse_destroy(inverse);
        return false;
    }
    add_moments(inverse);
    return true;
}

void rw_bounded_inverse_destroy(rw_bounded_inverse *inverse)
{
    rw_traction_destroy(&inverse->density);
    *inverse = (rw_bounded_inverse){.moment = {0}};
}

double rw_bounded_inverse_at(const rw_bounded_inverse *inverse, rw_patch patch, double x)
{
    const rw_patch own = inverse->patch;
    if (!(x > patch.left && x < patch.right))
        return 0;
    const double stretch = rw_patch_half_width(own) / rw_patch_half_width(patch);
    const double at = x < rw_patch_middle(patch) ? own.left + (x - patch.left) * stretch
                                                 : own.right - (patch.right - x) * stretch;
    return root_at(own, at) * rw_traction_slope(&inverse->density, at);
}

/* ---- As a traction ---- */

typedef struct {
    const rw_bounded_inverse *inverse;
    rw_patch patch;
    double factor;
} multiple;

static void multiple_at(const double x[], const void *context, double value[])
{
    const multiple *m = context;
    for (int i = 0; i < RW_TERMS; i++)
        value[i] = m->factor * rw_bounded_inverse_at(m->inverse, m->patch, x[i]);
}

typedef struct {
    const rw_traction *a, *b;
} pair;

static void sum_at(const double x[], const void *context, double value[])
{
    const pair *p = context;
    double other[RW_TERMS];
    rw_traction_values(p->a, RW_TERMS, x, value);
    rw_traction_values(p->b, RW_TERMS, x, other);
    for (int i = 0; i < RW_TERMS; i++)
        value[i] += other[i];
}

/* L[t] is slow to compute, and smoother than the other one: it is fitted first. */
bool rw_bounded_inverse_add(rw_traction *sum, const rw_traction *other,
                            const rw_bounded_inverse *inverse, rw_patch patch, double factor,
                            size_t breaks, const double at[], double tolerance)
{
    rw_traction alone = {0};
    const bool is_done =
        rw_traction_fit(&alone, multiple_at, &(multiple){inverse, patch, factor}, breaks, at,
                        RW_FIT_OF_INVERSE * tolerance, RW_FIT_NOISE) &&
        rw_traction_fit(sum, sum_at, &(pair){other, &alone}, breaks, at, tolerance, RW_FIT_NOISE);
    rw_traction_destroy(&alone);
    return is_done;
}
