/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads without a closed form: rwedge_contact_allow_error(). */
#include "histories.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double F = 0.5;

/* theta = A = a = 1 */
static rwedge_contact *wedge(double tolerance)
{
    return allowing(create_wedge(1, 1, 1, F), tolerance);
}

/* A contact that lost its closed form: tension of more than 4 Q/(pi b). */
static rwedge_contact *computed(void)
{
    rwedge_contact *contact = APPLY(wedge(1e-4), {4, 0, 0, 0}, {4, 0, 0.5, 0.9});
    assert_true(rwedge_contact_error(contact) > 0);
    return contact;
}

CLAIM(nothing_is_computed_unless_it_is_allowed)
{
    rwedge_contact *contact = APPLY(wedge(0), {4, 0, 0, 0});
    refuse(contact, 4, 0, 0.5, 0.9, RWEDGE_EPATH);
    assert_int_equal(rwedge_contact_allow_error(contact, 1e-7), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_allow_error(contact, 0.1), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_allow_error(contact, NAN), RWEDGE_EDOMAIN);
    assert_nan(rwedge_contact_error(NULL));
    assert_true(rwedge_contact_error(contact) == 0);
}

static int sticking(const rwedge_contact *contact)
{
    double left[9], right[9], slip[9];
    const size_t n = rwedge_contact_zone_count(contact);
    int zones = 0;
    assert_ok(rwedge_contact_zones(contact, n, left, right, slip));
    for (size_t i = 0; i < n; i++)
        zones += slip[i] == 0;
    return zones;
}

/* An independent prototype of the same equations, each load in four parts
 * (tests/data/README.md). */
CLAIM(reference_histories)
{
    reference table = reference_open("history.csv");
    rwedge_contact *contact = NULL;
    double number = 0;
    int elsewhere = 0;
    while (reference_next(&table)) {
        const double *v = table.cell;
        if (v[0] != number) {
            number = v[0];
            contact = wedge(1e-5);
            const double sigma = number == 1 ? 0.6 : number == 3 ? 0.3 * sin(0.8) : 0;
            APPLY(contact, {0, 0, 0, sigma}, {4, 0, 0, sigma});
        }
        apply(contact, v[2], v[3], v[4], v[5]);
        double left, right, p, q;
        assert_ok(rwedge_contact_edges(contact, &left, &right));
        assert_within(left, v[6], 1e-12);
        assert_within(right, v[7], 1e-12);
        const double at[] = {-0.93, -0.6, 0.1, 0.55, 0.9}, m = (left + right) / 2;
        for (int i = 0; i < 5; i++) {
            const double x = m + (right - left) / 2 * at[i];
            assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
            assert_within(q, v[9 + i], 2e-5); /* the reference: 6e-5 where P changes */
        }
        if (number == 1)
            assert_within(rwedge_contact_dissipated_energy(contact), v[8], 3e-5);
        const double x[2] = {left + 1e-9, right - 1e-9}, y[2] = {0, 0};
        double sxx[2], syy[2], txy[2];
        assert_ok(rwedge_contact_stresses(contact, 2, x, y, sxx, syy, txy));
        assert_within(sxx[0], v[14], 2e-4);
        assert_within(sxx[1], v[15], 2e-4);
        assert_int_equal(sticking(contact), v[16]);
        const rw_patch stick = stick_zone_of(contact);
        const double off = fmax(fabs(stick.left - v[17]), fabs(stick.right - v[18]));
        assert_within(off, 0, 2e-2);
        elsewhere += off > 2e-5;
    }
    assert_in_range(elsewhere, 0, 4); /* where a slip zone has just begun, 0.3 to 0.6 % wide */
}

CLAIM(zones_cover_the_contact)
{
    rwedge_contact *contact = computed();
    double left[9], right[9], slip[9], from, to;
    const size_t n = rwedge_contact_zone_count(contact);
    assert_int_equal(rwedge_contact_zones(contact, n + 1, left, right, slip), RWEDGE_ERANGE);
    assert_ok(rwedge_contact_zones(contact, n, left, right, slip));
    assert_int_equal(n, 3);
    assert_ok(rwedge_contact_edges(contact, &from, &to));
    assert_true(left[0] == from && right[2] == to && right[0] == left[1] && right[1] == left[2]);
    /* tension drags the edges apart: they slip opposite ways */
    assert_true(slip[0] * slip[2] == -1 && slip[1] == 0);
    assert_ok(rwedge_contact_stick_zone(contact, &from, &to));
    assert_true(from == left[1] && to == right[1]);
    for (int side = 0; side < 3; side += 2) {
        double p, q, s;
        const double x = (left[side] + right[side]) / 2;
        assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
        assert_close(q, -slip[side] * F * p, 1e-9);
        assert_ok(rwedge_contact_slip(contact, 1, &x, &s));
        assert_true(s * slip[side] > 0);
    }
}

