/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cracks whose faces press on each other, against another rule, limits and other instants. */
#include "crack/faces.h"
#include "histories.h"

#include <stdlib.h>

enum { MOST = 120 };

/* ---- Pressures and openings ---- */

static void destroy_faces(void *faces)
{
    rw_faces_destroy(faces);
}

/* Random: openings of a symmetric positive matrix B B' + 1, and K. */
static void fill(rw_faces *faces, uint64_t *state)
{
    const size_t n = faces->n;
    double B[20 * 20];
    for (size_t i = 0; i < n * n; i++)
        B[i] = random_between(state, -1, 1);
    for (size_t i = 0; i < 2 * n; i++)
        faces->influence[i] = random_between(state, 0, 1);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            double sum = i == k;
            for (size_t j = 0; j < n; j++)
                sum += B[i * n + j] * B[k * n + j];
            faces->influence[(2 + i) * n + k] = sum;
        }
    assert_ok(rw_faces_invert(faces));
}

CLAIM(no_place_overlaps_and_none_is_both_open_and_pressed)
{
    static rw_faces faces;
    uint64_t state = 11;
    const size_t n = 20;
    assert_ok(rw_faces_create(n, &faces));
    free_after_claim(&faces, destroy_faces);
    for (int trial = 0; trial < 300; trial++) {
        double given[22], K[2];
        fill(&faces, &state);
        const double middle = random_between(&state, -1, 1);
        for (size_t i = 0; i < n + 2; i++)
            given[i] = middle + random_between(&state, -1, 1);
        assert_ok(rw_faces_press(&faces, given, K));
        for (size_t i = 0; i < n + 2; i++) {
            double value = given[i];
            for (size_t k = 0; k < n; k++)
                value += faces.influence[i * n + k] * faces.pressure[k];
            if (i < 2)
                assert_within(K[i], value, 1e-11);
            else if (faces.is_closed[i - 2])
                assert_within(value, 0, 1e-11);
            else
                assert_true(value > -1e-11 && faces.pressure[i - 2] == 0);
            assert_true(i < 2 || faces.pressure[i - 2] >= 0);
        }
    }
}

/* ---- K ---- */

enum { X = 17, DEGREES, LENGTH, K_I, K_II };

static rwedge_contact *contact_before(const double cell[], rw_loads *last)
{
    rwedge_contact *contact = cell[0] == 0 ? create_flat(cell[1], cell[2], cell[3], cell[4])
                                           : create_wedge(cell[1], cell[2], cell[3], cell[4]);
    for (int i = 5; i < X - 4; i += 4)
        apply(contact, cell[i], cell[i + 1], cell[i + 2], cell[i + 3]);
    *last = (rw_loads){cell[X - 4], cell[X - 3], cell[X - 2], cell[X - 1]};
    return contact;
}

/* The other rule errs by 2e-4. Without contact of the faces K_I is up to 0.7 of K off. */
CLAIM(cracks_that_press_have_the_k_of_another_rule)
{
    reference table = reference_open("crack_closing.csv");
    size_t pressed = 0;
    while (reference_next(&table)) {
        const double *cell = table.cell, size = hypot(cell[K_I], cell[K_II]);
        rw_loads last;
        const rwedge_contact *contact = contact_before(cell, &last);
        const rwedge_cycle *cycle = cycle_of(contact, 1, &last);
        double I, II, closed;
        assert_ok(rwedge_cycle_closing_crack(cycle, cell[X], cell[DEGREES] * PI / 180, 1, 1,
                                             &cell[LENGTH], &I, &II, &closed));
        assert_within(I, cell[K_I], 2e-4 * size);
        assert_within(II, cell[K_II], 2e-4 * size);
        pressed += closed > 0;
    }
    assert_int_equal(table.row, 12);
    assert_int_equal(pressed, 9);
}

enum { LENGTHS = 12, ALL = 2 * LENGTHS };

typedef struct {
    double I[ALL], II[ALL], share[ALL];
} answers;

/* After the two loads, of the lengths from 0.02 to 4. */
static void ask(const rwedge_cycle *cycle, double x, double angle, double length[LENGTHS],
                answers *passing, answers *pressing)
{
    for (int j = 0; j < LENGTHS; j++)
        length[j] = 0.02 * pow(200, (double)j / (LENGTHS - 1));
    assert_ok(rwedge_cycle_crack(cycle, x, angle, 2, LENGTHS, length, passing->I, passing->II,
                                 passing->share));
    assert_ok(rwedge_cycle_closing_crack(cycle, x, angle, 2, LENGTHS, length, pressing->I,
                                         pressing->II, pressing->share));
}

/* Where the strain of the surface does not depend on the tension, this only adds to stresses. */
static rwedge_contact *untouched_by_tension(double f)
{
    rwedge_contact *contact = create(0.4, f);
    assert_ok(rwedge_contact_set_strain(contact, 0));
    return contact;
}

