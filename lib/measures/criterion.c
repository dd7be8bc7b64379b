/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The criteria of a cycle of stresses by their numbers. */
#include "measures/criterion.h"

#include "measures/catalogue.h"

int32_t rw_stress_range(const rw_stress_field *f, const double constants[],
                        const rw_criterion_results *results)
{
    (void)constants;
    for (size_t j = 0; j < f->points; j++) {
        double least = f->sxx[j], most = least;
        for (size_t i = j; i < f->loads * f->points; i += f->points) {
            least = fmin(least, f->sxx[i]);
            most = fmax(most, f->sxx[i]);
        }
        results->value[j] = most - least;
        results->angle[j] = results->out_of_plane[j] = 0;
    }
    return RWEDGE_OK;
}

/* ---- By number ---- */

static bool is_of_stress(const rw_measure *measure)
{
    return measure && (measure->of_planes || measure->of_field);
}

bool rw_has_constants(int32_t criterion, const double constants[])
{
    const rw_measure *measure = rw_measure_of(criterion);
    return is_of_stress(measure) && rw_are_constants(measure, measure->own, constants);
}

bool rw_counts_mean(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure && measure->counts_mean;
}

int32_t rwedge_criterion_field(int32_t criterion, const double constants[], size_t loads, size_t n,
                               const double sxx[], const double syy[], const double txy[],
                               double nu, int32_t plane_stress, double value[], double angle[],
                               double out_of_plane[])
{
    const rw_stress_field f = rw_stress_field_of(loads, n, sxx, syy, txy, nu, plane_stress);
    const rw_criterion_results results = {value, angle, out_of_plane};
    const rw_measure *measure = rw_measure_of(criterion);
    const bool has_constants = constants || (measure && measure->own == 0);
    const int32_t status = rw_field_status(&f, has_constants && value && angle && out_of_plane);
    if (status != RWEDGE_OK)
        return status;
    if (!rw_is_switch(plane_stress) || !rw_has_constants(criterion, constants))
        return RWEDGE_EDOMAIN;
    if (measure->of_field)
        return measure->of_field(&f, constants, &results);
    const rw_criterion of_planes = measure->of_planes(&f, constants);
    return rw_search_planes(&f, &of_planes, &results);
}

int32_t rwedge_criterion(int32_t criterion, const double constants[], size_t n, const double sxx[],
                         const double syy[], const double txy[], double nu, int32_t plane_stress,
                         double *value, double *angle, double *out_of_plane)
{
    return rwedge_criterion_field(criterion, constants, n, 1, sxx, syy, txy, nu, plane_stress,
                                  value, angle, out_of_plane);
}