/* Of a contact in closed form they are the one patch that sticks and what is beside it. */
CLAIM(zones_of_a_closed_form)
{
    rwedge_contact *contact = wedge(0);
    double left[3], right[3], slip[3];
    assert_ok(rwedge_contact_zone_count(contact));
    assert_ok(rwedge_contact_zone_count(NULL));
    apply(contact, 4, 0, 0, 0);
    assert_int_equal(rwedge_contact_zone_count(contact), 1);
    apply(contact, 4, 0, 1, 0);
    assert_int_equal(rwedge_contact_zone_count(contact), 3);
    assert_ok(rwedge_contact_zones(contact, 3, left, right, slip));
    assert_true(slip[0] == -1 && slip[1] == 0 && slip[2] == -1);
    assert_true(right[1] == rwedge_contact_stick_half_width(contact));
    apply(contact, 4, 0, 2, 0);
    assert_ok(rwedge_contact_zones(contact, 1, left, right, slip));
    assert_true(slip[0] == -1);
}

CLAIM(full_sliding_and_separation_end_it)
{
    rwedge_contact *contact = computed(), *fresh = wedge(0);
    apply(contact, 4, 0, 2, 0.9);
    assert_true(rwedge_contact_error(contact) == 0);
    APPLY(fresh, {4, 0, 0, 0}, {4, 0, 2, 0});
    assert_same_shear(contact, fresh, 0);
    assert_same_shear(APPLY(computed(), {4, 0, -2, 0.9}), APPLY(fresh, {4, 0, -2, 0}), 0);
    contact = computed();
    apply(contact, 0, 0, 0, 0);
    assert_true(rwedge_contact_error(contact) == 0);
    assert_true(rwedge_contact_dissipated_energy(contact) > 0);
}

