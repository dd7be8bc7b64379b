/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/curvature.h"

#include "potential/closed_form.h"

#include <complex.h>

static double complex number(double re, double im)
{
    return re + im * I;
}

/* y/a. The division is one of real numbers, because complex division differs between compilers. */
static double complex y_over(double y, double complex a)
{
    return y / (creal(a) * creal(a) + cimag(a) * cimag(a)) * conj(a);
}

/* G''  =  (2/pi) [ c0/(X q) + (phi0/alpha)/X^3 ],   q = (z-alpha)(z+alpha),
 * G''' = -(2/pi) z [ c0/(X^3 q) + 2 c0/(X q^2) + 3 (phi0/alpha)/X^5 ],
 * They are written in y/X and y/(z -+ alpha), which neither under- nor overflow. Hertz: c0 = 0. */
static rw_curvature curvature_at(const rw_potential *p, rw_place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double complex per_X = y_over(1, number(e.sin_v * e.sinh_w, e.cos_v * e.cosh_w));
    const double complex y2_per_X2 = at.y * at.y * (per_X * per_X);
    const double complex y2_per_q =
        y_over(at.y, number(at.past, at.y)) * y_over(at.y, number(at.x + p->alpha, at.y));
    const double complex z_per_y = number(at.x / at.y, 1);
    const double complex corner = p->c0 * y2_per_q, edge = p->phi0_over_alpha * y2_per_X2;
    const double complex K = 2 / RW_PI * ((corner + edge) * per_X);
    const double complex steepness = corner * (y2_per_X2 + 2 * y2_per_q) + 3 * (edge * y2_per_X2);
    const double complex L = -2 / RW_PI * (steepness * z_per_y * per_X);
    return (rw_curvature){creal(K), cimag(K), creal(L), cimag(L)};
}

rw_field rw_potential_with_curvature(const rw_potential *potential, double x, double y,
                                     rw_curvature *curvature)
{
    const rw_place at = rw_place_of(potential, x, y);
    *curvature = curvature_at(potential, at);
    return potential->alpha < 1 ? rw_rounded_field(potential, at) : rw_hertz_field(potential, at);
}
