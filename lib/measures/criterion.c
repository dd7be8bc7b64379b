/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The criteria of a cycle of stresses by their numbers. */
#include "measures/field.h"

static int32_t stress_range(const rw_stress_field *f, double value[])
{
    const int32_t status = rw_field_status(f, value != NULL);
    for (size_t j = 0; j < f->points && status == RWEDGE_OK; j++) {
        double least = f->sxx[j], most = least;
        for (size_t i = j; i < f->loads * f->points; i += f->points) {
            least = fmin(least, f->sxx[i]);
            most = fmax(most, f->sxx[i]);
        }
        value[j] = most - least;
    }
    return status;
}

static int32_t without_plane(int32_t measure, const rw_stress_field *f, double constant,
                             double value[], double angle[], double out_of_plane[])
{
    int32_t status;
    if (!angle || !out_of_plane)
        return RWEDGE_ENULL;
    if (measure == RWEDGE_MEASURE_STRESS_RANGE)
        status = stress_range(f, value);
    else if (measure == RWEDGE_MEASURE_CROSSLAND)
        status = rwedge_crossland_field(f->loads, f->points, f->sxx, f->syy, f->txy, f->nu,
                                        constant, value);
    else
        status = rwedge_dang_van_field(f->loads, f->points, f->sxx, f->syy, f->txy, f->nu, constant,
                                       value);
    for (size_t j = 0; j < f->points && status == RWEDGE_OK; j++)
        angle[j] = out_of_plane[j] = 0;
    return status;
}

int32_t rwedge_criterion_field(int32_t measure, size_t loads, size_t n, const double sxx[],
                               const double syy[], const double txy[], double E, double nu,
                               int32_t plane_stress, double constant, double su, double value[],
                               double angle[], double out_of_plane[])
{
    if (!rw_is_positive(E) || !rw_is_poisson(nu) || plane_stress < 0 || plane_stress > 1 ||
        !rw_is_magnitude(constant) || !rw_is_positive(su))
        return RWEDGE_EDOMAIN;
    const double across = plane_stress ? 0 : nu;
    const rw_stress_field f = {loads, n, sxx, syy, txy, across};
    switch (measure) {
    case RWEDGE_MEASURE_SWT:
        return rwedge_smith_watson_topper_planes_field(loads, n, sxx, syy, txy, E, nu, plane_stress,
                                                       value, angle, out_of_plane);
    case RWEDGE_MEASURE_FATEMI_SOCIE:
        return rwedge_fatemi_socie_planes_field(loads, n, sxx, syy, txy, E, nu, plane_stress,
                                                constant, value, angle, out_of_plane);
    case RWEDGE_MEASURE_FINDLEY:
        return rwedge_findley_field(loads, n, sxx, syy, txy, across, constant, value, angle,
                                    out_of_plane);
    case RWEDGE_MEASURE_MODIFIED_WOHLER:
        return rwedge_modified_wohler_field(loads, n, sxx, syy, txy, across, constant, value, angle,
                                            out_of_plane);
    case RWEDGE_MEASURE_MCDIARMID:
        return rwedge_mcdiarmid_field(loads, n, sxx, syy, txy, across, constant, su, value, angle,
                                      out_of_plane);
    case RWEDGE_MEASURE_STRESS_RANGE:
    case RWEDGE_MEASURE_CROSSLAND:
    case RWEDGE_MEASURE_DANG_VAN:
        return without_plane(measure, &f, constant, value, angle, out_of_plane);
    default:
        return RWEDGE_EDOMAIN;
    }
}
