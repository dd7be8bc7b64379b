/* SPDX-License-Identifier: GPL-3.0-or-later */
/* On y = 0, with the slope g of the profile and the pressure -p, J2 = f^2 (g^2 + p^2) + kappa (p + f g)^2. Why one root on
 * 0 <= x <= alpha is the global maximum:
 * - it is not at x < 0, where g < 0 makes the second square smaller;
 * - it is not beyond alpha: g = 1 up to the edge, p falls, and outside p = 0 while g falls;
 * - on the rounding, x = alpha sin(psi), 0 <= psi <= pi/2, the derivative with respect to x is positive at 0 (for f > 0) and
 *   tends to minus infinity at alpha, where p has a vertical tangent. That it changes sign only once between is not proved
 *   here but checked, densely, by the tests (strength_survey), over all alpha, f and nu. */
#include "surface.h"

#include "domain.h"
#include "rwedge.h"
#include "solve.h"

typedef struct {
    double alpha, f, kappa;
    double c0, phi0;
} surface;

/* Pressure (as a positive number) and its slope -dp/du at u = x/alpha = sin(psi). From G' of the potential,
 * -dp/du = (2/pi) [ phi0 x/s + atanh(c0 u/s) ], s^2 - (c0 u)^2 = cos(psi)^2. */
static void pressure_at(const surface *c, double psi, double *p, double *falling)
{
    const double u = sin(psi), x = c->alpha * u, s = rw_cos_asin(x);
    *p = -rwedge_pressure(c->alpha, x);
    *falling = 2 / RW_PI * (c->phi0 * x / s + log((s + c->c0 * u) / cos(psi)));
}

/* (1/2) dJ2/du. */
static double slope_of_J2(double psi, const void *context)
{
    const surface *c = context;
    const double u = sin(psi), f = c->f;
    double p, falling;
    pressure_at(c, psi, &p, &falling);
    return f * f * (u - p * falling) + c->kappa * (p + f * u) * (f - falling);
}

static double J2_at(const surface *c, double psi)
{
    const double g = sin(psi), p = -rwedge_pressure(c->alpha, c->alpha * g);
    return c->f * c->f * (g * g + p * p) + c->kappa * (p + c->f * g) * (p + c->f * g);
}

/* Hertz: g^2 + p^2 = 1 on the whole contact, and p + f g is largest where tan(psi) = f. For kappa = 0 this is one point of a
 * plateau, the limit for kappa -> 0. */
static rw_maximum hertz(double f, double kappa)
{
    return (rw_maximum){.J2 = f * f + kappa * (1 + f * f), .x = f / sqrt(1 + f * f), .y = 0};
}

static double angle_of_maximum(const surface *c)
{
    if (c->f == 0)
        return 0; /* J2 = kappa p^2 */
    /* For kappa = 0 the slope is odd in psi: 0 is always a root, and a maximum if the slope falls there. */
    const double start = c->kappa > 0 ? 0 : 1e-9;
    const double end = RW_HALF_PI - 1e-9; /* at pi/2 the slope is infinite */
    if (slope_of_J2(start, c) <= 0)
        return 0;
    if (slope_of_J2(end, c) >= 0)
        return RW_HALF_PI; /* alpha so near 1 and f so large that the maximum is within 1e-18 of x = alpha */
    return rw_root(slope_of_J2, c, start, end, 1e-18);
}

rw_maximum rw_surface_maximum(double alpha, double f, double kappa)
{
    if (alpha >= 1)
        return hertz(f, kappa);
    const surface c = {.alpha = alpha, .f = f, .kappa = kappa, .c0 = rw_cos_asin(alpha), .phi0 = asin(alpha)};
    const double psi = angle_of_maximum(&c);
    return (rw_maximum){.J2 = J2_at(&c, psi), .x = alpha * sin(psi), .y = 0};
}
