/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strength of the contact in full sliding: first yield and maximum tension. In natural units
 * the load is A P/(theta b), and yield begins when max sqrt(J2) = A k/theta. P/(bk) is the quotient
 * of the two. */
#include "rwedge.h"

#include "base/domain.h"
#include "base/root.h"
#include "formulas/size.h"
#include "strength/limit_load.h"
#include "strength/maxima.h"
#include "stress/von_mises.h"

/* From alpha = 1 on the load and the stresses both fall like 1/alpha. A quotient of the two is the
 * same as for alpha = 1. */
static double shape(double alpha)
{
    return fmin(alpha, 1);
}

double rwedge_max_tension(double alpha)
{
    if (!rw_is_magnitude(alpha))
        return NAN;
    /* At x = -b the profile's slope is -1, and sxx = 2 f. The "a" of Eq. (38) is the half-width of
     * the contact (E5). */
    return 2 / rwedge_load(shape(alpha));
}

double rwedge_max_tension_derivative(double alpha)
{
    if (!rw_is_magnitude(alpha))
        return NAN;
    const double load = rwedge_load(alpha);
    return alpha < 1 ? -2 * rwedge_load_derivative(alpha) / (load * load) : 0;
}

static bool is_case(double alpha, double f, double nu)
{
    return rw_is_tip(alpha) && rw_is_friction(f) && rw_is_poisson(nu);
}

static double limit_of(double alpha, rw_maximum maximum)
{
    return rwedge_load(shape(alpha)) / sqrt(maximum.J2);
}

/* The sharp wedge. The stresses are infinite at the apex, so the limit is 0. The exception is f = 0
 * with nu = 0.5. For this nu only the deviator counts; without friction it stays below 2/pi, and
 * tends to 2/pi on the axis. */
static double sharp_limit(double f, double nu)
{
    return f == 0 && nu == 0.5 ? RW_PI : 0;
}

static rw_maximum global_maximum(double alpha, double f, double nu)
{
    const double kappa = rw_plane_strain_weight(nu);
    const rw_maximum surface = rw_surface_maximum(shape(alpha), f, kappa);
    rw_maximum below;
    if (rw_subsurface_maximum(shape(alpha), f, kappa, &below) && below.J2 >= surface.J2)
        return below;
    return surface;
}

static void yield_point(double alpha, double f, double nu, double *limit, double *x, double *y)
{
    if (alpha == 0) {
        *limit = sharp_limit(f, nu);
        *x = *y = 0;
        return;
    }
    const rw_maximum maximum = global_maximum(alpha, f, nu);
    *limit = limit_of(alpha, maximum);
    *x = maximum.x;
    *y = maximum.y;
}

double rwedge_elastic_limit(double alpha, double f, double nu)
{
    if (!is_case(alpha, f, nu))
        return NAN;
    double limit, x, y;
    yield_point(alpha, f, nu, &limit, &x, &y);
    return limit;
}

int32_t rwedge_elastic_limits(size_t n, const double alpha[], const double f[], double nu,
                              double limit[])
{
    if (n > 0 && (!alpha || !f || !limit))
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu))
        return RWEDGE_EDOMAIN;
    for (size_t i = 0; i < n; i++)
        if (!is_case(alpha[i], f[i], nu))
            return RWEDGE_EDOMAIN;
    for (size_t i = 0; i < n; i++)
        limit[i] = rwedge_elastic_limit(alpha[i], f[i], nu);
    return RWEDGE_OK;
}

int32_t rwedge_yield_point(double alpha, double f, double nu, double *limit, double *x, double *y)
{
    if (!limit || !x || !y)
        return RWEDGE_ENULL;
    if (!is_case(alpha, f, nu))
        return RWEDGE_EDOMAIN;
    yield_point(alpha, f, nu, limit, x, y);
    return RWEDGE_OK;
}

