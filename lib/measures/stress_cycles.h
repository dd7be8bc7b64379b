/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles of stresses at many points, as the measures take them. */
#ifndef RW_STRESS_CYCLES_H
#define RW_STRESS_CYCLES_H

#include "base/domain.h"
#include "rwedge.h"

#include <stdint.h>

/* The stress of load i at point j is at [i points + j]. across: the stress across the plane over
 * sxx+syy; nu in plane strain, 0 in plane stress. */
typedef struct {
    size_t loads, points;
    const double *sxx, *syy, *txy;
    double nu, across;
    bool is_plane_stress;
} rw_stress_field;

/* Numbers for each point of a field; the angles are those of the plane, 0 where there is none. */
typedef struct {
    double *value, *angle, *out_of_plane;
} rw_criterion_results;

/* A criterion of a field that can be measured, by constants in their ranges. */
typedef int32_t rw_criterion_of_field(const rw_stress_field *f, const double constants[],
                                      const rw_criterion_results *results);

/* The range of sxx, which needs no constants. */
rw_criterion_of_field rw_stress_range;

static inline bool rw_is_switch(int32_t value)
{
    return value == 0 || value == 1;
}

static inline rw_stress_field rw_stress_field_of(size_t loads, size_t n, const double sxx[],
                                                 const double syy[], const double txy[], double nu,
                                                 int32_t plane_stress)
{
    return (rw_stress_field){loads, n, sxx, syy, txy, nu, plane_stress ? 0 : nu, plane_stress != 0};
}

static inline bool rw_field_in_domain(const rw_stress_field *f)
{
    for (size_t i = 0; i < f->loads * f->points; i++)
        if (!rw_is_stress(f->sxx[i]) || !rw_is_stress(f->syy[i]) || !rw_is_stress(f->txy[i]))
            return false;
    return true;
}

/* RWEDGE_OK if the field can be measured; has_results tells that no array of results is NULL. */
static inline int32_t rw_field_status(const rw_stress_field *f, bool has_results)
{
    if (!f->sxx || !f->syy || !f->txy || !has_results)
        return RWEDGE_ENULL;
    if (f->loads == 0 || f->points > SIZE_MAX / sizeof(double) / f->loads)
        return RWEDGE_ERANGE;
    return rw_is_poisson(f->nu) && rw_field_in_domain(f) ? RWEDGE_OK : RWEDGE_EDOMAIN;
}

/* The power of two that brings the largest stress of a point's cycle to between 1/2 and 1; 1 where
 * all are 0. */
static inline double rw_field_scale(const rw_stress_field *f, size_t point)
{
    double largest = 0;
    int exponent = 0;
    for (size_t i = point; i < f->loads * f->points; i += f->points) {
        const double in_x = fabs(f->sxx[i]), in_y = fabs(f->syy[i]), across = fabs(f->txy[i]);
        const double direct = in_x > in_y ? in_x : in_y;
        largest = direct > largest ? direct : largest;
        largest = across > largest ? across : largest;
    }
    frexp(largest, &exponent);
    return ldexp(1, exponent);
}

#endif
