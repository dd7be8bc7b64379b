/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fatigue parameters of cycles of stresses, on the critical plane. In plane strain, with the waves
 * of plane_search.h, the normal strain of a plane is (1+nu)/E ((1-2nu) s + n - s), and its shear
 * strain 2(1+nu)/E q. */
#include "rwedge.h"

#include "domain.h"
#include "plane_search.h"
#include "scaled.h"

/* The stresses of `loads` loads at `points` points, load by load. */
typedef struct {
    size_t loads, points;
    const double *sxx, *syy, *txy;
    double E, nu, k_over_sy;
} field;

static const double MOST = 1e300;

static int32_t check(const field *f, const double value[], const double angle[])
{
    if (!f->sxx || !f->syy || !f->txy || !value || !angle)
        return RWEDGE_ENULL;
    if (f->loads == 0 || f->points > SIZE_MAX / sizeof(double) / f->loads)
        return RWEDGE_ERANGE;
    if (!isfinite(f->E) || f->E <= 0 || !rw_is_poisson(f->nu) || !rw_is_nonnegative(f->k_over_sy))
        return RWEDGE_EDOMAIN;
    for (size_t i = 0; i < f->loads * f->points; i++)
        if (!isfinite(f->sxx[i]) || !isfinite(f->syy[i]) || !isfinite(f->txy[i]))
            return RWEDGE_EDOMAIN;
    return RWEDGE_OK;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* The largest magnitude among `count` stresses, one every `stride`. */
static double largest(const field *f, size_t first, size_t count, size_t stride)
{
    double most = 0;
    for (size_t i = first; count > 0; count--, i += stride)
        most = larger(larger(larger(most, fabs(f->sxx[i])), fabs(f->syy[i])), fabs(f->txy[i]));
    return most;
}

static bool is_in_range(rw_scaled v)
{
    const double value = rw_scaled_value(v);
    return !isnan(value) && value <= MOST;
}

/* At one point: how its stresses are scaled, and what a product of scaled waves is worth. */
typedef struct {
    rw_cycle cycle;
    int exponent; /* stresses are times 2^-exponent */
} point;

static point point_of(const field *f, size_t i)
{
    const double most = largest(f, i, f->loads, f->points);
    const int exponent = most > 0 ? rw_magnitude(most) : 0;
    return (point){{.loads = f->loads,
                    .stride = f->points,
                    .sxx = f->sxx + i,
                    .syy = f->syy + i,
                    .txy = f->txy + i,
                    .scale = rw_power_of_two(-exponent)},
                   exponent};
}

/* product (1+nu)/E 2^exponent */
static double strain_times(const field *f, double product, int exponent)
{
    rw_scaled v = rw_scaled_over(rw_scaled_from(product * (1 + f->nu)), rw_scaled_from(f->E));
    v.exponent += exponent;
    return rw_scaled_value(v);
}

static double smith_watson_topper(const field *f, size_t i, double *angle)
{
    point p = point_of(f, i);
    p.cycle.gain = 1;
    p.cycle.mean = 1 - 2 * f->nu;
    p.cycle.normal = 1;
    return strain_times(f, rw_plane_search(&p.cycle, angle) / 2, 2 * p.exponent);
}

/* The factor 1 + k n/sy is searched for over 1 + k/sy times the unit of stress, so that no number
 * is large. */
static double fatemi_socie(const field *f, size_t i, double *angle)
{
    point p = point_of(f, i);
    rw_scaled weight = rw_scaled_from(f->k_over_sy);
    weight.exponent += p.exponent;
    const double k = rw_scaled_value(weight);
    p.cycle.offset = 1 / (1 + k);
    p.cycle.gain = k / (1 + k);
    p.cycle.shear = 1;
    return strain_times(f, rw_plane_search(&p.cycle, angle) * (1 + k), p.exponent);
}

int32_t rwedge_smith_watson_topper_field(size_t loads, size_t n, const double sxx[],
                                         const double syy[], const double txy[], double E,
                                         double nu, double value[], double angle[])
{
    const field f = {loads, n, sxx, syy, txy, E, nu, 0};
    const int32_t status = check(&f, value, angle);
    if (status != RWEDGE_OK)
        return status;
    const rw_scaled most = rw_scaled_from(largest(&f, 0, loads * n, 1));
    if (!is_in_range(rw_scaled_over(rw_scaled_times(most, most), rw_scaled_from(E))))
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++)
        value[i] = smith_watson_topper(&f, i, &angle[i]);
    return RWEDGE_OK;
}

int32_t rwedge_smith_watson_topper(size_t n, const double sxx[], const double syy[],
                                   const double txy[], double E, double nu, double *value,
                                   double *angle)
{
    return rwedge_smith_watson_topper_field(n, 1, sxx, syy, txy, E, nu, value, angle);
}

int32_t rwedge_fatemi_socie_field(size_t loads, size_t n, const double sxx[], const double syy[],
                                  const double txy[], double E, double nu, double k_over_sy,
                                  double value[], double angle[])
{
    const field f = {loads, n, sxx, syy, txy, E, nu, k_over_sy};
    const int32_t status = check(&f, value, angle);
    if (status != RWEDGE_OK)
        return status;
    const rw_scaled most = rw_scaled_from(largest(&f, 0, loads * n, 1));
    const rw_scaled weight = rw_scaled_times(most, rw_scaled_from(k_over_sy));
    if (!is_in_range(weight))
        return RWEDGE_ERANGE;
    const rw_scaled factor = rw_scaled_from(1 + rw_scaled_value(weight));
    if (!is_in_range(rw_scaled_over(rw_scaled_times(factor, most), rw_scaled_from(E))))
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++)
        value[i] = fatemi_socie(&f, i, &angle[i]);
    return RWEDGE_OK;
}

int32_t rwedge_fatemi_socie(size_t n, const double sxx[], const double syy[], const double txy[],
                            double E, double nu, double k_over_sy, double *value, double *angle)
{
    return rwedge_fatemi_socie_field(n, 1, sxx, syy, txy, E, nu, k_over_sy, value, angle);
}
