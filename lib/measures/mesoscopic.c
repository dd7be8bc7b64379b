/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the smallest sphere around the path of the stress deviator. In plane strain the
 * deviator has three components, (d, txy, (1-2nu)/sqrt(3) s), whose length is sqrt(J2). */
#include "measures/field.h"
#include "planes/smallest_ball.h"

#include <stdlib.h>

static double hydrostatic(const rw_stress_field *f, size_t k)
{
    return (1 + f->nu) * (f->sxx[k] + f->syy[k]) / 3;
}

static rw_point deviator(const rw_stress_field *f, size_t k, double unit)
{
    const double s = (f->sxx[k] + f->syy[k]) / 2, d = (f->syy[k] - f->sxx[k]) / 2;
    return (rw_point){{d / unit, f->txy[k] / unit, (1 - 2 * f->nu) / sqrt(3) * (s / unit)}};
}

/* The largest shear stress of a deviator: half of the difference of its outermost principal
 * stresses. */
static double tresca(const rw_point *p, const rw_point *centre)
{
    const double d = p->x[0] - centre->x[0], t = p->x[1] - centre->x[1];
    const double in_plane = sqrt(d * d + t * t), off = sqrt(3) * fabs(p->x[2] - centre->x[2]);
    return fmax(in_plane, (in_plane + off) / 2);
}

static double crossland(const rw_stress_field *f, size_t point, const rw_ball *ball, double unit,
                        double alpha)
{
    double highest = -HUGE_VAL;
    for (size_t i = point; i < f->loads * f->points; i += f->points)
        highest = fmax(highest, hydrostatic(f, i));
    return ball->radius * unit + alpha * highest;
}

static double dang_van(const rw_stress_field *f, size_t point, const rw_ball *ball, double unit,
                       double alpha)
{
    double highest = -HUGE_VAL;
    for (size_t i = point; i < f->loads * f->points; i += f->points) {
        const rw_point p = deviator(f, i, unit);
        highest = fmax(highest, tresca(&p, &ball->centre) * unit + alpha * hydrostatic(f, i));
    }
    return highest;
}

/* The criterion at a point of the field, from the ball around its path in the unit. */
typedef double criterion(const rw_stress_field *f, size_t point, const rw_ball *ball, double unit,
                         double alpha);

static int32_t measured(const rw_stress_field *f, criterion *at, double alpha, double value[])
{
    const int32_t status = rw_field_status(f, value != NULL);
    if (status != RWEDGE_OK)
        return status;
    if (!rw_is_magnitude(alpha))
        return RWEDGE_EDOMAIN;
    rw_point *path = calloc(f->loads, sizeof *path);
    if (!path)
        return RWEDGE_ENOMEM;
    for (size_t j = 0; j < f->points; j++) {
        const double unit = rw_field_scale(f, j);
        for (size_t i = 0; i < f->loads; i++)
            path[i] = deviator(f, i * f->points + j, unit);
        const rw_ball ball = rw_smallest_ball(f->loads, path);
        value[j] = at(f, j, &ball, unit, alpha);
    }
    free(path);
    return RWEDGE_OK;
}

int32_t rwedge_crossland_field(size_t loads, size_t n, const double sxx[], const double syy[],
                               const double txy[], double nu, double alpha, double value[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    return measured(&f, crossland, alpha, value);
}

int32_t rwedge_dang_van_field(size_t loads, size_t n, const double sxx[], const double syy[],
                              const double txy[], double nu, double alpha, double value[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    return measured(&f, dang_van, alpha, value);
}

int32_t rwedge_crossland(size_t n, const double sxx[], const double syy[], const double txy[],
                         double nu, double alpha, double *value)
{
    return rwedge_crossland_field(n, 1, sxx, syy, txy, nu, alpha, value);
}

int32_t rwedge_dang_van(size_t n, const double sxx[], const double syy[], const double txy[],
                        double nu, double alpha, double *value)
{
    return rwedge_dang_van_field(n, 1, sxx, syy, txy, nu, alpha, value);
}
