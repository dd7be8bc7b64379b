/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fatigue parameters of cycles of stresses, on the critical plane. In plane strain, with the waves
 * of plane_search.h, the normal strain of a plane is (1+nu)/E ((1-2nu) s + n - s), and its shear
 * strain 2(1+nu)/E q. */
#include "measures/field.h"
#include "planes/plane_search.h"

static int32_t check(const rw_stress_field *f, double E, const double value[], const double angle[])
{
    const int32_t status = rw_field_status(f, value && angle);
    return status == RWEDGE_OK && !rw_is_positive(E) ? RWEDGE_EDOMAIN : status;
}

/* Point by point, the largest product of the two waves, times `unit`. */
static void search(const rw_stress_field *f, rw_stress_cycle waves, double unit, double value[],
                   double angle[])
{
    waves.loads = f->loads;
    waves.stride = f->points;
    for (size_t i = 0; i < f->points; i++) {
        waves.sxx = f->sxx + i;
        waves.syy = f->syy + i;
        waves.txy = f->txy + i;
        rw_direction phi;
        value[i] = unit * rw_plane_search(&waves, &phi);
        angle[i] = rw_plane_angle(phi.cosine, phi.sine);
    }
}

int32_t rwedge_smith_watson_topper_field(size_t loads, size_t n, const double sxx[],
                                         const double syy[], const double txy[], double E,
                                         double nu, double value[], double angle[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const int32_t status = check(&f, E, value, angle);
    if (status == RWEDGE_OK)
        search(&f, (rw_stress_cycle){.gain = 1, .mean = 1 - 2 * nu, .normal = 1}, (1 + nu) / E / 2,
               value, angle);
    return status;
}

int32_t rwedge_fatemi_socie_field(size_t loads, size_t n, const double sxx[], const double syy[],
                                  const double txy[], double E, double nu, double k_over_sy,
                                  double value[], double angle[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    const int32_t status = check(&f, E, value, angle);
    if (status == RWEDGE_OK && !rw_is_magnitude(k_over_sy))
        return RWEDGE_EDOMAIN;
    if (status == RWEDGE_OK)
        search(&f, (rw_stress_cycle){.offset = 1, .gain = k_over_sy, .shear = 1}, (1 + nu) / E,
               value, angle);
    return status;
}

int32_t rwedge_smith_watson_topper(size_t n, const double sxx[], const double syy[],
                                   const double txy[], double E, double nu, double *value,
                                   double *angle)
{
    return rwedge_smith_watson_topper_field(n, 1, sxx, syy, txy, E, nu, value, angle);
}

int32_t rwedge_fatemi_socie(size_t n, const double sxx[], const double syy[], const double txy[],
                            double E, double nu, double k_over_sy, double *value, double *angle)
{
    return rwedge_fatemi_socie_field(n, 1, sxx, syy, txy, E, nu, k_over_sy, value, angle);
}
