/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The factor on the stresses of a cycle with which a criterion has a given value. */
#include "base/root.h"
#include "measures/catalogue.h"
#include "measures/criterion.h"

#include <stdlib.h>

/* Beyond these factors nothing is looked for. */
static const double LEAST = 1e-30, MOST = 1e30;

/* A criterion of a cycle at a point, and room for its stresses times a factor. */
typedef struct {
    int32_t criterion;
    const double *constants;
    double limit;
    rw_stress_field field;
    double *stress;  /* 3 loads numbers */
    int32_t *status; /* of the first value that is none */
} question;

/* NaN where it has none: the stresses are too large, or memory too short. */
static double value_with(double factor, const question *of)
{
    const rw_stress_field *f = &of->field;
    double *sxx = of->stress, *syy = sxx + f->loads, *txy = syy + f->loads;
    double value, angle, out_of_plane;
    for (size_t i = 0; i < f->loads; i++) {
        sxx[i] = factor * f->sxx[i];
        syy[i] = factor * f->syy[i];
        txy[i] = factor * f->txy[i];
    }
    const int32_t status =
        rwedge_criterion(of->criterion, of->constants, f->loads, sxx, syy, txy, f->nu,
                         f->is_plane_stress, &value, &angle, &out_of_plane);
    if (*of->status == RWEDGE_OK)
        *of->status = status;
    return status == RWEDGE_OK ? value : NAN;
}

static double excess(double factor, const void *of)
{
    const question *asked = of;
    return value_with(factor, asked) - asked->limit;
}

/* The search begins with a factor of 1, where the criterion has that value, and doubles or halves
 * it as far as factors are looked for; NaN where the limit is not passed. */
static double search(const question *asked, double value)
{
    const bool rises = value < asked->limit;
    double from = 1;
    while (from >= LEAST && from <= MOST) {
        const double to = rises ? 2 * from : from / 2, there = excess(to, asked);
        if (isnan(there))
            break;
        if (rises ? there >= 0 : there <= 0)
            return rw_root(excess, asked, fmin(from, to), fmax(from, to), 0);
        from = to;
    }
    return NAN;
}

static double factor_of(const question *asked, double value)
{
    const int degree = rw_measure_of(asked->criterion)->degree;
    if (degree == 0)
        return value == asked->limit ? 1 : search(asked, value);
    if (value < asked->limit * LEAST * LEAST)
        return NAN;
    return degree == 1 ? asked->limit / value : sqrt(asked->limit / value);
}

int32_t rwedge_criterion_factor(int32_t criterion, const double constants[], double limit, size_t n,
                                const double sxx[], const double syy[], const double txy[],
                                double nu, int32_t plane_stress, double *factor)
{
    double value, angle, out_of_plane;
    if (!factor)
        return RWEDGE_ENULL;
    int32_t status = rwedge_criterion(criterion, constants, n, sxx, syy, txy, nu, plane_stress,
                                      &value, &angle, &out_of_plane);
    if (status != RWEDGE_OK)
        return status;
    if (!rw_is_positive(limit))
        return RWEDGE_EDOMAIN;
    question asked = {criterion,
                      constants,
                      limit,
                      rw_stress_field_of(n, 1, sxx, syy, txy, nu, plane_stress),
                      malloc(3 * n * sizeof(double)),
                      &status};
    if (!asked.stress)
        return RWEDGE_ENOMEM;
    const double found = factor_of(&asked, value);
    free(asked.stress);
    if (status == RWEDGE_ENOMEM)
        return status;
    if (!(isgreaterequal(found, LEAST) && islessequal(found, MOST)))
        return RWEDGE_EABSENT;
    *factor = found;
    return RWEDGE_OK;
}
