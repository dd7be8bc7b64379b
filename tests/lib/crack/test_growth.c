/* SPDX-License-Identifier: GPL-3.0-or-later */
/* K of a crack through a cycle of loads, where it stops, and how long it takes to grow. */
#include "histories.h"

#include <stdlib.h>

enum { MOST = 24 };

/* The bulk tension alone, from 0 to a value: K is 1.12... sigma sqrt(pi l). */
static const double EDGE = 1.1215222552310553;

static rwedge_cycle *pulled(double sigma)
{
    return cycle_of(create(0.4, 0.5), 2, (const rw_loads[]){{0, 0, 0, sigma}, {0, 0, 0, 0}});
}

/* ---- K ---- */

CLAIM(a_cycle_has_the_k_of_its_states)
{
    static const double length[] = {1e-3, 0.02, 0.3, 2, 40};
    const rw_loads load[] = {{1, 0, 0.3, 0.02}, {1, 0, -0.2, -0.01}, {1.2, 0, 0.1, 0.03}};
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {1, 0, 0, 0});
    const rwedge_cycle *cycle = cycle_of(contact, 3, load);
    const double x = -rwedge_contact_half_width(contact), angle = -0.3;
    double K_I[15], K_II[15], overlap[15], one_I[3], one_II[3], one[3];
    assert_ok(rwedge_cycle_crack(cycle, x, angle, 3, 5, length, K_I, K_II, overlap));
    double place[200], normal_I[200], shear_I[200], normal_II[200], shear_II[200];
    const size_t m = rwedge_crack_points(angle);
    assert_ok(rwedge_crack_weights(angle, m, place, normal_I, shear_I, normal_II, shear_II));
    const double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < 3; i++) {
        apply(contact, load[i].P, load[i].M, load[i].Q, load[i].sigma);
        for (size_t j = 0; j < 5; j++) {
            double I = 0, II = 0;
            for (size_t k = 0; k < m; k++) {
                const double r = place[k] * length[j];
                const stresses at = stress_at(contact, x + r * s, r * c);
                const double n = c * c * at.xx - 2 * c * s * at.xy + s * s * at.yy;
                const double t = c * s * (at.xx - at.yy) + (c * c - s * s) * at.xy;
                I += normal_I[k] * n + shear_I[k] * t;
                II += normal_II[k] * n + shear_II[k] * t;
            }
            const double root = sqrt(length[j]);
            assert_within(K_I[i * 5 + j], root * I, 1e-12 * root);
            assert_within(K_II[i * 5 + j], root * II, 1e-12 * root);
        }
    }
    assert_ok(rwedge_cycle_crack(cycle, x, angle, 3, 1, &length[2], one_I, one_II, one));
    for (size_t i = 0; i < 3; i++)
        assert_true(one_I[i] == K_I[i * 5 + 2] && one_II[i] == K_II[i * 5 + 2] &&
                    one[i] == overlap[i * 5 + 2]);
}

CLAIM(faces_overlap_where_they_are_pressed)
{
    const double length[] = {0.1, 1};
    double K_I[4], K_II[4], overlap[4];
    const rwedge_cycle *cycle =
        cycle_of(create(0.4, 0.5), 2, (const rw_loads[]){{0, 0, 0, 0.1}, {0, 0, 0, -0.1}});
    for (double angle = -1.3; angle < 1.4; angle += 0.65) {
        assert_ok(rwedge_cycle_crack(cycle, 0, angle, 2, 2, length, K_I, K_II, overlap));
        assert_true(K_I[0] > 0 && overlap[0] == 0 && overlap[1] == 0);
        assert_true(K_I[2] < 0);
        assert_close(overlap[2], 1, 1e-14);
    }
}

/* ---- Closed forms of a plain specimen ---- */

typedef struct {
    double arrest, cycles, least, least_at;
} growth;

static growth growth_of(const rwedge_cycle *cycle, double x, double angle, int32_t shear,
                        const double law[5], double initial, double final)
{
    growth g;
    assert_ok(rwedge_cycle_growth(cycle, x, angle, shear, 5, law, initial, final, &g.arrest,
                                  &g.cycles, &g.least, &g.least_at));
    return g;
}

CLAIM(a_plain_specimen_lives_as_paris_integral_says)
{
    const double sigma = 0.2, C = 1e-3, per_root = EDGE * sigma * sqrt(PI);
    const double third[] = {0, HUGE_VAL, C, 3, HUGE_VAL}, square[] = {0, HUGE_VAL, C, 2, HUGE_VAL};
    const rwedge_cycle *cycle = pulled(sigma);
    growth g = growth_of(cycle, 0, 0, RWEDGE_FACES_FREE, third, 1e-3, 10);
    assert_close(g.cycles, 2 * (1 / sqrt(1e-3) - 1 / sqrt(10)) / (C * pow(per_root, 3)), 1e-10);
    assert_true(isinf(g.arrest) && isinf(g.least));
    g = growth_of(cycle, 0, 0, RWEDGE_FACES_MODE_I, square, 1e-3, 10);
    assert_close(g.cycles, log(1e4) / (C * per_root * per_root), 1e-10);
}