CLAIM(k_is_never_negative_and_the_same_where_no_face_overlaps)
{
    uint64_t state = 3;
    int same = 0, shut = 0;
    for (int trial = 0; trial < 20; trial++) {
        const double Q = random_between(&state, -0.45, 0.45), angle = random_between(&state, -1, 1);
        const rw_loads load[] = {{1, 0, Q, 0.1}, {1, 0, Q / 3, 0.1}};
        double length[LENGTHS];
        answers passing, pressing;
        rwedge_contact *contact = APPLY(untouched_by_tension(0.5), {1, 0, 0, 0.1}, {1, 0, Q, 0.1});
        const rwedge_cycle *cycle = cycle_of(contact, 2, load);
        ask(cycle, -rwedge_contact_half_width(contact), angle, length, &passing, &pressing);
        for (int i = 0; i < ALL; i++) {
            assert_true(pressing.I[i] >= 0 && pressing.share[i] >= 0 && pressing.share[i] <= 1);
            if (pressing.share[i] == 0) {
                assert_true(pressing.I[i] == passing.I[i] && pressing.II[i] == passing.II[i]);
                same++;
            }
            shut += pressing.share[i] > 0;
        }
    }
    assert_true(same > 100 && shut > 100);
}

CLAIM(a_crack_that_is_pressed_everywhere_has_no_k_but_that_of_its_shear)
{
    const rw_loads load[] = {{0, 0, 0, -0.1}, {0, 0, 0, -0.2}};
    const rwedge_cycle *cycle = cycle_of(create(0.4, 0.5), 2, load);
    double length[LENGTHS];
    answers passing, pressing;
    for (double angle = -1; angle < 1.1; angle += 0.25) {
        ask(cycle, 0, angle, length, &passing, &pressing);
        for (int i = 0; i < ALL; i++) {
            assert_true(pressing.I[i] == 0);
            if (angle == 0) {
                assert_close(pressing.share[i], 1, 1e-14);
                assert_within(pressing.II[i], passing.II[i], 1e-14 * fabs(passing.I[i]));
            }
        }
    }
}

/* P alone presses, the tension opens: a normal crack is open to the length l0 at which K_I is 0. A
 * longer one is that crack, its tip being pressed. */
CLAIM(a_crack_whose_tip_is_closed_is_the_shorter_one_that_ends_where_k_is_0)
{
    const rw_loads load = {1, 0, 0.3, 0};
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {1, 0, 0, 0}, {1, 0, 0.3, 0});
    const rwedge_cycle *cycle = cycle_of(contact, 1, &load);
    const double x = -rwedge_contact_half_width(contact);
    double low = 0.01, high = 10, I, II, share;
    for (int i = 0; i < 60; i++) {
        const double middle = sqrt(low * high);
        assert_ok(rwedge_cycle_crack(cycle, x, 0, 1, 1, &middle, &I, &II, &share));
        *(I > 0 ? &low : &high) = middle;
    }
    for (double ratio = 1.2; ratio < 6; ratio *= 1.5) {
        const double length = ratio * low;
        assert_ok(rwedge_cycle_closing_crack(cycle, x, 0, 1, 1, &length, &I, &II, &share));
        assert_true(I == 0);
        assert_within(share, 1 - 1 / ratio, 0.03); /* two places are as far apart */
    }
}

/* ---- Ranges and growth ---- */

typedef struct {
    double I[LENGTHS], II[LENGTHS], K_max[LENGTHS], R[LENGTHS];
} ranges;

static void ask_ranges(const rwedge_cycle *cycle, double x, double angle, int32_t shear,
                       const double length[LENGTHS], ranges *r)
{
    assert_ok(rwedge_cycle_closing_ranges(cycle, x, angle, shear, LENGTHS, length, r->I, r->II,
                                          r->K_max, r->R));
}

/* The stresses of a cycle of tension are straight between its two loads: 120 on the same way have
 * the same ranges, up to their step. */
CLAIM(the_instants_at_which_a_crack_closes_are_found)
{
    rw_loads load[MOST];
    for (int i = 0; i < MOST; i++)
        load[i] = (rw_loads){1, 0, 0.3, 0.25 - 0.5 * fabs(1 - 2 * (double)i / MOST)};
    const rw_loads ends[] = {load[0], load[MOST / 2]};
    rwedge_contact *contact = APPLY(untouched_by_tension(0.5), {1, 0, 0, 0}, {1, 0, 0.3, 0});
    const double x = -rwedge_contact_half_width(contact);
    const rwedge_cycle *coarse = cycle_of(contact, 2, ends), *fine = cycle_of(contact, MOST, load);
    double length[LENGTHS];
    ranges few, many;
    int closes = 0;
    for (int j = 0; j < LENGTHS; j++)
        length[j] = 0.02 * pow(200, (double)j / (LENGTHS - 1));
    for (double angle = -0.6; angle < 0.7; angle += 0.4) {
        ask_ranges(coarse, x, angle, RWEDGE_FACES_LOCKED, length, &few);
        ask_ranges(fine, x, angle, RWEDGE_FACES_LOCKED, length, &many);
        for (int j = 0; j < LENGTHS; j++) {
            const double step = sqrt(PI * length[j]) / MOST;
            assert_within(few.I[j], many.I[j], 2e-3 * many.I[j]);
            assert_within(few.II[j], many.II[j], 2 * step);
            assert_within(few.K_max[j], many.K_max[j], 2 * step);
            assert_true(few.R[j] >= 0);
            closes += few.R[j] == 0 && few.I[j] > 0 && few.II[j] > 1e-3;
        }
    }
    assert_true(closes > 10);
}

