/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the smallest sphere around the path of the stress deviator. In plane strain the
 * deviator has three components, (d, txy, (1-2nu)/sqrt(3) s), whose length is sqrt(J2). */
#include "measures/mesoscopic.h"

#include "planes/smallest_ball.h"

#include <stdlib.h>

static double hydrostatic(const rw_stress_field *f, size_t k)
{
    return (1 + f->across) * (f->sxx[k] + f->syy[k]) / 3;
}

static rw_point deviator(const rw_stress_field *f, size_t k, double unit)
{
    const double s = (f->sxx[k] + f->syy[k]) / 2, d = (f->syy[k] - f->sxx[k]) / 2;
    return (rw_point){{d / unit, f->txy[k] / unit, (1 - 2 * f->across) / sqrt(3) * (s / unit)}};
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

static int32_t measured(const rw_stress_field *f, criterion *at, double alpha,
                        const rw_criterion_results *results)
{
    rw_point *path = calloc(f->loads, sizeof *path);
    if (!path)
        return RWEDGE_ENOMEM;
    for (size_t j = 0; j < f->points; j++) {
        const double unit = rw_field_scale(f, j);
        for (size_t i = 0; i < f->loads; i++)
            path[i] = deviator(f, i * f->points + j, unit);
        const rw_ball ball = rw_smallest_ball(f->loads, path);
        results->value[j] = at(f, j, &ball, unit, alpha);
        results->angle[j] = results->out_of_plane[j] = 0;
    }
    free(path);
    return RWEDGE_OK;
}

int32_t rw_crossland(const rw_stress_field *f, const double constants[],
                     const rw_criterion_results *results)
{
    return measured(f, crossland, constants[0], results);
}

int32_t rw_dang_van(const rw_stress_field *f, const double constants[],
                    const rw_criterion_results *results)
{
    return measured(f, dang_van, constants[0], results);
}