CLAIM(a_plain_specimen_breaks_where_k_is_its_toughness)
{
    const double sigma = 0.2, C = 1e-3, per_root = EDGE * sigma * sqrt(PI), end = 3;
    const double law[] = {0, HUGE_VAL, C, 2, per_root * sqrt(end)};
    const growth g = growth_of(pulled(sigma), 0, 0, RWEDGE_FACES_FREE, law, 0.01, 10);
    assert_close(g.arrest, end, 1e-12);
    assert_close(g.cycles, log(end / 0.01) / (C * per_root * per_root), 1e-10);
    const growth at_once = growth_of(pulled(sigma), 0, 0, RWEDGE_FACES_FREE, law, 4, 10);
    assert_true(at_once.arrest == 4 && at_once.cycles == 0);
}

/* Below its limit a plain specimen has a ratio of sigma/ds0 sqrt((l + a0)/a0). */
CLAIM(a_plain_specimen_below_its_limit_grows_from_where_it_passes_the_threshold)
{
    const double sigma = 0.2, ds0 = 0.3, dK_th = 0.1, law[] = {dK_th, ds0, 1e-3, 3, HUGE_VAL};
    const double a0 = pow(dK_th / (EDGE * ds0), 2) / PI;
    const growth g = growth_of(pulled(sigma), 0, 0, RWEDGE_FACES_LOCKED, law, 0.001, 1);
    assert_true(g.arrest == 0.001 && isinf(g.cycles) && g.least_at == 0.001);
    assert_close(g.least, sigma / ds0 * sqrt((0.001 + a0) / a0), 1e-12);
    const double passes = a0 * (ds0 * ds0 / (sigma * sigma) - 1);
    const growth beyond =
        growth_of(pulled(sigma), 0, 0, RWEDGE_FACES_LOCKED, law, passes * (1 + 1e-9), 1);
    assert_true(isinf(beyond.arrest) && isfinite(beyond.cycles));
}

/* ---- Contacts ---- */

enum { PAD, P1, P2, COMPLIANCE, FRICTION, LOAD_P, LOAD_Q, TENSION, LOADS, DEGREES, FACES };
enum { INITIAL = FACES + 1, FINAL, RATIO, LEAST, ARREST, CYCLES };

static rwedge_cycle *cycle_of_row(const double cell[], double *x)
{
    rwedge_contact *contact =
        cell[PAD] == 0 ? create_flat(cell[P1], cell[P2], cell[COMPLIANCE], cell[FRICTION])
                       : create_wedge(cell[P1], cell[P2], cell[COMPLIANCE], cell[FRICTION]);
    const size_t loads = (size_t)cell[LOADS];
    rw_loads load[MOST];
    for (size_t i = 0; i < loads; i++) {
        const double share = cos(2 * PI * (double)(i + 1) / (double)loads);
        load[i] = (rw_loads){cell[LOAD_P], 0, cell[LOAD_Q] * share, cell[TENSION] * share};
    }
    apply(contact, cell[LOAD_P], 0, 0, 0);
    apply(contact, cell[LOAD_P], 0, cell[LOAD_Q], cell[TENSION]);
    apply_all(contact, loads, load);
    *x = edges_of(contact).left;
    return cycle_of(contact, loads, load);
}

static double ratio_at(const rwedge_cycle *cycle, double x, double angle, int32_t faces,
                       double length)
{
    double K_I[MOST], K_II[MOST], overlap[MOST], I, II, K_max, R;
    const size_t loads = rwedge_cycle_loads(cycle);
    assert_ok(rwedge_cycle_crack(cycle, x, angle, loads, 1, &length, K_I, K_II, overlap));
    assert_ok(rwedge_crack_ranges(loads, 1, K_I, K_II, faces, &I, &II, &K_max, &R));
    return hypot(I, II) / rwedge_short_crack_threshold(length, 66.4, 248);
}