CLAIM(what_is_refused_leaves_what_was_computed)
{
    rwedge_contact *contact = computed(), *bare = wedge(1e-2);
    const contact_state before = state_of(contact);
    refuse(contact, 4, 0, 2.1, 0, RWEDGE_ESLIDING);
    refuse(contact, -4, 0, 0, 0, RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_restore(before.size, before.number, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_restore(before.size, NULL, &contact), RWEDGE_ENULL);
    assert_state(contact, before);
    assert_true(rwedge_contact_memory(contact) > 0);
    /* a patch that rounding leaves without a width */
    refuse(bare, 1e-40, 5e-41, 1e-41, 0, RWEDGE_ERANGE);
    APPLY(bare, {1e-30, 0, 0, 0}, {1e-30, 0, 1e-31, 2e-16});
    refuse(bare, 1e-33, 5e-34, 0, 0, RWEDGE_ERANGE);
    /* and one with too little for places inside of it */
    rwedge_contact *narrow = APPLY(wedge(1e-2), {1e-28, 5e-29, 0, 0});
    refuse(narrow, 1e-28, 5e-29, 1e-29, 1e-13, RWEDGE_ENOCONV);
}

/* Q alone, farther than all that was computed: the way there is forgotten. */
CLAIM(a_load_that_slips_past_all_that_was_computed_ends_it)
{
    rwedge_contact *contact = computed(), *direct = wedge(0);
    apply(contact, 4, 0, -0.4, -0.6);
    assert_true(rwedge_contact_error(contact) > 0);
    const double energy = rwedge_contact_dissipated_energy(contact);
    apply(contact, 4, 0, 1.7, 0.3);
    APPLY(direct, {4, 0, 0, 0}, {4, 0, 1.7, 0.3});
    assert_true(rwedge_contact_error(contact) == 0);
    assert_true(rwedge_contact_dissipated_energy(contact) > energy);
    assert_same_shear(contact, direct, 0);
    for (int i = -9; i <= 9; i++)
        assert_true(slip(contact, i / 5.0) == slip(direct, i / 5.0));
    apply(contact, 4, 0, 1.6, 0.9); /* and it is lost again */
    assert_true(rwedge_contact_error(contact) > 0);
}

/* Loads from which a straight line has another closed form than the history: nothing slips at its
 * end, or it slips back, or farther on both sides or on one. */
CLAIM(a_closed_form_that_slips_elsewhere_is_not_returned_to)
{
    static const double OTHER[][4] = {
        {3, 0, 1.4, 0.3}, {4, 0, 1.9, 0.3}, {4, 0, -1.9, -0.4}, {4, 0, -1.95, 0.3}};
    for (size_t i = 0; i < sizeof OTHER / sizeof *OTHER; i++) {
        rwedge_contact *contact = wedge(1e-2), *other = wedge(0), *direct = wedge(0);
        APPLY(contact, {4, 0, 0, 0}, {4, 0, 0.5, 0.9}, {4, 0, -0.4, -0.6});
        APPLY(other, {OTHER[i][0], 0, 0, 0}, {OTHER[i][0], OTHER[i][1], OTHER[i][2], OTHER[i][3]});
        rwedge_contact_destroy(contact->computed.exact);
        assert_ok(rwedge_contact_copy(other, &contact->computed.exact));
        apply(contact, 4, 0, 1.7, 0.3);
        APPLY(direct, {4, 0, 0, 0}, {4, 0, 1.7, 0.3});
        assert_true(rwedge_contact_error(contact) > 0);
        assert_same_shear(contact, direct, 1e-2 * F);
    }
}

/* The place of a corner was not kept where fronts that recede left many kinks, or after 11 cycles:
 * the traction was off by 2e-3, and 4e-7 was told. What sticks at the end never slipped, and all
 * else slips: that is the state of the straight line alone. */
CLAIM(slip_passes_the_corners_of_earlier_cycles)
{
    static const struct {
        int loads;
        double tolerance;
    } cases[] = {{1, 1e-6}, {3, 1e-6}, {14, 1e-5}, {20, 1e-5}, {60, 1e-5}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        rwedge_contact *contact = wedge(cases[k].tolerance), *direct = wedge(0);
        apply(contact, 4, 0, 0, 0);
        for (int i = 0; i < cases[k].loads; i++)
            apply(contact, 4, 0, (i % 2 ? -1 : 1) * (1.2 - 0.015 * i), 0);
        apply(contact, 4, 0, 0.5, 0.6);
        assert_true(rwedge_contact_error(contact) > 0);
        apply(contact, 4, 0, 1.7, 0.3);
        APPLY(direct, {4, 0, 0, 0}, {4, 0, 1.7, 0.3});
        assert_same_shear(contact, direct, 3 * cases[k].tolerance * F);
    }
}

/* A load that hardly changes anything, after more cycles than the fit has kinks for. */
CLAIM(a_contact_of_many_corners_keeps_its_traction)
{
    rwedge_contact *contact = APPLY(wedge(1e-3), {4, 0, 0, 0});
    for (int i = 0; i < 70; i++)
        apply(contact, 4, 0, (i % 2 ? -1 : 1) * (1.2 - 0.015 * i), 0);
    const rwedge_contact *before = copy_of(contact);
    apply(contact, 4, 0, contact->loads.Q, 1e-7);
    assert_true(rwedge_contact_error(contact) > 0);
    assert_same_shear(contact, before, 1e-3 * F);
}

/* What sticks moves until each place has slipped. */
CLAIM(errors_are_forgotten_where_it_slips)
{
    rwedge_contact *contact = APPLY(wedge(1e-3), {4, 0, 0, 0});
    for (int i = 0; i < 20; i++)
        apply(contact, 4, 0, 0.5 + 0.3 * sin(0.6 * i), 0.9 + 0.3 * sin(0.6 * i - 0.8));
    APPLY(contact, {4, 0, 1.6, 1.6}, {4, 0, -1.6, 1.6}, {4, 0, 1.6, -1.6});
    assert_true(rwedge_contact_error(contact) > 5e-4);
    apply(contact, 4, 0, -1.6, -1.6);
    assert_in_range(1e6 * rwedge_contact_error(contact), 1, 100);
}

CLAIM(yield_is_found)
{
    rwedge_contact *contact = computed();
    double factor, x, y;
    assert_ok(rwedge_contact_yield_factor(contact, 0.3, 1, &factor, &x, &y));
    const stresses s = stress_at(contact, x, y);
    assert_close(rwedge_von_mises(s.xx, s.yy, s.xy, 0.3) / sqrt(3), 1 / factor, 1e-9);
}

/* The bodies touch under a shear and a tension that do not grow in proportion to the contact. */
CLAIM(bodies_touch_under_shear_and_tension)
{
    rwedge_contact *whole = wedge(1e-4), *parts = wedge(1e-4);
    apply(whole, 4, 0.4, 0.8, 0.4);
    assert_true(rwedge_contact_error(whole) > 0);
    assert_ok(try_parts(parts, whole->loads, 20, NULL));
    assert_same_shear(whole, parts, 1e-3 * F);
}

/* A load that rocks the contact by more than its half-width, N and mm: what it sticks in is the
 * same to a tolerance and to a tenth of it. */
CLAIM(the_second_half_of_a_load_has_effort_left)
{
    rw_patch stick[2];
    for (int i = 0; i < 2; i++) {
        const double compliance = rwedge_compliance(72100, 0.33, 72100, 0.33);
        rwedge_contact *contact = create_wedge(0.05, 0.5, compliance, 0.3);
        assert_ok(rwedge_contact_allow_error(contact, i == 0 ? 1e-3 : 1e-4));
        APPLY(contact, {100, 5, 20, 0}, {100, 40, 20, 0});
        stick[i] = stick_zone_of(contact);
    }
    assert_within(stick[0].left, stick[1].left, 1e-4);
    assert_within(stick[0].right, stick[1].right, 1e-4);
}

/* Errors of the contact before were too large for the pressure of what is left: not converged. */
CLAIM(a_contact_that_shrinks_to_nearly_nothing_is_computed)
{
    rwedge_contact *whole = wedge(1e-4), *parts = wedge(1e-4);
    rwedge_contact *both[] = {whole, parts};
    for (int i = 0; i < 2; i++) {
        apply(both[i], 1, 0, 0, 0);
        apply(both[i], 1, 0.45, 0.1, 0.1);
    }
    apply(whole, 1e-3, 0, 0, 0);
    double ends[10]; /* P is halved each time */
    for (int i = 0; i < 10; i++)
        ends[i] = i == 9 ? 1 : (1 - ldexp(1, -1 - i)) / (1 - 1e-3);
    assert_ok(try_parts(parts, whole->loads, 10, ends));
    const double error = rwedge_contact_error(whole) + rwedge_contact_error(parts);
    assert_within(error, 0, 0.02);
    assert_same_shear(whole, parts, error * F * -pressure(whole, 0));
}

/* Tension alone, of many times what friction bears, as the bodies touch: it was refused. */
CLAIM(a_contact_under_great_tension_slips_both_ways_from_the_middle)
{
    rwedge_contact *contact = APPLY(wedge(1e-2), {4, 0, 0, 1e3});
    const double b = rwedge_contact_half_width(contact), error = rwedge_contact_error(contact);
    assert_within(error, 0, 0.12);
    for (int i = 1; i < 10; i++) {
        const double friction = F * pressure(contact, b * i / 10);
        assert_within(shear(contact, b * i / 10), -friction, -error * F * pressure(contact, 0));
        assert_within(shear(contact, -b * i / 10), friction, -error * F * pressure(contact, 0));
    }
}

/* The places that each load brought into contact kept elements of their own: 29000 numbers here,
 * and more with more loads. */
CLAIM(a_contact_that_grows_by_many_loads_stays_small)
{
    enum { LOADS = 600 };
    rwedge_contact *contact = APPLY(wedge(1e-3), {4, 0, 0, 0});
    for (int i = 1; i <= LOADS; i++) {
        const double part = (double)i / LOADS, phase = 6 * PI * part;
        const double P = 4 + 8 * part + 0.12 * sin(17 * phase);
        apply(contact, P, 0, 0.25 * P * sin(phase), 0.03 * sin(phase - 0.7));
    }
    assert_in_range(rwedge_contact_state_size(contact), 0, 12000);
}

/* ---- A log with noise of a fretting test: N, mm, MPa ---- */

/* A hundredth of a normal distribution. */
static double noise(uint64_t *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += random_fraction(state);
    return 0.01 * sum;
}

static const double P_LOGGED = 150;

static void apply_logged(rwedge_contact *contact, int load, uint64_t *state)
{
    const double wave = sin(2 * PI * load / 48), P = P_LOGGED * (1 + noise(state));
    const double Q = 0.3 * P_LOGGED * (wave + noise(state));
    apply(contact, P, 0, Q, 80 * (wave + noise(state)));
}

#ifdef __SANITIZE_ADDRESS__
size_t __sanitizer_get_current_allocated_bytes(void); /* gcc 12 has no header with it */
#endif

/* What the process holds now ("VmRSS:"), or held at most ("VmHWM:"), in kB, where the system tells;
 * else 0. The address sanitizer keeps what is freed, but knows what is not. */
static long process_memory(const char *which)
{
#ifdef __SANITIZE_ADDRESS__
    (void)which;
    return (long)(__sanitizer_get_current_allocated_bytes() / 1024);
#else
    FILE *status = fopen("/proc/self/status", "r");
    char line[256];
    long memory = 0;
    while (status && fgets(line, sizeof line, status))
        if (strncmp(line, which, strlen(which)) == 0)
            memory = strtol(line + strlen(which), NULL, 10);
    if (status)
        fclose(status);
    return memory;
#endif
}

/* The moment moves the contact by some roundings of its width, and the slip of these places is
 * tension times their way: it was kept in pieces that a double does not tell apart. */
CLAIM(a_contact_that_grows_by_some_roundings_stays_small)
{
    rwedge_contact *contact = allowing(create_wedge(0.3, 4.60932e-15, 1, 0.146444), 1e-2);
    APPLY(contact, {0.3142, 0, 0, 2.875e-5}, {0.3142, 3.013e-13, -0.03158, 0.3766});
    assert_true(rwedge_contact_error(contact) > 0);
    assert_in_range(rwedge_contact_state_size(contact), 0, 20000);
}

/* Under the second and third cycles. The first one is another one. */
static void yields_no_earlier(rwedge_contact *contact, size_t count, const rw_loads cycle[])
{
    double factor[12];
    assert_in_range(count, 1, 3);
    apply(contact, 100, 0, 0, 0);
    for (size_t k = 0; k < 4 * count; k++) {
        const rw_loads to = cycle[k % count];
        apply(contact, to.P, to.M, to.Q, to.sigma);
        assert_ok(rwedge_contact_yield_factor(contact, 0.33, 300, &factor[k], NULL, NULL));
        if (k >= 2 * count)
            assert_close(factor[k], factor[k - count], 2e-3);
    }
}

/* A front that comes back to where one has been, or nearly: the traction between both had a spike,
 * 1e-9 wide, of which no error was told. A contact yielded at a tenth of its loads. */
CLAIM(a_repeated_cycle_yields_no_earlier)
{
    static const struct {
        double flat, tolerance;
        rw_loads cycle[2];
    } cases[] = {{0, 1e-4, {{100, 0, 5, 20}, {100, 0, 40, 20}}},
                 {0.3, 1e-4, {{100, 0, 57, 20}, {100, 0, -54, 20}}},
                 {0.3, 1e-6, {{100, 0, 57, 20}, {100, 0, -54, 20}}},
                 {0.3, 1e-5, {{117.5, 0, 29.5, -45.5}, {68.8, 0, -5, 16.3}}}};
    const double compliance = rwedge_compliance(72100, 0.33, 72100, 0.33);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        yields_no_earlier(
            allowing(create_flat(cases[i].flat, 10, compliance, 0.8), cases[i].tolerance), 2,
            cases[i].cycle);
}

/* With fewer points no fronts were found, and the grid's answer was taken: its traction jumped by
 * 2e-3 of friction, and the contact yielded at half of its loads. */
CLAIM(a_cycle_whose_fronts_were_not_found_yields_no_earlier)
{
    const rw_loads cycle[] = {{77.5248, 0, -45.7127, 14.2886},
                              {100.509, 0, -65.8961, -8.55874},
                              {96.4743, 0, -24.9539, 45.2178}};
    rwedge_contact *contact =
        create_wedge(0.0136444, 0.372494, rwedge_compliance(72000, 0.3, 72000, 0.3), 1.17894);
    yields_no_earlier(allowing(contact, 1e-4), 3, cycle);
    assert_within(rwedge_contact_error(contact), 0, 1e-4);
}

/* The effort was spent before a short last part had fronts: it had the grid's answer, which erred
 * by 3 to 10 times the tolerance. */
CLAIM(a_load_that_takes_much_effort_keeps_its_tolerance)
{
    const double f = 0.630578, x[] = {-1.2, -0.4, 0.1, 0.5, 1},
                 slope[] = {-1.2, -0.2, -0.1, 0.5, 1.5};
    const double P = 0.328559, tolerance = 1e-4;
    const rw_loads last = {0.271799, 0.0158528, -0.125973, 0.120282};
    rwedge_contact *contact = create_profile(5, x, slope, f);
    APPLY(allowing(contact, tolerance), {0.298719, 0.00509261, 0, 0},
          {P, 0.0192882, f * P, 0.451606}, {0.286368, -0.000619896, -0.158171, -0.451434},
          {0.270181, 0.00452738, 0.0105093, -0.288556});
    rwedge_contact *parts = allowing(copy_of(contact), tolerance / 10);
    apply(contact, last.P, last.M, last.Q, last.sigma);
    assert_ok(try_parts(parts, last, 6, NULL));
    assert_within(rwedge_contact_error(contact), 0, tolerance);
    /* next to fronts q is like a root */
    assert_same_shear(contact, parts, 10 * tolerance * f * -pressure(contact, 0));
}

/* A number takes so many cycles. Where it sticks each load added to the error: 0.05 after 40
 * cycles, and 0.63 after 497, while q repeated to 1e-7. */
CLAIM(the_error_of_a_steady_cycle_stays)
{
    enum { LOADS = 12, EARLY = 3, PLACES = 41 };
    const int cycles = (int)cases_or(40);
    const double f = 0.5, P = 1.5;
    double early = 0, x[PLACES], p[PLACES], q[2][PLACES];
    rwedge_contact *wedge = allowing(create_wedge(1, 1, 1, f), 1e-3);
    apply(wedge, P, 0, 0, 0);
    const double b = rwedge_contact_half_width(wedge), limit = 4 * f * P / (PI * b);
    for (int k = 0; k < PLACES; k++)
        x[k] = b * (2.0 * (k + 1) / (PLACES + 1) - 1);
    for (int i = 1; i <= cycles * LOADS; i++) {
        const double phase = 2 * PI * i / LOADS;
        apply(wedge, P, 0, 0.6 * f * P * sin(phase), 1.2 * limit * cos(phase));
        if (i == EARLY * LOADS) {
            early = rwedge_contact_error(wedge);
            assert_ok(rwedge_contact_tractions(wedge, PLACES, x, p, q[0]));
        }
    }
    assert_within(rwedge_contact_error(wedge), early, 0.01 * early);
    assert_within(early, 0, 1e-3);
    assert_ok(rwedge_contact_tractions(wedge, PLACES, x, p, q[1]));
    for (int k = 0; k < PLACES; k++) /* that error is one of the true q, which repeats */
        assert_within(q[1][k], q[0][k], early * f * -p[PLACES / 2]);
}

/* A number takes so many loads; alone, as 10 MB are asked for then. The error was told where
 * nothing slips too: it grew to 1.7e-3 here, and to 12e-3 after 10000 loads. */
CLAIM(a_noisy_log_takes_no_more_memory_however_long_it_is_and_hardly_errs_more)
{
    const int usual = 600, loads = (int)cases_or(usual);
    uint64_t state = 1;
    long early = 0;
    rwedge_contact *contact =
        create_wedge(0.01, 0.3, rwedge_compliance(72e3, 0.33, 72e3, 0.33), 0.6);
    assert_ok(rwedge_contact_allow_error(contact, 1e-3));
    apply(contact, P_LOGGED, 0, 0, 0);
    for (int i = 0; i < loads; i++) {
        apply_logged(contact, i, &state);
        assert_in_range(rwedge_contact_state_size(contact), 0, 5000);
        if (i == loads / 10)
            early = process_memory("VmRSS:");
    }
    assert_in_range(process_memory("VmRSS:"), 0, early + 3000); /* freed memory lies in pieces */
    assert_within(rwedge_contact_error(contact), 0, 1e-3 + 3e-5 * sqrt(loads));
    if (loads > usual)
        assert_in_range(process_memory("VmHWM:"), 0, 10000);
    if (early == 0) {
        print_message("    the system does not tell how much memory the process holds\n");
        skip();
    }
}
