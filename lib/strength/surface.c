/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maximum of J2 on y = 0. With the slope g of the profile and the pressure -p,
 *     J2 = f^2 (g^2 + p^2) + kappa (p + f g)^2.
 * Why one root on 0 <= x <= alpha is the global maximum:
 * - It is not at x < 0, where g < 0 makes the second square smaller.
 * - It is not beyond alpha: up to the edge g = 1 and p falls; outside p = 0 and g falls.
 * - On the rounding, x = alpha sin(psi), 0 <= psi <= pi/2. There the derivative with respect to x
 *   is positive at 0 (for f > 0). It tends to minus infinity at alpha, where p has a vertical
 *   tangent. So it has a root between.
 * It has only one root between. This is not proved here. The test yield_survey checks it
 * densely over all alpha, f and nu. At many of them tests/proof/certificate proves that the result
 * is the global maximum. */
#include "strength/maxima.h"

#include "base/domain.h"
#include "base/logarithm.h"
#include "formulas/pressure.h"
#include "base/root.h"

typedef struct {
    double alpha, f, kappa;
    double c0, phi0;
} surface;

/* A place x = alpha sin(psi) on the rounding. It is given by t = tan(psi/2), so that no sine needs
 * to be evaluated. */
typedef struct {
    double u, cosine; /* sin(psi), cos(psi) */
} rounding_point;

static rounding_point place_of(double t)
{
    return (rounding_point){2 * t / (1 + t * t), (1 - t) * (1 + t) / (1 + t * t)};
}

static double pressure_at(const surface *c, double u)
{
    return -rw_patch_pressure(c->alpha, 1, c->alpha * u);
}

/* -dp/du. From G' of the potential it is (2/pi) [ phi0 x/s + atanh(c0 u/s) ], s = sqrt(1-x^2). As
 * s^2 - (c0 u)^2 = cos(psi)^2, the atanh is the logarithm of (s + c0 u)/cos(psi). */
static double fall_of_pressure(const surface *c, rounding_point at)
{
    const double x = c->alpha * at.u, s = rw_cos_asin(x), c0_u = c->c0 * at.u;
    const double difference = c0_u + c0_u * c0_u / (s + at.cosine);
    return 2 / RW_PI *
           (c->phi0 * x / s + rw_log_of_quotient_over(s + c0_u, at.cosine, difference, 1, 1));
}

/* (1/2) dJ2/du. */
static double slope_of_J2(double t, const void *context)
{
    const surface *c = context;
    const rounding_point at = place_of(t);
    const double p = pressure_at(c, at.u), falling = fall_of_pressure(c, at), f = c->f;
    return f * f * (at.u - p * falling) + c->kappa * (p + f * at.u) * (f - falling);
}

static double J2_at(const surface *c, double g)
{
    const double p = pressure_at(c, g);
    return c->f * c->f * (g * g + p * p) + c->kappa * (p + c->f * g) * (p + c->f * g);
}

/* Hertz: g^2 + p^2 = 1 on the whole contact, and p + f g is largest where tan(psi) = f. For
 * kappa = 0, J2 is the same on the whole contact; this point is the limit for kappa -> 0. */
static rw_maximum hertz(double f, double kappa)
{
    return (rw_maximum){.J2 = f * f + kappa * (1 + f * f), .x = f / sqrt(1 + f * f), .y = 0};
}

/* tan(psi/2) at the maximum. */
static double place_of_maximum(const surface *c)
{
    if (c->f == 0)
        return 0; /* J2 = kappa p^2 */
    /* Where kappa is 0 the slope is odd in psi, so 0 is always a root. It is the maximum if the
     * slope falls there. */
    const double start = c->kappa > 0 ? 0 : 5e-10;
    const double end = 1 - 1e-9; /* at 1 the slope is infinite */
    if (slope_of_J2(start, c) <= 0)
        return 0;
    if (slope_of_J2(end, c) >= 0)
        return 1; /* alpha near 1 and a large f: the maximum is within 1e-18 of x = alpha */
    return rw_root(slope_of_J2, c, start, end, 1e-18);
}

rw_maximum rw_surface_maximum(double alpha, double f, double kappa)
{
    if (alpha >= 1)
        return hertz(f, kappa);
    const double c0 = rw_cos_asin(alpha);
    const surface c = {
        .alpha = alpha, .f = f, .kappa = kappa, .c0 = c0, .phi0 = rw_angle(c0, alpha)};
    const double u = place_of(place_of_maximum(&c)).u;
    return (rw_maximum){.J2 = J2_at(&c, u), .x = alpha * u, .y = 0};
}