CLAIM(cracks_under_contacts_stop_and_grow_as_their_reference_says)
{
    const double law[] = {66.4, 248, 1e-7 / pow(1000, 1.5), 3, HUGE_VAL};
    reference table = reference_open("crack_growth.csv");
    while (reference_next(&table)) {
        const double *cell = table.cell, angle = cell[DEGREES] * PI / 180;
        const int32_t faces = (int32_t)cell[FACES];
        double x;
        const rwedge_cycle *cycle = cycle_of_row(cell, &x);
        const growth g = growth_of(cycle, x, angle, faces, law, cell[INITIAL], cell[FINAL]);
        assert_close(ratio_at(cycle, x, angle, faces, cell[INITIAL]), cell[RATIO], 2e-9);
        assert_close(ratio_at(cycle, x, angle, faces, g.least_at), g.least, 1e-12);
        assert_close(g.least, cell[LEAST], 1e-3); /* that of places */
        assert_true(g.least <= cell[LEAST] * (1 + 1e-9));
        if (isnan(cell[ARREST]))
            assert_true(isinf(g.arrest));
        else
            assert_close(g.arrest, cell[ARREST], 1e-9);
        if (isnan(cell[CYCLES]))
            assert_true(isinf(g.cycles));
        else
            assert_close(g.cycles, cell[CYCLES], faces == RWEDGE_FACES_LOCKED ? 1e-5 : 1e-6);
    }
    assert_int_equal(table.row, 6);
}

/* The rates at 4000 lengths, by the trapezoidal rule of ln l. */
CLAIM(the_life_is_the_sum_of_its_rates)
{
    enum { RATES = 4000, GROUP = 50 };
    static double length[GROUP], K_I[MOST * GROUP], K_II[MOST * GROUP], overlap[MOST * GROUP];
    static const double cell[] = {0, 0, 60, 3e-5, 0.6, 120, 50, 100, 12};
    const double dK_th = 40, C = 1e-11, law[] = {dK_th, 248, C, 2.7, HUGE_VAL};
    double x, sum = 0, I[GROUP], II[GROUP], K_max[GROUP], R[GROUP];
    const rwedge_cycle *cycle = cycle_of_row(cell, &x);
    for (size_t first = 0; first < RATES; first += GROUP) {
        for (size_t j = 0; j < GROUP; j++)
            length[j] = 0.03 * pow(100, ((double)(first + j) + 0.5) / RATES);
        assert_ok(rwedge_cycle_crack(cycle, x, 0, 12, GROUP, length, K_I, K_II, overlap));
        assert_ok(rwedge_crack_ranges(12, GROUP, K_I, K_II, RWEDGE_FACES_LOCKED, I, II, K_max, R));
        for (size_t j = 0; j < GROUP; j++) {
            const double threshold = rwedge_short_crack_threshold(length[j], dK_th, 248);
            sum += length[j] / (C * (pow(hypot(I[j], II[j]), 2.7) - pow(threshold, 2.7)));
        }
    }
    const growth g = growth_of(cycle, x, 0, RWEDGE_FACES_LOCKED, law, 0.03, 3);
    assert_close(g.cycles, sum * log(100) / RATES, 1e-5);
}

/* ---- Refusals ---- */

CLAIM(what_cannot_grow_is_refused)
{
    const rwedge_cycle *cycle = pulled(0.1);
    const double law[] = {1, 1, 1, 3, 1};
    const double wrong[][5] = {{-1, 1, 1, 3, 1}, {1, 0, 1, 3, 1},   {1, 1, 0, 3, 1},
                               {1, 1, 1, 0, 1},  {1, 1, 1, 101, 1}, {1, 1, 1, 3, 0}};
    double a = 7, b = 7, c = 7, d = 7;
#define GROW(x, angle, shear, constants, law, initial, final)                                      \
    rwedge_cycle_growth(cycle, x, angle, shear, constants, law, initial, final, &a, &b, &c, &d)
    for (size_t i = 0; i < 6; i++)
        assert_int_equal(GROW(0, 0, 0, 5, wrong[i], 1, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(NAN, 0, 0, 5, law, 1, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 1.4, 0, 5, law, 1, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 0, 3, 5, law, 1, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 0, 0, 5, law, 0, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 0, 0, 5, law, 1, HUGE_VAL), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 0, 0, 5, law, 2, 2), RWEDGE_EDOMAIN);
    assert_int_equal(GROW(0, 0, 0, 4, law, 1, 2), RWEDGE_ERANGE);
    assert_int_equal(GROW(0, 0, 0, 5, NULL, 1, 2), RWEDGE_ENULL);
    assert_true(a == 7 && b == 7 && c == 7 && d == 7);
}

CLAIM(cracks_that_cannot_be_are_refused)
{
    const rwedge_cycle *cycle = pulled(0.1);
    const double length[] = {1, 0};
    double a[4] = {7}, b[4] = {7}, c[4] = {7};
    assert_int_equal(rwedge_cycle_crack(cycle, 0, 0, 2, 2, length, a, b, c), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_crack(cycle, 0, 1.4, 2, 1, length, a, b, c), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_crack(cycle, NAN, 0, 2, 1, length, a, b, c), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_crack(cycle, 0, 0, 3, 1, length, a, b, c), RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_crack(cycle, 0, 0, 2, 1, length, a, b, NULL), RWEDGE_ENULL);
    assert_true(a[0] == 7 && b[0] == 7 && c[0] == 7);
}