static const double LAW[] = {0.02, 0.5, 1e-3, 3, HUGE_VAL};

static double rate(double I, double II, double length)
{
    return LAW[2] *
           (pow(hypot(I, II), 3) - pow(rwedge_short_crack_threshold(length, LAW[0], LAW[1]), 3));
}

/* The rates at 720 lengths, by the rule of the middle of ln l. */
CLAIM(the_life_of_a_crack_that_closes_is_the_sum_of_its_rates)
{
    enum { GROUPS = 60 };
    const rw_loads load[] = {{1, 0, 0.3, 0.15}, {1, 0, 0.1, 0}, {1, 0, -0.3, -0.15}, {1, 0, 0, 0}};
    rwedge_contact *contact =
        APPLY(untouched_by_tension(0.5), {1, 0, 0, 0}, {1, 0, 0.3, 0.15}, {1, 0, -0.3, 0});
    const double x = -rwedge_contact_half_width(contact), first = 0.05, last = 1;
    const rwedge_cycle *cycle = cycle_of(contact, 4, load);
    for (int32_t shear = RWEDGE_FACES_LOCKED; shear <= RWEDGE_FACES_FREE; shear++) {
        double sum = 0, length[LENGTHS], arrest, cycles, least, at;
        ranges r;
        for (int i = 0; i < GROUPS; i++) {
            for (int j = 0; j < LENGTHS; j++)
                length[j] = first * pow(last / first, (i * LENGTHS + j + 0.5) / (GROUPS * LENGTHS));
            ask_ranges(cycle, x, -0.3, shear, length, &r);
            for (int j = 0; j < LENGTHS; j++)
                sum += length[j] / rate(r.I[j], r.II[j], length[j]);
        }
        assert_ok(rwedge_cycle_closing_growth(cycle, x, -0.3, shear, 5, LAW, first, last, &arrest,
                                              &cycles, &least, &at));
        assert_true(isinf(arrest));
        assert_close(cycles, sum * log(last / first) / (GROUPS * LENGTHS), 1e-5);
    }
}

/* ---- Refusals ---- */

CLAIM(cracks_that_cannot_close_are_refused)
{
    const rw_loads load[] = {{0, 0, 0, 0.1}, {0, 0, 0, -0.1}};
    const rwedge_cycle *cycle = cycle_of(create(0.4, 0.5), 2, load);
    const double length[] = {1, 0};
    double a[4] = {7}, b[4] = {7}, c[4] = {7}, d[4] = {7};
    assert_int_equal(rwedge_cycle_closing_crack(cycle, 0, 0, 2, 2, length, a, b, c),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_closing_crack(cycle, 0, 1.4, 2, 1, length, a, b, c),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_closing_crack(cycle, 0, 0, 3, 1, length, a, b, c), RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_closing_crack(cycle, 0, 0, 2, 1, length, a, NULL, c),
                     RWEDGE_ENULL);
#define RANGES(x, angle, shear, n)                                                                 \
    rwedge_cycle_closing_ranges(cycle, x, angle, shear, n, length, a, b, c, d)
    assert_int_equal(RANGES(NAN, 0, 0, 1), RWEDGE_EDOMAIN);
    assert_int_equal(RANGES(0, 1.4, 0, 1), RWEDGE_EDOMAIN);
    assert_int_equal(RANGES(0, 0, 3, 1), RWEDGE_EDOMAIN);
    assert_int_equal(RANGES(0, 0, 0, 2), RWEDGE_EDOMAIN);
    assert_int_equal(RANGES(0, 0, 0, SIZE_MAX), RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_closing_ranges(NULL, 0, 0, 0, 1, length, a, b, c, d),
                     RWEDGE_ENULL);
    assert_int_equal(rwedge_cycle_closing_growth(cycle, 0, 0, 0, 5, LAW, 2, 1, a, b, c, d),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_cycle_closing_growth(cycle, 0, 0, 0, 4, LAW, 1, 2, a, b, c, d),
                     RWEDGE_ERANGE);
    assert_true(a[0] == 7 && b[0] == 7 && c[0] == 7 && d[0] == 7);
}