int32_t rwedge_subsurface_yield(double alpha, double f, double nu, double *limit, double *x,
                                double *y)
{
    if (!limit || !x || !y)
        return RWEDGE_ENULL;
    if (!is_case(alpha, f, nu))
        return RWEDGE_EDOMAIN;
    rw_maximum below;
    if (alpha == 0 || !rw_subsurface_maximum(shape(alpha), f, rw_plane_strain_weight(nu), &below))
        return RWEDGE_EABSENT;
    *limit = limit_of(alpha, below);
    *x = below.x;
    *y = below.y;
    return RWEDGE_OK;
}

int32_t rwedge_surface_yield(double alpha, double f, double nu, double *limit, double *x)
{
    if (!limit || !x)
        return RWEDGE_ENULL;
    if (!is_case(alpha, f, nu))
        return RWEDGE_EDOMAIN;
    if (f == 0 && nu == 0.5)
        return RWEDGE_EABSENT;
    const rw_maximum surface = alpha > 0
                                   ? rw_surface_maximum(shape(alpha), f, rw_plane_strain_weight(nu))
                                   : (rw_maximum){.J2 = HUGE_VAL, .x = 0, .y = 0};
    *limit = limit_of(alpha, surface);
    *x = surface.x;
    return RWEDGE_OK;
}

/* At a maximum J2 is stationary in the place, which may therefore move with alpha. The logarithm of
 * the limit is that of the load less half of that of J2. */
int32_t rwedge_elastic_limit_gradient(double alpha, double f, double nu, double *d_alpha,
                                      double *d_f, double *d_nu, double *at_surface)
{
    if (!d_alpha || !d_f || !d_nu || !at_surface)
        return RWEDGE_ENULL;
    if (!is_case(alpha, f, nu) || alpha == 0)
        return RWEDGE_EDOMAIN;
    const rw_maximum maximum = global_maximum(alpha, f, nu);
    rw_potential potential;
    rw_potential_init(&potential, shape(alpha), 1);
    const rw_von_mises_change change =
        rw_von_mises_change_at(&potential, f, rw_plane_strain_weight(nu), maximum.x, maximum.y);
    const double limit = limit_of(alpha, maximum), per_2J2 = 1 / (2 * change.J2);
    const double by_load = alpha < 1 ? rwedge_load_derivative(alpha) / rwedge_load(alpha) : 0,
                 by_J2 = alpha < 1 ? per_2J2 * change.rounding / alpha : 0;
    *d_alpha = limit * (by_load - by_J2);
    *d_f = f > 0 ? -limit * per_2J2 * change.f : 0; /* J2 is even in f */
    *d_nu = limit * per_2J2 * change.kappa * (4 * (1 - 2 * nu) / 3);
    *at_surface = maximum.y == 0;
    return RWEDGE_OK;
}

typedef struct {
    double alpha, kappa;
} pair;

/* How far the subsurface maximum exceeds that of the surface, relatively. -1 where there is no
 * subsurface maximum; its branch ends only after the surface has become higher. */
static double excess_below(double f, const void *context)
{
    const pair *p = context;
    rw_maximum below;
    if (!rw_subsurface_maximum(p->alpha, f, p->kappa, &below))
        return -1;
    return 1 - rw_surface_maximum(p->alpha, f, p->kappa).J2 / below.J2;
}

double rwedge_critical_friction(double alpha, double nu)
{
    /* at f = 1 no subsurface maximum is left, for any alpha and nu */
    static const double LARGEST = 1;
    if (!rw_is_tip(alpha) || !rw_is_poisson(nu))
        return NAN;
    const pair p = {shape(alpha), rw_plane_strain_weight(nu)};
    if (alpha == 0 || excess_below(0, &p) <= 0)
        return 0;
    return rw_root(excess_below, &p, 0, LARGEST, 1e-18);
}

/* ---- The load at which a contact with units first yields ---- */

/* The peak of sqrt(J2) in theta/A, from the elastic limit P/(bk): P = (theta/A) b load(alpha). */
static double peak(double alpha, double f, double nu)
{
    return rwedge_load(alpha) / rwedge_elastic_limit(alpha, f, nu);
}

double rwedge_yield_load(double theta, double a, double A, double f, double nu, double k)
{
    static const rw_limit yield = {peak, RW_SMALLEST_TIP, 1e-17};
    return rw_limit_load(&yield, theta, a, A, f, nu, k);
}
