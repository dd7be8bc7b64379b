/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps of the certificate: each enclosure contains what it must, and is sharp enough to be
 * useful. */
#include "claims.h"
#include "curvature.h"
#include "search.h"

#include <float.h>

static double random_between(uint64_t *seed, double low, double high)
{
    return low + (high - low) * random_fraction(seed);
}

static double random_sign(uint64_t *seed)
{
    return random_fraction(seed) < 0.5 ? -1 : 1;
}

static double value_at(const model *m, double xi, double eta)
{
    return m->one + m->x * xi + m->y * eta + m->xx * xi * xi + m->xy * xi * eta + m->yy * eta * eta;
}

static model random_model(uint64_t *seed, double rest)
{
    double k[6];
    for (int i = 0; i < 6; i++)
        k[i] = random_between(seed, -1, 1) * pow(10, random_between(seed, -3, 0));
    return (model){k[0], k[1], k[2], k[3], k[4], k[5], rest};
}

static double maximum_on_grid(const model *m)
{
    enum { GRID = 50 };
    double best = -HUGE_VAL;
    for (int i = -GRID; i <= GRID; i++)
        for (int j = -GRID; j <= GRID; j++)
            best = fmax(best, value_at(m, (double)i / GRID, (double)j / GRID));
    return best;
}

static void the_maximum_of_a_polynomial_is_bounded_sharply(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int i = 0; i < 2000; i++) {
        model m = random_model(&seed, 0);
        if (i % 2) /* the concave ones are rare */
            m.xx = -fabs(m.xx), m.yy = -fabs(m.yy),
            m.xy = random_between(&seed, -2, 2) * sqrt(m.xx * m.yy);
        const double bound = model_maximum(&m);
        const summit top = model_summit(&m);
        assert_true(bound >= maximum_on_grid(&m));
        assert_true(fabs(top.xi) <= 1 && fabs(top.eta) <= 1);
        assert_within(bound, value_at(&m, top.xi, top.eta), 1e-11); /* so that it is attained */
    }
}

static void nothing_bounds_what_is_not_finite(void **state)
{
    (void)state;
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < (i == 6 ? 2 : 3); j++) { /* the rest is not negative */
            double k[7] = {0.1, 0.2, -0.3, 0.4, -0.5, 0.6, 0};
            k[i] = j == 0 ? NAN : j == 1 ? HUGE_VAL : -HUGE_VAL;
            const model m = {k[0], k[1], k[2], k[3], k[4], k[5], k[6]};
            assert_true(model_maximum(&m) == HUGE_VAL);
        }
}

static void products_and_sums_contain_those_of_the_values(void **state)
{
    (void)state;
    uint64_t seed = 2;
    for (int i = 0; i < 2000; i++) {
        const model a = random_model(&seed, i % 3 ? 0.1 : 0),
                    b = random_model(&seed, i % 5 ? 0.01 : 0);
        const model both[2] = {a, b};
        const double weight[2] = {random_between(&seed, -2, 2), random_between(&seed, -2, 2)};
        const model product = model_product(&a, &b), sum = model_combination(2, weight, both);
        for (int j = 0; j < 20; j++) { /* at the corners, the rests at their ends */
            const double xi = random_sign(&seed), eta = random_sign(&seed);
            const double va = value_at(&a, xi, eta) + a.rest * random_sign(&seed);
            const double vb = value_at(&b, xi, eta) + b.rest * random_sign(&seed);
            assert_within(va * vb, value_at(&product, xi, eta), product.rest);
            assert_within(weight[0] * va + weight[1] * vb, value_at(&sum, xi, eta), sum.rest);
        }
    }
}

/* Differences of G' over the spacing 2^-14. */
static void differences(curvature *d, const ball_patch *patch, const acb_t z)
{
    acb_t slope[5], step;
    acb_init(step);
    for (int i = 0; i < 5; i++) {
        acb_init(slope[i]);
        acb_set_d_d(step, ldexp(i - 2, -14), 0);
        acb_add(step, step, z, BITS);
        ball_potential_slope(slope[i], patch, step, BITS);
    }
    acb_sub(d->second, slope[3], slope[1], BITS);
    acb_sub(d->fourth, slope[4], slope[0], BITS);
    acb_submul_ui(d->fourth, d->second, 2, BITS);
    acb_mul_2exp_si(d->fourth, d->fourth, 3 * 14 - 1);
    acb_mul_2exp_si(d->second, d->second, 14 - 1);
    acb_add(d->third, slope[3], slope[1], BITS);
    acb_submul_ui(d->third, slope[2], 2, BITS);
    acb_mul_2exp_si(d->third, d->third, 2 * 14);
    acb_clear(step);
    for (int i = 0; i < 5; i++)
        acb_clear(slope[i]);
}

