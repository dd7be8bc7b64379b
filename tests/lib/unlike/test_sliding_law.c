/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unlike bodies in full sliding, in natural units, and what neglecting their coupling costs. */
#include "histories.h"

typedef struct {
    double load, middle, tilt, tension;
} law;

static law law_of(double alpha, double beta_f, int32_t held)
{
    law l;
    assert_ok(rwedge_sliding_law(alpha, beta_f, held, &l.load, &l.middle, &l.tilt, &l.tension));
    return l;
}

static double limit_of(double alpha, double beta_f, double f, int32_t held)
{
    double limit, x, y;
    assert_ok(rwedge_sliding_limit(alpha, beta_f, f, 0.3, held, &limit, &x, &y));
    return limit;
}

CLAIM(the_law_has_the_reference_values)
{
    reference rows = reference_open("sliding_unlike.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell, alpha = c[0];
        const law l = law_of(alpha, -c[1], c[2] == 0);
        assert_close(l.load, alpha * c[5], 1e-13);
        assert_within(l.middle, alpha * c[3], 1e-13);
        assert_within(l.tilt, c[4], 1e-13);
        assert_close(l.tension, 2 * c[10] / (alpha * c[5]), 1e-13);
    }
}

CLAIM(without_coupling_it_is_that_of_similar_bodies)
{
    for (double alpha = 0; alpha < 3; alpha += 0.3)
        for (int32_t held = 0; held < 2; held++) {
            const law l = law_of(alpha, 0, held);
            assert_close(l.load, rwedge_load(alpha), 1e-13);
            assert_true(l.middle == 0);
            assert_within(l.tilt, 0, 1e-14);
            assert_close(l.tension, rwedge_max_tension(alpha), 1e-13);
            assert_within(limit_of(alpha, 0, 0.3, held), rwedge_elastic_limit(alpha, 0.3, 0.3),
                          1e-12);
        }
}

/* P = (pi/2)(1 - 4 lambda^2)/alpha and the middle at -2 lambda where the rounding alone touches. */
CLAIM(hertz_contact_is_closed)
{
    for (double mu = -0.9; mu < 1; mu += 0.3) {
        const double lambda = atan(mu) / PI;
        const law l = law_of(3, -mu, 1);
        assert_close(l.load, PI / 6 * (1 - 4 * lambda * lambda), 1e-13);
        assert_within(l.middle, -2 * lambda, 1e-13);
    }
}

/* Slopes at mu = 0, from exact formulas by another program: the middle of a held contact moves by
 * -1.16 mu (a/b = 0.05), -0.64 mu (Hertz), that of a free one by 0.64 mu, and it tilts by 1.15 mu.
 */
CLAIM(the_contact_swings_as_it_is_held)
{
    const double mu = 1e-3;
    assert_within(law_of(0.05, -mu, 1).middle / mu, -1.16, 0.006);
    assert_within(law_of(2, -mu, 1).middle / mu, -0.64, 0.005);
    assert_within(law_of(0.1, -mu, 0).middle / mu, 0.635, 0.005);
    assert_within(law_of(0.1, -mu, 0).tilt / mu, 1.145, 0.005);
}

/* The formula of tables/README.md, for a workbook. */
CLAIM(a_held_contact_swings_as_a_worksheet_says)
{
    const double mu = 1e-3;
    for (double alpha = 0; alpha < 1.3; alpha += 0.05) {
        const double clear = fmax(0, 1 - alpha * alpha);
        assert_close(-law_of(alpha, -mu, 1).middle / mu, 0.637 + 0.529 * pow(clear, 0.56), 0.012);
    }
}

/* By how much elastic limits change, in percent, by another program's search with the formulas by
 * hypergeometric functions: mu = 0.05 and -0.05, held, nu = 0.3. */
CLAIM(elastic_limits_change_as_another_program_finds)
{
    static const double F[] = {0.1, 0.2, 0.3, 0.5, 0.8};
    static const struct {
        double alpha, mu, percent[5];
    } ROWS[] = {{0.1, 0.05, {-0.09, -0.20, -0.26, -0.27, -0.22}},
                {0.5, 0.05, {-0.08, -0.22, 0.11, 0.13, 0.13}},
                {0.7, 0.05, {0.07, 0.09, 0.25, 0.37, 0.46}},
                {1, 0.05, {0.05, 0.32, 0.19, 0.41, 0.68}},
                {0.3, -0.05, {0.31, 0.48, 0.19, 0.21, 0.20}},
                {0.7, -0.05, {-0.01, -0.01, -0.28, -0.39, -0.46}},
                {1, -0.05, {-0.44, -0.72, -0.61, -0.88, -1.26}}};
    for (size_t i = 0; i < sizeof ROWS / sizeof *ROWS; i++)
        for (int k = 0; k < 5; k++) {
            const double similar = rwedge_elastic_limit(ROWS[i].alpha, F[k], 0.3);
            const double change =
                100 * (limit_of(ROWS[i].alpha, -ROWS[i].mu, F[k], 1) / similar - 1);
            assert_within(change, ROWS[i].percent[k], 0.0051); /* two digits are given */
        }
}

/* The tension beside the edge in a steady cycle of Q = 0.6 f P, over that without coupling, less
 * 1, by fully coupled boundary elements: a = theta/A = 1, P = 7.7, f = 0.5, beta = -0.1. */
static double found_by_elements(double x, double sxx)
{
    const double P = 7.7, Q = 2.31;
    rwedge_contact *similar = APPLY(create_wedge(0.01, 1, 0.01, 0.5), {P, 0, 0, 0}, {P, 0, Q, 0},
                                    {P, 0, -Q, 0}, {P, 0, Q, 0});
    return sxx / stress_at(similar, x, 0).xx - 1;
}

CLAIM(the_estimate_has_sign_and_size_of_what_elements_find)
{
    const double alpha = 1 / rwedge_half_width(0.01, 1, 0.01, 7.7);
    double swing, held, free;
    assert_ok(rwedge_coupling(alpha, -0.1, 0.5, 0.6, 1, &swing, &held));
    assert_within(swing, -1.16 * 0.03, 0.002);
    assert_within(held / found_by_elements(-4.2824, 0.5188377), 1, 0.1);
    assert_ok(rwedge_coupling(alpha, -0.1, 0.5, 0.6, 0, &swing, &free));
    assert_true(swing > 0);
    assert_within(found_by_elements(-4.187, 0.4949443) / free, 2.9, 0.5);
}

CLAIM(what_has_no_such_contact_is_refused)
{
    double a = 7, b = 7, c = 7, d = 7;
    assert_int_equal(rwedge_sliding_law(1e-4, 0.1, 1, &a, &b, &c, &d), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_sliding_law(0.1, 1.1, 1, &a, &b, &c, &d), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_sliding_law(0.1, NAN, 1, &a, &b, &c, &d), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_sliding_law(0.1, 0.1, 2, &a, &b, &c, &d), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_sliding_law(0.1, 0.1, 1, NULL, &b, &c, &d), RWEDGE_ENULL);
    assert_int_equal(rwedge_sliding_limit(0.1, 0.3, 0.5, 0.3, 1, &a, &b, &c), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_sliding_limit(0.1, 0.1, 0.5, 0.6, 1, &a, &b, &c), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_coupling(0.1, 0.6, 0.5, 0.6, 1, &a, &b), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_coupling(0.1, 0.1, 0.5, 1.1, 1, &a, &b), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_coupling(0.1, 0.1, 0.5, 0.6, 1, NULL, &b), RWEDGE_ENULL);
    assert_true(a == 7 && b == 7 && c == 7 && d == 7);
}
