/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps of the certificate: each enclosure contains what it must, and is sharp enough to be
 * useful. */
#include "search.hpp"

#include <float.h>

extern "C" {
#include "claims.h"
}

static double random_sign(uint64_t *seed)
{
    return random_fraction(seed) < 0.5 ? -1 : 1;
}

static model random_model(uint64_t *seed, double rest)
{
    double k[6];
    for (int i = 0; i < 6; i++)
        k[i] = random_between(seed, -1, 1) * pow(10, random_between(seed, -3, 0));
    return {k[0], k[1], k[2], k[3], k[4], k[5], rest};
}

static double maximum_on_grid(const model &m)
{
    enum { GRID = 50 };
    double best = -HUGE_VAL;
    for (int i = -GRID; i <= GRID; i++)
        for (int j = -GRID; j <= GRID; j++)
            best = fmax(best, m.at((double)i / GRID, (double)j / GRID));
    return best;
}

CLAIM(the_maximum_of_a_polynomial_is_bounded_sharply)
{
    uint64_t seed = 1;
    for (int i = 0; i < 2000; i++) {
        model m = random_model(&seed, 0);
        if (i % 2) /* the concave ones are rare */
            m.xx = -fabs(m.xx), m.yy = -fabs(m.yy),
            m.xy = random_between(&seed, -2, 2) * sqrt(m.xx * m.yy);
        const double bound = model_maximum(m);
        const summit top = model_summit(m);
        assert_true(bound >= maximum_on_grid(m));
        assert_true(fabs(top.xi) <= 1 && fabs(top.eta) <= 1);
        assert_within(bound, m.at(top.xi, top.eta), 1e-11); /* so that it is attained */
    }
}

CLAIM(nothing_bounds_what_is_not_finite)
{
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < (i == 6 ? 2 : 3); j++) { /* the rest is not negative */
            double k[7] = {0.1, 0.2, -0.3, 0.4, -0.5, 0.6, 0};
            k[i] = j == 0 ? NAN : j == 1 ? HUGE_VAL : -HUGE_VAL;
            const model m = {k[0], k[1], k[2], k[3], k[4], k[5], k[6]};
            assert_true(model_maximum(m) == HUGE_VAL);
        }
}

CLAIM(products_and_sums_contain_those_of_the_values)
{
    uint64_t seed = 2;
    for (int i = 0; i < 2000; i++) {
        const model a = random_model(&seed, i % 3 ? 0.1 : 0),
                    b = random_model(&seed, i % 5 ? 0.01 : 0);
        const model both[2] = {a, b};
        const double weight[2] = {random_between(&seed, -2, 2), random_between(&seed, -2, 2)};
        const model product = a * b, sum = model_combination(2, weight, both);
        for (int j = 0; j < 20; j++) { /* at the corners, the rests at their ends */
            const double xi = random_sign(&seed), eta = random_sign(&seed);
            const double va = a.at(xi, eta) + a.rest * random_sign(&seed);
            const double vb = b.at(xi, eta) + b.rest * random_sign(&seed);
            assert_within(va * vb, product.at(xi, eta), product.rest);
            assert_within(weight[0] * va + weight[1] * vb, sum.at(xi, eta), sum.rest);
        }
    }
}

/* A square of any size down to 1e-7, next to the surface or one of the special places as often
 * as not. */
static square random_square(uint64_t *seed, double alpha)
{
    const double half = pow(10, random_between(seed, -7, 0)),
                 by = pow(10, random_between(seed, -1, 1.5)) * half;
    const double around[] = {0, alpha, 1, random_between(seed, 0, 3)};
    const double x = around[(int)(4 * random_fraction(seed))] + by * random_between(seed, -1, 1);
    const double y = half + (random_fraction(seed) < 0.5 ? 0 : by);
    return {random_sign(seed) * x, y, half};
}

static void assert_contains(const model &m, double xi, double eta, const ball &value)
{
    const double v = middle(value);
    assert_within(v, m.at(xi, eta), m.rest + 4 * DBL_EPSILON * (fabs(v) + model_bound(m)));
}

