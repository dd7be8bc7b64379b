/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "stress/von_mises.h"

double rw_plane_strain_weight(double nu)
{
    return (1 - 2 * nu) * (1 - 2 * nu) / 3;
}

static double dot(double complex a, double complex b)
{
    return creal(a) * creal(b) + cimag(a) * cimag(b);
}

/* i a, without the general product of complex numbers. */
static double complex turned(double complex a)
{
    return rw_number(-cimag(a), creal(a));
}

/* With G_N = G and G_T = f G,  D = f G + mu H,  s = Re(sigma G),  mu = -1 + i f,  sigma = -f -
 * i,  H = y G'. The potentials are analytic, so d/dy of them is i d/dx; the factor y of H adds its
 * own part. Each derivative is multiplied by a power of y, so that it is of the order of J2
 * everywhere: at the surface, and at the apex of the smallest tip. */
rw_von_mises rw_von_mises_at(const rw_potential *potential, double f, double kappa, double x,
                             double y)
{
    rw_curvature bend;
    const rw_field field = rw_potential_with_curvature(potential, x, y, &bend);
    const double complex G = rw_number(field.G_re, field.G_im),
                         H = rw_number(field.H_re, field.H_im);
    const double complex K = bend.K, L = bend.L;
    const double complex mu = rw_number(-1, f), sigma = rw_number(-f, -1);

    const double complex D = f * G + mu * H;
    const double complex Dx = f * H + mu * K;
    const double complex Dy = turned(Dx) + mu * H;
    const double complex Dxx = f * K + mu * L;
    const double complex Dxy = turned(Dxx) + mu * K;
    const double complex Dyy = -Dxx + 2 * turned(mu * K);

    const double s = creal(sigma * G), sx = creal(sigma * H), sy = -cimag(sigma * H);
    const double sxx = creal(sigma * K), sxy = -cimag(sigma * K);

    const double complex Df = G + turned(H), Dfx = H + turned(K), Dfy = 2 * turned(H) - K;
    const double sf = -creal(G), sfx = -creal(H), sfy = cimag(H);

    return (rw_von_mises){
        .J2 = dot(D, D) + kappa * s * s,
        .x = 2 * (dot(D, Dx) + kappa * s * sx),
        .y = 2 * (dot(D, Dy) + kappa * s * sy),
        .xx = 2 * (dot(Dx, Dx) + dot(D, Dxx) + kappa * (sx * sx + s * sxx)),
        .xy = 2 * (dot(Dx, Dy) + dot(D, Dxy) + kappa * (sx * sy + s * sxy)),
        .yy = 2 * (dot(Dy, Dy) + dot(D, Dyy) + kappa * (sy * sy - s * sxx)),
        .f_x = 2 * (dot(Df, Dx) + dot(D, Dfx) + kappa * (sf * sx + s * sfx)),
        .f_y = 2 * (dot(Df, Dy) + dot(D, Dfy) + kappa * (sf * sy + s * sfy)),
        .kappa_x = 2 * s * sx,
        .kappa_y = 2 * s * sy,
    };
}

/* G depends on z, a and the half-width c over each other. So where z grows with a, a dG/da is -c
 * dG/dc, which is algebraic. */
rw_von_mises_change rw_von_mises_change_at(const rw_potential *potential, double f, double kappa,
                                           double x, double y)
{
    const rw_field field = rw_potential_at(potential, x, y),
                   punch = rw_potential_by_half_width(potential, x, y);
    const double complex G = rw_number(field.G_re, field.G_im),
                         H = rw_number(field.H_re, field.H_im);
    const double complex Ga = -rw_number(punch.G_re, punch.G_im),
                         Ha = -rw_number(punch.H_re, punch.H_im);
    const double complex mu = rw_number(-1, f), sigma = rw_number(-f, -1);

    const double complex D = f * G + mu * H, Df = G + turned(H), Da = f * Ga + mu * Ha;
    const double s = creal(sigma * G), sf = -creal(G), sa = creal(sigma * Ga);
    return (rw_von_mises_change){
        .J2 = dot(D, D) + kappa * s * s,
        .f = 2 * (dot(D, Df) + kappa * s * sf),
        .kappa = s * s,
        .rounding = 2 * (dot(D, Da) + kappa * s * sa),
    };
}