static void assert_near(const acb_t difference, const acb_t derivative)
{
    const double re = ball_lower(acb_realref(derivative)), im = ball_lower(acb_imagref(derivative));
    assert_within(ball_lower(acb_realref(difference)), re, 1e-5 * hypot(re, im));
    assert_within(ball_lower(acb_imagref(difference)), im, 1e-5 * hypot(re, im));
}

static void the_curvatures_are_those_of_the_slope(void **state)
{
    (void)state;
    static const double alphas[] = {0.05, 0.3, 0.99, 1, 2};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++)
        for (int j = 0; j < 20; j++) {
            contact c;
            arb_t alpha;
            acb_t z;
            curvature exact, approximate;
            arb_init(alpha), acb_init(z), curvature_init(&exact), curvature_init(&approximate);
            arb_set_d(alpha, alphas[i]);
            contact_init(&c, alpha);
            acb_set_d_d(z, -1.27 + 0.13 * j, 0.1 + 0.1 * (j % 7));
            curvature_enclose(&exact, &c.patch, z, BITS);
            differences(&approximate, &c.patch, z);
            assert_near(approximate.second, exact.second);
            assert_near(approximate.third, exact.third);
            assert_near(approximate.fourth, exact.fourth);
            contact_clear(&c);
            arb_clear(alpha), acb_clear(z), curvature_clear(&exact), curvature_clear(&approximate);
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
    return (square){random_sign(seed) * x, y, half};
}

static void assert_contains(const model *m, double xi, double eta, const arb_t value)
{
    const double v = ball_lower(value);
    assert_within(v, value_at(m, xi, eta), m->rest + 4 * DBL_EPSILON * (fabs(v) + model_bound(m)));
}

typedef struct {
    long enclosed;
    double tightest; /* least of: largest error seen in a square, over the rest that is allowed */
} tally;

static void check_square(const contact *c, square s, uint64_t *seed, tally *count)
{
    field over;
    model term[TERMS];
    arb_t f, kappa, J2;
    acb_t z, value;
    arb_init(f), arb_init(kappa), arb_init(J2), acb_init(z), acb_init(value);
    field_enclose(&over, c, s);
    enclose_terms(term, &over);
    const double friction = random_fraction(seed), k = random_fraction(seed) / 3;
    const double weight[TERMS] = {1, friction,     friction * friction,
                                  k, k * friction, k * friction * friction};
    const model J2_over = model_combination(TERMS, weight, term);
    arb_set_d(f, friction);
    arb_set_d(kappa, k);
    if (over.u.rest + over.v.rest + over.p.rest + over.q.rest < HUGE_VAL) {
        count->enclosed++;
        for (int i = 0; i < 6; i++) {
            const double xi = i < 4 ? (i % 2 ? 1 : -1) : random_between(seed, -1, 1);
            const double eta = i < 4 ? (i / 2 ? 1 : -1) : random_between(seed, -1, 1);
            acb_set_d_d(z, s.x + s.half * xi, fmax(0, s.y + s.half * eta));
            ball_potential(value, &c->patch, z, BITS);
            assert_contains(&over.u, xi, eta, acb_realref(value));
            assert_contains(&over.v, xi, eta, acb_imagref(value));
            ball_potential_slope_by_depth(value, &c->patch, z, BITS);
            assert_contains(&over.p, xi, eta, acb_realref(value));
            assert_contains(&over.q, xi, eta, acb_imagref(value));
            ball_J2(J2, c, z, f, kappa);
            assert_contains(&J2_over, xi, eta, J2);
            assert_true(ball_lower(J2) <= model_maximum(&J2_over));
            const double error =
                fabs(ball_lower(acb_imagref(value)) - value_at(&over.q, xi, eta)) / over.q.rest;
            count->tightest = fmax(count->tightest, error);
        }
    }
    arb_clear(f), arb_clear(kappa), arb_clear(J2), acb_clear(z), acb_clear(value);
}

/* The largest error seen, over the rest that bounds it, says how much of the bound is needed. */
static void squares_contain_what_points_in_them_give(void **state)
{
    (void)state;
    static const double alphas[] = {0.01, 0.1, 0.5, 0.9, 0.99, 1, 3};
    uint64_t seed = 3;
    tally count = {0};
    for (size_t i = 0; i < sizeof alphas / sizeof *alphas; i++) {
        contact c;
        arb_t alpha;
        arb_init(alpha);
        arb_set_d(alpha, alphas[i]);
        contact_init(&c, alpha);
        for (int j = 0; j < 2000; j++)
            check_square(&c, random_square(&seed, alphas[i]), &seed, &count);
        contact_clear(&c);
        arb_clear(alpha);
    }
    assert_true(count.enclosed > 10000);
    assert_true(count.tightest > 0.5);
}

