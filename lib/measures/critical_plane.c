/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fatigue parameters of cycles of stresses, on the critical plane. In plane strain, with the waves
 * of plane_search.h, the normal strain of a plane is (1+nu)/E ((1-2nu) s + n - s), and its shear
 * strain 2(1+nu)/E q. */
#include "base/domain.h"
#include "planes/plane_search.h"
#include "rwedge.h"

/* The stresses of `loads` loads at `points` points, load by load. */
typedef struct {
    size_t loads, points;
    const double *sxx, *syy, *txy;
    double E, nu;
} field;

static int32_t check(const field *f, const double value[], const double angle[])
{
    if (!f->sxx || !f->syy || !f->txy || !value || !angle)
        return RWEDGE_ENULL;
    if (f->loads == 0 || f->points > SIZE_MAX / sizeof(double) / f->loads)
        return RWEDGE_ERANGE;
    if (!rw_is_positive(f->E) || !rw_is_poisson(f->nu))
        return RWEDGE_EDOMAIN;
    for (size_t i = 0; i < f->loads * f->points; i++)
        if (!rw_is_stress(f->sxx[i]) || !rw_is_stress(f->syy[i]) || !rw_is_stress(f->txy[i]))
            return RWEDGE_EDOMAIN;
    return RWEDGE_OK;
}

/* Point by point, the largest product of the two waves, times `unit`. */
static void search(const field *f, rw_cycle waves, double unit, double value[], double angle[])
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
    const field f = {loads, n, sxx, syy, txy, E, nu};
    const int32_t status = check(&f, value, angle);
    if (status == RWEDGE_OK)
        search(&f, (rw_cycle){.gain = 1, .mean = 1 - 2 * nu, .normal = 1}, (1 + nu) / E / 2, value,
               angle);
    return status;
}

int32_t rwedge_fatemi_socie_field(size_t loads, size_t n, const double sxx[], const double syy[],
                                  const double txy[], double E, double nu, double k_over_sy,
                                  double value[], double angle[])
{
    const field f = {loads, n, sxx, syy, txy, E, nu};
    const int32_t status = check(&f, value, angle);
    if (status == RWEDGE_OK && !rw_is_magnitude(k_over_sy))
        return RWEDGE_EDOMAIN;
    if (status == RWEDGE_OK)
        search(&f, (rw_cycle){.offset = 1, .gain = k_over_sy, .shear = 1}, (1 + nu) / E, value,
               angle);
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
