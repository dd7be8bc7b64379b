/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic constants of the pair of bodies. */
#include "rwedge.h"

#include "base/domain.h"

static bool is_body(double E, double nu)
{
    return (E == HUGE_VAL || rw_is_positive(E)) && isgreater(nu, -1) && islessequal(nu, 0.5);
}

/* (1-nu^2)/E: half of a body's share of A; 0 for a rigid one. */
static double half_share(double E, double nu)
{
    return (1 - nu) * (1 + nu) / E;
}

double rwedge_compliance(double E1, double nu1, double E2, double nu2)
{
    if (!is_body(E1, nu1) || !is_body(E2, nu2))
        return NAN;
    const double A = 2 * (half_share(E1, nu1) + half_share(E2, nu2));
    return rw_is_positive(A) ? A : NAN;
}

/* With mu = E/(2(1+nu)) and kappa = 3 - 4 nu,
 *     beta = (mu1 (kappa2 - 1) - mu2 (kappa1 - 1)) / (mu1 (kappa2 + 1) + mu2 (kappa1 + 1))
 *          = (l2 s2 - l1 s1) / (s1 + s2),   s = 2(1-nu^2)/E,   l = (1-2nu)/(2(1-nu)).
 * Each body's own ratio l is weighted with its compliance s. A rigid body has s = 0. */
double rwedge_dundurs_beta(double E1, double nu1, double E2, double nu2)
{
    const double A = rwedge_compliance(E1, nu1, E2, nu2);
    if (isnan(A))
        return NAN;
    double l1 = (1 - 2 * nu1) / (2 * (1 - nu1));
    double l2 = (1 - 2 * nu2) / (2 * (1 - nu2));
    return l2 * (2 * half_share(E2, nu2) / A) - l1 * (2 * half_share(E1, nu1) / A);
}

/* With kappa = (3 - nu)/(1 + nu): s = 2/E, l = (1-nu)/2. */
double rwedge_dundurs_beta_plane_stress(double E1, double nu1, double E2, double nu2)
{
    if (!is_body(E1, nu1) || !is_body(E2, nu2))
        return NAN;
    const double A = rwedge_compliance(E1, 0, E2, 0);
    if (isnan(A))
        return NAN;
    return (1 - nu2) * (1 / E2 / A) - (1 - nu1) * (1 / E1 / A);
}
