/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The transcendental function of unlike bodies that slide. */
#include "claims.h"
#include "quadrature.h"
#include "unlike/power_integral.h"

#include <complex.h>

static double complex value(double a, double complex w)
{
    rw_power_rule rule;
    rw_power_rule_init(&rule, a);
    const double complex rest = 1 - w;
    const rw_complex at = {creal(w), cimag(w)}, left = {creal(rest), cimag(rest)};
    const rw_complex place = rw_power_place(at, left);
    const bool is_near = rw_power_farness(at) < 0;
    const double *c = is_near ? rule.near : rule.far;
    double complex sum = 0;
    for (int k = RW_POWER_TERMS; k-- > 0;)
        sum = sum * (place.re + place.im * I) + c[k];
    return is_near ? sum - cpow(w, -a) * clog(rest) : sum;
}

/* A point of the unit circle's inside, one time in three next to 1. */
static double complex some_point(uint64_t *seed)
{
    const double complex near =
        1 - pow(10, -8 * random_fraction(seed)) * cexp(I * random_between(seed, -1.4, 1.4));
    const double complex any = sqrt(random_fraction(seed)) * cexp(I * random_between(seed, -3, 3));
    return random_fraction(seed) < 1.0 / 3 && cabs(near) < 1 ? near : any;
}

/* Phi(w; 1/2) = (1/root) ln((1 + root)/(1 - root)), root = sqrt(w); the difference 1 - root from w
 * itself: 1 - w is exact to rounding. */
CLAIM(a_half_gives_a_logarithm)
{
    uint64_t seed = 1;
    for (int i = 0; i < 2000; i++) {
        const double complex w = some_point(&seed), root = csqrt(w);
        const double complex expected =
            cabs(w) < 1e-3 ? 2 + w * (2.0 / 3 + w * (2.0 / 5 + w * (2.0 / 7 + w * 2.0 / 9)))
                           : 2 * clog(1 + root) / root - clog(1 - w) / root;
        assert_within(cabs(value(0.5, w) - expected), 0, 1e-13 * cabs(expected));
    }
}

/* With v = u^(1/a) the integrand is 1/(a (1 - w u^(1/a))). */
typedef struct {
    double a;
    double complex w;
    bool wants_imaginary;
} kernel;

static double integrand_at(double u, void *context)
{
    const kernel *k = context;
    const double complex at = 1 / (k->a * (1 - k->w * pow(u, 1 / k->a)));
    return k->wants_imaginary ? cimag(at) : creal(at);
}

CLAIM(any_power_agrees_with_quadrature)
{
    uint64_t seed = 2;
    const double ends[] = {0, 1};
    for (int i = 0; i < 100; i++) {
        const double a = random_between(&seed, 0.05, 0.95);
        const double complex w =
            cexp(I * random_between(&seed, 0.05, 3)) * sqrt(random_fraction(&seed));
        const kernel real = {a, w, false}, imaginary = {a, w, true};
        const double complex expected = integral(integrand_at, &real, 1, ends) +
                                        integral(integrand_at, &imaginary, 1, ends) * I;
        assert_within(cabs(value(a, w) - expected), 0, 1e-12 * cabs(expected));
    }
}

/* Across Re w = 1/2 both series agree. */
CLAIM(both_ways_agree_where_they_meet)
{
    for (double a = 0.05; a < 1; a += 0.09)
        for (double height = -0.86; height < 0.87; height += 0.043) {
            const double complex middle = 0.5 + height * I;
            const double complex far = value(a, middle - 1e-9), near = value(a, middle + 1e-9);
            const double complex slope = (value(a, middle - 1e-4) - value(a, middle - 2e-4)) / 1e-4;
            assert_within(cabs(near - far - 2e-9 * slope), 0, 1e-12 * cabs(far));
        }
}
