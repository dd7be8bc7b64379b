/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Criteria of the critical plane, over all planes. A cycle is searched with stresses in the unit of
 * its largest, rounded to a power of two, so that no product leaves the range of a double. */
#include "measures/planes.h"

/* The plane of the largest shear amplitude; among equal ones, that of the largest normal stress.
 * This part of the normal stress is added to the amplitude, to decide between amplitudes that
 * differ by rounding. */
static const double TIE = 1e-8;

typedef struct {
    double *value, *angle, *out_of_plane;
} results;

rw_severity rw_severity_in(const rw_criterion *c, double unit)
{
    rw_severity severity = c->severity;
    severity.gain *= severity.is_sum || severity.offset == 0 ? 1 : unit;
    return severity;
}

/* That of a strain is a product of two stresses. */
double rw_value_in(const rw_criterion *c, double unit)
{
    return c->per_value * (c->severity.is_strain ? unit * unit : unit);
}

static double value_of(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    const double sum = rw_value_in(c, unit) * plane->value +
                       unit * (c->per_amplitude * plane->amplitude + c->per_peak * plane->peak);
    return c->per_ratio > 0 && plane->amplitude > 0
               ? sum + c->per_ratio * (plane->peak / plane->amplitude)
               : sum;
}

void rw_set_loads(const rw_stress_field *f, size_t point, const rw_criterion *c, double unit,
                  rw_plane_cycle *cycle)
{
    for (size_t i = 0; i < f->loads; i++) {
        const size_t k = i * f->points + point;
        const double xx = f->sxx[k] / unit, yy = f->syy[k] / unit;
        const rw_plane_load load = {xx, yy, f->txy[k] / unit,
                                    c->is_plane_stress ? 0 : f->nu * (xx + yy)};
        rw_plane_cycle_set(cycle, i, &load, &c->severity);
    }
}

static int32_t search(const rw_stress_field *f, const rw_criterion *c, const results *r)
{
    rw_plane_cycle *cycle = rw_plane_cycle_create(f->loads);
    if (!cycle)
        return RWEDGE_ENOMEM;
    for (size_t j = 0; j < f->points; j++) {
        const double unit = rw_field_scale(f, j);
        const rw_severity severity = rw_severity_in(c, unit);
        rw_set_loads(f, j, c, unit, cycle);
        const rw_worst_plane plane = rw_worst_plane_of(cycle, &severity);
        r->value[j] = value_of(c, &plane, unit);
        r->angle[j] = plane.angle;
        r->out_of_plane[j] = plane.out_of_plane;
    }
    rw_plane_cycle_destroy(cycle);
    return RWEDGE_OK;
}

static int32_t measured(const rw_stress_field *f, bool in_domain, const rw_criterion *c,
                        const results *r)
{
    const int32_t status = rw_field_status(f, r->value && r->angle && r->out_of_plane);
    if (status != RWEDGE_OK)
        return status;
    return in_domain ? search(f, c, r) : RWEDGE_EDOMAIN;
}

/* ---- Smith, Watson and Topper; Fatemi and Socie ---- */

static bool is_switch(int32_t value)
{
    return value == 0 || value == 1;
}

/* The normal strain of a plane is (1+nu)/E (n - nu/(1+nu) (sxx+syy+szz)), n its normal stress. */
bool rw_smith_watson_topper(double E, double nu, int32_t plane_stress, rw_criterion *c)
{
    if (!is_switch(plane_stress) || !rw_is_positive(E) || !rw_is_poisson(nu))
        return false;
    const double shift = plane_stress != 0 ? -2 * nu / (1 + nu) : -2 * nu;
    *c = (rw_criterion){.severity = {.is_strain = true, .gain = 1, .shift = shift},
                        .is_plane_stress = plane_stress != 0,
                        .per_value = (1 + nu) / E};
    return true;
}

bool rw_fatemi_socie(double E, double nu, int32_t plane_stress, double k_over_sy, rw_criterion *c)
{
    if (!is_switch(plane_stress) || !rw_is_positive(E) || !rw_is_poisson(nu) ||
        !rw_is_magnitude(k_over_sy))
        return false;
    *c = (rw_criterion){.severity = {.offset = 1, .gain = k_over_sy},
                        .is_plane_stress = plane_stress != 0,
                        .per_value = 2 * (1 + nu) / E};
    return true;
}

