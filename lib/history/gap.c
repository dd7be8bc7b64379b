/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The gap outside a centred patch of half-width 1, the profile less the primitive of the potential
 * on the surface:
 *     gap = int_0^x (g - Re G) dx,   g = x/alpha for x < alpha, 1 beyond.
 * With X = sqrt(x^2-1), L = arcosh x,
 *
 *     (pi/2) gap = x D - ((x-alpha)^2/(2 alpha)) M - (c0/2) L + (phi0/(2 alpha)) (x X - L),
 *     D = atan(c0 X/(1 + alpha x)),   M = atan(alpha X/(c0 x)),
 *
 * It follows from the potential in lib/README.md ("The potential"). The arctangents are joined, so
 * that no term is large for c0 near 0. Hertz: gap = ((x X - L) - max(x - alpha, 0)^2)/(2 alpha).
 * Next to the edge the sum is of the order X^3, but its terms are of the order c0 X. They would
 * cancel, and so the derivative is integrated there instead. */
#include "history/gap.h"

#include "base/root.h"
#include "potential/potential.h"

#include <float.h>

/* Beyond this x the series in R is used: |R| < 1/4, and RW_FAR_TERMS terms make it exact. The
 * closed form cancels there like 1/x. */
static const double FAR = 2.25;

/* x X - arcosh(x) = (sinh 2L - 2L)/2. */
static double segment_area(double X)
{
    if (X > 0.5)
        return sqrt(1 + X * X) * X - asinh(X);
    /* int_0^X 2 t^2/sqrt(1+t^2) dt = 2 X^3 sum_k binom(-1/2, k) X^2k/(2k+3). What 24 terms leave
     * out is 0.25^24 = 4e-15 of a term that is below 2e-2 of the first. */
    double term = 1, sum = 1.0 / 3;
    for (int k = 1; k < 25; k++) {
        term *= -X * X * (2 * k - 1) / (2 * k);
        sum += term / (2 * k + 3);
    }
    return 2 * X * X * X * sum;
}

/* M/alpha. Its limit for the sharp wedge is X/x. */
static double arctangent_over_alpha(const rw_potential *p, double X, double x)
{
    const double argument = p->alpha * X / (p->c0 * x);
    return argument < DBL_EPSILON ? X / (p->c0 * x) : atan(argument) / p->alpha;
}

static double closed_form(const rw_potential *p, double x, double X)
{
    const double from_alpha = x - p->alpha;
    return 2 / RW_PI *
           (x * atan(p->c0 * X / (1 + p->alpha * x)) -
            from_alpha * from_alpha / 2 * arctangent_over_alpha(p, X, x) - p->c0 / 2 * asinh(X) +
            p->phi0_over_alpha / 2 * segment_area(X));
}

/* d gap/dX = (g - G) X/x, with x = sqrt(1+X^2). */
static double derivative(double X, const void *potential)
{
    const rw_potential *p = potential;
    const double x = sqrt(1 + X * X);
    const double slope = atan(p->c0 * X / (1 + p->alpha * x)) -
                         (x - p->alpha) * arctangent_over_alpha(p, X, x) + p->phi0_over_alpha * X;
    return 2 / RW_PI * slope * X / x;
}

/* int_0^x Re G for large x. The series of G is integrated term by term; the constant is that of
 * the closed form at infinity. */
static double far_primitive(const rw_potential *p, double x)
{
    const double R = 1 / (x + sqrt(x - 1) * sqrt(x + 1)), R2 = R * R; /* x^2 may overflow */
    double far[RW_FAR_TERMS];
    rw_potential_far_coefficients(p, far);
    double power = 1, sum = far[0] * (R2 / 2 - log(R)); /* power is R^2n */
    for (int n = 1; n < RW_FAR_TERMS; n++) {
        power *= R2;
        sum += far[n] * power * (R2 / (2 * n + 2) - 1.0 / (2 * n));
    }
    const double constant =
        p->alpha >= 1 ? 1 / (4 * p->alpha)
                      : 2 / RW_PI *
                                (0.75 * p->c0 + p->alpha * p->alpha * p->phi0_over_alpha / 2 +
                                 p->phi0_over_alpha / 4) -
                            p->alpha / 2;
    return constant + sum / 2;
}

/* x >= 1 */
static double gap(const rw_potential *potential, double x)
{
    if (x > FAR)
        return rw_wedge_height(potential->alpha, x) - far_primitive(potential, x);
    const double X = sqrt((x - 1) * (x + 1));
    if (potential->alpha >= 1) {
        const double beyond = fmax(x - potential->alpha, 0);
        return (segment_area(X) - beyond * beyond) / (2 * potential->alpha);
    }
    if (X > potential->c0)
        return closed_form(potential, x, X);
    return rw_integral(derivative, potential, 0, X);
}

double rw_centred_gap(double a, double s, double x)
{
    rw_potential potential;
    rw_potential_init(&potential, a / s, 1);
    return s * gap(&potential, x / s);
}