/* The certificate finishes because the rest falls like the cube of the square's size: by 8 when
 * that is halved. */
static void the_rest_falls_with_the_cube(void **state)
{
    (void)state;
    contact c;
    arb_t alpha;
    arb_init(alpha);
    arb_set_d(alpha, 0.3);
    contact_init(&c, alpha);
    double before = 0;
    for (double half = ldexp(1, -10); half > 1e-5; half /= 2) {
        field over;
        field_enclose(&over, &c, (square){0.1, 0.2, half});
        if (before > 0)
            assert_close(over.q.rest / before, 0.125, 0.1);
        before = over.q.rest;
    }
    contact_clear(&c);
    arb_clear(alpha);
}

static void far_away_J2_is_below_its_bound(void **state)
{
    (void)state;
    enum { DISTANCE = 3 };
    uint64_t seed = 4;
    double nearest = 0;
    for (int i = 0; i < 2000; i++) {
        contact c;
        arb_t alpha, f, kappa, J2, bound;
        acb_t z;
        arb_init(alpha), arb_init(f), arb_init(kappa), arb_init(J2), arb_init(bound), acb_init(z);
        arb_set_d(alpha, random_between(&seed, 0.01, 1.2));
        arb_set_d(f, random_fraction(&seed));
        arb_set_d(kappa, random_fraction(&seed) / 3);
        contact_init(&c, alpha);
        /* on the curve at that distance from the contact */
        const double angle = random_between(&seed, 0, 3.14159265),
                     end = random_between(&seed, -1, 1);
        const double x =
            fabs(cos(angle)) > 0.5 ? DISTANCE * cos(angle) + (cos(angle) > 0 ? 1 : -1) : end;
        const double y = fabs(cos(angle)) > 0.5 ? DISTANCE * sin(angle) : DISTANCE;
        acb_set_d_d(z, x, y);
        ball_J2(J2, &c, z, f, kappa);
        ball_far_J2(bound, &c, DISTANCE, f, kappa);
        assert_true(arb_lt(J2, bound));
        arb_div(J2, J2, bound, BITS);
        nearest = fmax(nearest, ball_lower(J2));
        contact_clear(&c);
        arb_clear(alpha), arb_clear(f), arb_clear(kappa), arb_clear(J2), arb_clear(bound),
            acb_clear(z);
    }
    assert_true(nearest > 0.3);
}

/* The other route to J2, load and limit. */
static void the_reference_limits_are_those_of_their_places(void **state)
{
    (void)state;
    reference table = reference_open("elastic_limit.csv");
    size_t checked = 0;
    while (reference_next(&table)) {
        const double *cell = table.cell;
        if (cell[0] < 1e-3)
            continue;
        contact c;
        arb_t alpha, f, kappa, J2;
        acb_t z;
        arb_init(alpha), arb_init(f), arb_init(kappa), arb_init(J2), acb_init(z);
        arb_set_d(alpha, cell[0]);
        arb_set_d(f, cell[1]);
        arb_set_d(kappa, (1 - 2 * cell[2]) * (1 - 2 * cell[2]) / 3);
        acb_set_d_d(z, cell[4], cell[5]);
        contact_init(&c, alpha);
        ball_J2(J2, &c, z, f, kappa);
        arb_sqrt(J2, J2, BITS);
        arb_div(J2, c.load, J2, BITS);
        assert_close(ball_lower(J2), cell[3], 1e-13);
        checked++;
        contact_clear(&c);
        arb_clear(alpha), arb_clear(f), arb_clear(kappa), arb_clear(J2), acb_clear(z);
    }
    assert_true(checked > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_maximum_of_a_polynomial_is_bounded_sharply),
        cmocka_unit_test(nothing_bounds_what_is_not_finite),
        cmocka_unit_test(products_and_sums_contain_those_of_the_values),
        cmocka_unit_test(the_curvatures_are_those_of_the_slope),
        cmocka_unit_test(squares_contain_what_points_in_them_give),
        cmocka_unit_test(the_rest_falls_with_the_cube),
        cmocka_unit_test(far_away_J2_is_below_its_bound),
        cmocka_unit_test(the_reference_limits_are_those_of_their_places),
    };
    return RUN_CLAIMS("enclosure", tests);
}
