/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "potential/potential.h"

#include "potential/closed_form.h"

void rw_potential_init(rw_potential *potential, double a, double c)
{
    const double alpha = a / c;
    potential->half_width = c;
    potential->per_half_width = 1 / c;
    potential->a = a;
    potential->alpha = alpha;
    potential->per_alpha = alpha == 0 ? 0 : 1 / alpha;
    potential->c0 = alpha < 1 ? sqrt((c - a) / c * (1 + alpha)) : 0;
    potential->phi0_over_alpha = alpha == 0 ? 1 : rw_angle(potential->c0, fmin(alpha, 1)) / alpha;
}

/* G = b_0 R, y G' = -y b_0 R/z. */
static rw_field remote_field(const rw_potential *p, rw_place at)
{
    const rw_ray ray = rw_ray_to(at.x, at.y);
    const double b0 = rw_first_coefficient(p);
    const double G_re = b0 * ray.R_re, G_im = b0 * ray.R_im;
    return (rw_field){G_re, G_im, -ray.sine * (G_re * ray.cosine + G_im * ray.sine),
                      -ray.sine * (G_im * ray.cosine - G_re * ray.sine)};
}

rw_field rw_potential_at(const rw_potential *potential, double x, double y)
{
    const rw_place at = rw_place_of(potential, x, y);
    if (rw_is_remote(at.x, at.y))
        return rw_mirrored(potential, x, y, remote_field(potential, at));
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    if (potential->alpha >= 1)
        return rw_mirrored(potential, x, y, rw_hertz_field(potential, at, e));
    return rw_mirrored(potential, x, y, rw_rounded_field(potential, at, e));
}

void rw_potential_far_coefficients(const rw_potential *potential, double far[RW_FAR_TERMS])
{
    const double alpha = potential->alpha, c0 = potential->c0;
    far[0] = rw_first_coefficient(potential);
    for (int n = 1; n < RW_FAR_TERMS; n++)
        far[n] = 0;
    if (alpha >= 1) /* Hertz: G = R/alpha */
        return;
    /* sin(m phi0)/alpha and cos(m phi0), m = 2n+1. The sine is divided by alpha. So alpha = 0 is
     * no special case. */
    double sine = 1, cosine = c0;
    const double cos2 = (1 - alpha) * (1 + alpha) - alpha * alpha;
    for (int n = 1; n < RW_FAR_TERMS; n++) {
        const double next = sine * cos2 + cosine * 2 * c0;
        cosine = cosine * cos2 - sine * alpha * (2 * c0 * alpha);
        sine = next;
        /* 4 (-1)^n/(pi m (m^2-1)) */
        const double weight = (n % 2 ? -1 : 1) / (RW_PI * (2 * n + 1) * n * (n + 1));
        far[n] = weight * ((2 * n + 1) * sine * c0 - cosine);
    }
}
