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

void rw_set_loads(const rw_stress_field *f, size_t point, const rw_criterion *c, double unit,
                  rw_plane_cycle *cycle)
{
    for (size_t i = 0; i < f->loads; i++) {
        const size_t k = i * f->points + point;
        const double xx = f->sxx[k] / unit, yy = f->syy[k] / unit;
        const double s = (xx + yy) / 2, z = c->is_plane_stress ? 0 : 2 * f->nu * s;
        const rw_plane_load load = {s, (yy - xx) / 2, f->txy[k] / unit, z};
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
        r->value[j] = c->value(c, &plane, unit);
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

static double strain_energy(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    return (1 + c->nu) / c->E * unit * plane->value * unit;
}

static double strain(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    return 2 * (1 + c->nu) / c->E * unit * plane->value;
}

/* The normal strain of a plane is (1+nu)/E (n - nu/(1+nu) (sxx+syy+szz)), n its normal stress. */
bool rw_smith_watson_topper(double E, double nu, int32_t plane_stress, rw_criterion *c)
{
    const bool in_domain = is_switch(plane_stress) && rw_is_positive(E) && rw_is_poisson(nu);
    const double shift = !in_domain ? 0 : plane_stress != 0 ? -2 * nu / (1 + nu) : -2 * nu;
    *c = (rw_criterion){.severity = {.is_strain = true, .gain = 1, .shift = shift},
                        .is_plane_stress = plane_stress != 0,
                        .value = strain_energy,
                        .E = E,
                        .nu = nu};
    return in_domain;
}

bool rw_fatemi_socie(double E, double nu, int32_t plane_stress, double k_over_sy, rw_criterion *c)
{
    *c = (rw_criterion){.severity = {.offset = 1, .gain = k_over_sy},
                        .is_plane_stress = plane_stress != 0,
                        .value = strain,
                        .E = E,
                        .nu = nu};
    return is_switch(plane_stress) && rw_is_positive(E) && rw_is_magnitude(k_over_sy);
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

static double stress(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    (void)c;
    return plane->value * unit;
}

/* 0 where no stress changes. */
static double amplitude_and_ratio(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    if (!(plane->amplitude > 0))
        return 0;
    return plane->amplitude * unit + c->share * (plane->peak / plane->amplitude);
}

static double sum_of_ratios(const rw_criterion *c, const rw_worst_plane *plane, double unit)
{
    return plane->amplitude * (unit / c->limit) + plane->peak * (unit / (2 * c->share));
}

int32_t rwedge_findley_field(size_t loads, size_t n, const double sxx[], const double syy[],
                             const double txy[], double nu, double k, double value[],
                             double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const rw_criterion c = {.severity = {.is_sum = true, .gain = k}, .value = stress};
    return measured(&f, rw_is_magnitude(k), &c, &(results){value, angle, out_of_plane});
}

int32_t rwedge_modified_wohler_field(size_t loads, size_t n, const double sxx[], const double syy[],
                                     const double txy[], double nu, double kappa, double value[],
                                     double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const rw_criterion c = {
        .severity = {.is_sum = true, .gain = TIE}, .value = amplitude_and_ratio, .share = kappa};
    return measured(&f, rw_is_magnitude(kappa), &c, &(results){value, angle, out_of_plane});
}

int32_t rwedge_mcdiarmid_field(size_t loads, size_t n, const double sxx[], const double syy[],
                               const double txy[], double nu, double t_A, double su, double value[],
                               double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const rw_criterion c = {.severity = {.is_sum = true, .gain = TIE},
                            .value = sum_of_ratios,
                            .share = su,
                            .limit = t_A};
    return measured(&f, rw_is_positive(t_A) && rw_is_positive(su), &c,
                    &(results){value, angle, out_of_plane});
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