struct tally {
    long enclosed;
    double tightest; /* least of: largest error seen in a square, over the rest that is allowed */
};

static void check_square(const patch &c, square s, uint64_t *seed, tally *count)
{
    const field over = field_over(c, s);
    const double f = random_fraction(seed), kappa = random_fraction(seed) / 3;
    if (!(over.u.rest + over.v.rest + over.p.rest + over.q.rest < HUGE_VAL))
        return;
    model term[TERMS];
    enclose_terms(term, over);
    const double weight[TERMS] = {1, f, f * f, kappa, kappa * f, kappa * f * f};
    const model J2_over = model_combination(TERMS, weight, term);
    count->enclosed++;
    for (int i = 0; i < 6; i++) {
        const double xi = i < 4 ? (i % 2 ? 1 : -1) : random_between(seed, -1, 1);
        const double eta = i < 4 ? (i / 2 ? 1 : -1) : random_between(seed, -1, 1);
        const complex_ball z(s.x + s.half * xi, fmax(0, s.y + s.half * eta));
        const complex_ball G = c.potential(z), H = c.depth_slope(z);
        const ball J2 = J2_at(c, z, f, kappa);
        assert_contains(over.u, xi, eta, re(G));
        assert_contains(over.v, xi, eta, im(G));
        assert_contains(over.p, xi, eta, re(H));
        assert_contains(over.q, xi, eta, im(H));
        assert_contains(J2_over, xi, eta, J2);
        assert_true(middle(J2) <= model_maximum(J2_over));
        const double error = fabs(middle(im(H)) - over.q.at(xi, eta)) / over.q.rest;
        count->tightest = fmax(count->tightest, error);
    }
}

/* The largest error seen, over the rest that bounds it, says how much of the bound is needed. */
CLAIM(squares_contain_what_points_in_them_give)
{
    uint64_t seed = 3;
    tally count = {};
    for (const double alpha : {0.01, 0.1, 0.5, 0.9, 0.99, 1.0, 3.0}) {
        const patch c(alpha, 1);
        for (int j = 0; j < 700; j++)
            check_square(c, random_square(&seed, alpha), &seed, &count);
    }
    assert_true(count.enclosed > 3500);
    assert_true(count.tightest > 0.5);
}

/* The certificate finishes because the rest falls like the cube of the square's size: by 8 when
 * that is halved. */
CLAIM(the_rest_falls_with_the_cube)
{
    const patch c(0.3, 1);
    double before = 0;
    for (double half = ldexp(1, -10); half > 1e-5; half /= 2) {
        const field over = field_over(c, {0.1, 0.2, half});
        if (before > 0)
            assert_close(over.q.rest / before, 0.125, 0.1);
        before = over.q.rest;
    }
}

/* A point of the curve at the distance from the contact. */
static complex_ball random_point_at(double distance, uint64_t *seed)
{
    const double angle = random_between(seed, 0, 3.14159265), end = random_between(seed, -1, 1);
    if (fabs(cos(angle)) <= 0.5)
        return complex_ball(end, distance);
    return complex_ball(distance * cos(angle) + (cos(angle) > 0 ? 1 : -1), distance * sin(angle));
}

CLAIM(far_away_J2_is_below_its_bound)
{
    enum { DISTANCE = 3 };
    uint64_t seed = 4;
    double nearest = 0;
    for (int i = 0; i < 2000; i++) {
        const patch c(random_between(&seed, 0.01, 1.2), 1);
        const double f = random_fraction(&seed), kappa = random_fraction(&seed) / 3;
        const ball J2 = J2_at(c, random_point_at(DISTANCE, &seed), f, kappa);
        const ball bound = far_J2(c, DISTANCE, f, kappa);
        assert_true(J2 < bound);
        nearest = fmax(nearest, middle(J2 / bound));
    }
    assert_true(nearest > 0.3);
}