int32_t rwedge_smith_watson_topper_planes_field(size_t loads, size_t n, const double sxx[],
                                                const double syy[], const double txy[], double E,
                                                double nu, int32_t plane_stress, double value[],
                                                double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    rw_criterion c;
    const bool in_domain = rw_smith_watson_topper(E, nu, plane_stress, &c);
    return measured(&f, in_domain, &c, &(results){value, angle, out_of_plane});
}

int32_t rwedge_fatemi_socie_planes_field(size_t loads, size_t n, const double sxx[],
                                         const double syy[], const double txy[], double E,
                                         double nu, int32_t plane_stress, double k_over_sy,
                                         double value[], double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    rw_criterion c;
    const bool in_domain = rw_fatemi_socie(E, nu, plane_stress, k_over_sy, &c);
    return measured(&f, in_domain, &c, &(results){value, angle, out_of_plane});
}

/* ---- Findley; Susmel; McDiarmid ---- */

int32_t rwedge_findley_field(size_t loads, size_t n, const double sxx[], const double syy[],
                             const double txy[], double nu, double k, double value[],
                             double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const rw_criterion c = {.severity = {.is_sum = true, .gain = k}, .per_value = 1};
    return measured(&f, rw_is_magnitude(k), &c, &(results){value, angle, out_of_plane});
}

int32_t rwedge_modified_wohler_field(size_t loads, size_t n, const double sxx[], const double syy[],
                                     const double txy[], double nu, double kappa, double value[],
                                     double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const rw_criterion c = {
        .severity = {.is_sum = true, .gain = TIE}, .per_amplitude = 1, .per_ratio = kappa};
    return measured(&f, rw_is_magnitude(kappa), &c, &(results){value, angle, out_of_plane});
}

int32_t rwedge_mcdiarmid_field(size_t loads, size_t n, const double sxx[], const double syy[],
                               const double txy[], double nu, double t_A, double su, double value[],
                               double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const bool in_domain = rw_is_positive(t_A) && rw_is_positive(su);
    const rw_criterion c = {.severity = {.is_sum = true, .gain = TIE},
                            .per_amplitude = in_domain ? 1 / t_A : 0,
                            .per_peak = in_domain ? 1 / (2 * su) : 0};
    return measured(&f, in_domain, &c, &(results){value, angle, out_of_plane});
}

/* ---- At one point ---- */

int32_t rwedge_smith_watson_topper_planes(size_t n, const double sxx[], const double syy[],
                                          const double txy[], double E, double nu,
                                          int32_t plane_stress, double *value, double *angle,
                                          double *out_of_plane)
{
    return rwedge_smith_watson_topper_planes_field(n, 1, sxx, syy, txy, E, nu, plane_stress, value,
                                                   angle, out_of_plane);
}

int32_t rwedge_fatemi_socie_planes(size_t n, const double sxx[], const double syy[],
                                   const double txy[], double E, double nu, int32_t plane_stress,
                                   double k_over_sy, double *value, double *angle,
                                   double *out_of_plane)
{
    return rwedge_fatemi_socie_planes_field(n, 1, sxx, syy, txy, E, nu, plane_stress, k_over_sy,
                                            value, angle, out_of_plane);
}

int32_t rwedge_findley(size_t n, const double sxx[], const double syy[], const double txy[],
                       double nu, double k, double *value, double *angle, double *out_of_plane)
{
    return rwedge_findley_field(n, 1, sxx, syy, txy, nu, k, value, angle, out_of_plane);
}

int32_t rwedge_modified_wohler(size_t n, const double sxx[], const double syy[], const double txy[],
                               double nu, double kappa, double *value, double *angle,
                               double *out_of_plane)
{
    return rwedge_modified_wohler_field(n, 1, sxx, syy, txy, nu, kappa, value, angle, out_of_plane);
}

int32_t rwedge_mcdiarmid(size_t n, const double sxx[], const double syy[], const double txy[],
                         double nu, double t_A, double su, double *value, double *angle,
                         double *out_of_plane)
{
    return rwedge_mcdiarmid_field(n, 1, sxx, syy, txy, nu, t_A, su, value, angle, out_of_plane);
}
