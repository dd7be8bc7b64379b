/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the critical plane, over all planes. A cycle is searched with stresses in the unit of
 * its largest, rounded to a power of two, so that no product leaves the range of a double. */
#include "measures/planes.h"

/* The plane of the largest shear amplitude; among equal ones, that of the largest normal stress.
 * This part of the normal stress is added to the amplitude, to decide between amplitudes that
 * differ by rounding. */
static const double TIE = 1e-8;

/* No stress changes but by rounding where the amplitude is below this part of the largest
 * stress. */
static const double NO_CHANGE = 1e-12;

rw_severity rw_severity_in(const rw_criterion *c, double unit)
{
    rw_severity severity = c->severity;
    severity.gain *= severity.is_sum || severity.offset == 0 ? 1 : unit;
    return severity;
}

/* The value of a criterion of strains is a product of two stresses. */
double rw_value_in(const rw_criterion *c, double unit)
{
    return c->per_value * (c->severity.is_strain ? unit * unit : unit);
}

static double value_of(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    const double sum = rw_value_in(c, unit) * plane->value +
                       unit * (c->per_amplitude * plane->amplitude + c->per_peak * plane->peak);
    if (!c->has_ratio)
        return sum;
    if (plane->amplitude < NO_CHANGE)
        return 0;
    return sum + fmin(c->per_ratio * (plane->peak / plane->amplitude), c->most_by_ratio);
}

void rw_set_loads(const rw_stress_field *f, size_t point, const rw_criterion *c, double unit,
                  rw_plane_cycle *cycle)
{
    for (size_t i = 0; i < f->loads; i++) {
        const size_t k = i * f->points + point;
        const double xx = f->sxx[k] / unit, yy = f->syy[k] / unit;
        const rw_plane_load load = {xx, yy, f->txy[k] / unit, f->across * (xx + yy)};
        rw_plane_cycle_set(cycle, i, &load, &c->severity);
    }
}

int32_t rw_search_planes(const rw_stress_field *f, const rw_criterion *c,
                         const rw_criterion_results *results)
{
    rw_plane_cycle *cycle = rw_plane_cycle_create(f->loads);
    if (!cycle)
        return RWEDGE_ENOMEM;
    for (size_t j = 0; j < f->points; j++) {
        const double unit = rw_field_scale(f, j);
        const rw_severity severity = rw_severity_in(c, unit);
        rw_set_loads(f, j, c, unit, cycle);
        const rw_worst_plane plane = rw_worst_plane_of(cycle, &severity);
        results->value[j] = value_of(c, &plane, unit);
        results->angle[j] = plane.angle;
        results->out_of_plane[j] = plane.out_of_plane;
    }
    rw_plane_cycle_destroy(cycle);
    return RWEDGE_OK;
}

/* ---- The criteria ---- */

/* The normal strain of a plane is (1+nu)/E (n - nu/(1+nu) (sxx+syy+szz)), n its normal stress. */
rw_criterion rw_smith_watson_topper(const rw_stress_field *f, const double constants[])
{
    const double nu = f->nu, shift = f->is_plane_stress ? -2 * nu / (1 + nu) : -2 * nu;
    return (rw_criterion){.severity = {.is_strain = true, .gain = 1, .shift = shift},
                          .per_value = (1 + nu) / constants[0]};
}

rw_criterion rw_fatemi_socie(const rw_stress_field *f, const double constants[])
{
    return (rw_criterion){.severity = {.offset = 1, .gain = constants[1] / constants[2]},
                          .per_value = 2 * (1 + f->nu) / constants[0]};
}

rw_criterion rw_findley(const rw_stress_field *f, const double constants[])
{
    (void)f;
    return (rw_criterion){.severity = {.is_sum = true, .gain = constants[0]}, .per_value = 1};
}

/* kappa rho_lim is lambda/2 where no other rho_lim is given. */
rw_criterion rw_modified_wohler(const rw_stress_field *f, const double constants[])
{
    (void)f;
    const double kappa = constants[0], lambda = constants[1], rho_lim = constants[2];
    return (rw_criterion){.severity = {.is_sum = true, .gain = TIE},
                          .per_amplitude = 1,
                          .has_ratio = true,
                          .per_ratio = kappa,
                          .most_by_ratio = rho_lim > 0 ? kappa * rho_lim : lambda / 2};
}

rw_criterion rw_mcdiarmid(const rw_stress_field *f, const double constants[])
{
    (void)f;
    return (rw_criterion){.severity = {.is_sum = true, .gain = TIE},
                          .per_amplitude = 1 / constants[0],
                          .per_peak = 1 / (2 * constants[1])};
}
