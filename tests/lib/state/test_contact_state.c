/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact as numbers. */
#include "histories.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Of a shear without a closed form. */
static rwedge_contact *computed(double P)
{
    rwedge_contact *contact =
        APPLY(allowing(create(0.4, 0.5), 1e-2), {P, 0, 0, 0}, {P, 0, 0.1, 0.9});
    assert_true(rwedge_contact_error(contact) > 0);
    return contact;
}

/* A copy, and what is restored, go on to the same bits; what becomes of them is nothing to it. */
static void assert_twins(rwedge_contact *contact, rw_loads next)
{
    const contact_state before = state_of(contact);
    rwedge_contact *twins[] = {copy_of(contact), restored(before)};
    for (int i = 0; i < 2; i++) {
        assert_state(twins[i], before);
        apply_all(twins[i], 1, &next);
    }
    assert_state(contact, before);
    apply_all(contact, 1, &next);
    const double x =
        rw_patch_middle(edges_of(contact)) + 0.7 * rw_patch_half_width(edges_of(contact));
    for (int i = 0; i < 2; i++) {
        assert_state(twins[i], state_of(contact));
        assert_true(shear(contact, x) == shear(twins[i], x) &&
                    slip(contact, x) == slip(twins[i], x));
    }
}

CLAIM(twins_go_on_to_the_same_bits)
{
    for (int number = 0; number < 40; number++) {
        random_history h;
        rwedge_contact *ahead = begin(&h, number), *contact = copy_of(ahead);
        for (int i = 0; i < 6; i++) {
            go_on(&h, ahead);
            assert_twins(contact, ahead->loads);
        }
    }
    const double x[] = {-1, -0.4, 0.1, 0.5, 0.8}, slope[] = {-0.1, -0.02, -0.02, 0.05, 0.12};
    rwedge_contact *pads[] = {create_flat(0, 10, A, 0.5), create_flat(0.4, 10, A, 0.5),
                              create_profile(5, x, slope, 0.5)};
    for (int i = 0; i < 3; i++)
        assert_twins(APPLY(pads[i], {0.2, 0.01, 0, 0}, {0.2, 0.01, 0.05, 0}),
                     (rw_loads){0.2, 0.01, -0.02, 0});
    assert_twins(computed(0.5), (rw_loads){0.52, 0.02, -0.03, 0.4});
    rwedge_contact *unlike = create(0.4, 0.5); /* in compliance */
    assert_ok(rwedge_contact_set_strain(unlike, A));
    assert_twins(APPLY(unlike, {0.5, 0, 0, 0}, {0.5, 0, 0.1, 0.01}), (rw_loads){0.5, 0, 0.2, 0.02});
}

/* Its edges and those of its loads may differ by a unit of the last place. It was refused. */
CLAIM(a_contact_whose_first_load_is_computed_is_restored)
{
    assert_twins(APPLY(allowing(create_wedge(1, 1, 1, 0.5), 1e-2), {2, 0, 0.2, 0.05}),
                 (rw_loads){4, 0, 0.4, 0.1});
}

/* ---- States of earlier versions ---- */

/* The columns of tests/data/state-*.csv. */
enum {
    COLUMN_KIND = 1,
    COLUMN_PAD,
    COLUMN_STRAIN = 7,
    COLUMN_TOLERANCE,
    COLUMN_ERROR,
    COLUMN_X,
    COLUMN_P = 15,
    COLUMN_Q = 20,
    COLUMN_SIZE = 25
};

static void assert_pad(const rwedge_contact *contact, const double row[])
{
    double told[5];
    assert_int_equal(rwedge_contact_kind(contact), (int)row[COLUMN_KIND]);
    assert_ok(rwedge_contact_pad(contact, &told[0], &told[1], &told[2], &told[3], &told[4]));
    for (int i = 0; i < 5; i++)
        assert_true(told[i] == row[COLUMN_PAD + i]);
    assert_close(rwedge_contact_strain(contact), row[COLUMN_STRAIN], 1e-15);
    assert_true(rwedge_contact_tolerance(contact) == row[COLUMN_TOLERANCE]);
}

static size_t restore_all(const char *name)
{
    reference table = reference_open(name);
    while (reference_next(&table)) {
        const double *row = table.cell;
        rwedge_contact *contact =
            restored((contact_state){(size_t)row[COLUMN_SIZE], table.cell + COLUMN_SIZE + 1});
        double p[5], q[5];
        assert_pad(contact, row);
        assert_true(rwedge_contact_error(contact) == row[COLUMN_ERROR]);
        assert_ok(rwedge_contact_tractions(contact, 5, row + COLUMN_X, p, q));
        for (int i = 0; i < 5; i++)
            assert_true(p[i] == row[COLUMN_P + i] && q[i] == row[COLUMN_Q + i]);
    }
    return table.row;
}

/* Version 1.0.0 had no states. */
CLAIM(contacts_of_earlier_versions_are_restored)
{
    assert_int_equal(restore_all("state-1.1.0.csv"), 4);
    assert_int_equal(restore_all("state-1.2.0.csv"), 11);
}

/* Each number, changed; each length but the right one. */
CLAIM(damage_is_noticed)
{
    random_history history;
    rwedge_contact *contact = begin(&history, 3), *untouched = NULL;
    for (int i = 0; i < 5; i++)
        go_on(&history, contact);
    const contact_state s = state_of(contact);
    for (size_t i = 0; i < s.size; i++) {
        const double kept = s.number[i];
        s.number[i] = isfinite(kept) ? nextafter(kept, 7) : 0;
        assert_int_equal(rwedge_contact_restore(s.size, s.number, &untouched), RWEDGE_EDOMAIN);
        s.number[i] = kept;
        assert_int_equal(rwedge_contact_restore(i, s.number, &untouched), RWEDGE_EDOMAIN);
    }
    assert_null(untouched);
    assert_int_equal(rwedge_contact_state(contact, s.size + 1, s.number), RWEDGE_ERANGE);
    assert_ok(rwedge_contact_state_size(NULL));
}

/* A state that was damaged on purpose, its sum of bits put right. */
static void sign(contact_state s)
{
    uint64_t sum = 0xcbf29ce484222325;
    for (size_t i = 2; i < s.size; i++) {
        uint64_t bits;
        memcpy(&bits, &s.number[i], sizeof bits);
        sum = (sum ^ bits) * 0x100000001b3 ^ (sum >> 29);
    }
    s.number[1] = (double)(sum >> 12);
}

/* Every function, within seconds of the processor's time, also where nothing is optimised. */
static void use(rwedge_contact *contact)
{
    enum { N = 9 };
    const clock_t start = clock();
    double left = -1, right = 1, x[N], y[N], p[N], q[N], s[N], factor;
    (void)rwedge_contact_edges(contact, &left, &right);
    for (int i = 0; i < N; i++) {
        x[i] = left + i * ((right - left) / (N - 1));
        y[i] = i % 2 * (right - left) / 4;
    }
    x[N - 1] = right;
    (void)rwedge_contact_stick_zone(contact, &left, &right);
    (void)rwedge_contact_edge_asymptotes(contact, p, q, p + 1, q + 1);
    (void)rwedge_contact_memory(contact);
    (void)rwedge_contact_tractions(contact, N, x, p, q);
    (void)rwedge_contact_slip(contact, N, x, s);
    (void)rwedge_contact_stresses(contact, N, x, y, p, q, s);
    (void)rwedge_contact_yield_factor(contact, 0.3, 1, &factor, NULL, NULL);
    const rw_loads l = contact->loads;
    const rw_loads next[] = {{l.P, l.M, -l.Q, -l.sigma},
                             {1.1 * l.P, 1.1 * l.M, l.Q, l.sigma},
                             {l.P / 2, l.M / 2, l.Q / 2, l.sigma},
                             {0, 0, 0, 0}};
    (void)rwedge_contact_obstacle(contact, l.P / 2, l.M, l.Q, l.sigma);
    for (size_t i = 0; i < sizeof next / sizeof *next; i++) {
        (void)rwedge_contact_apply(contact, next[i].P, next[i].M, next[i].Q, next[i].sigma);
        (void)rwedge_contact_slip(contact, N, x, s);
    }
    assert_true(clock() - start < 5 * CLOCKS_PER_SEC);
}

/* NULL where it is refused. */
static rwedge_contact *signed_and_restored(contact_state s)
{
    rwedge_contact *contact = NULL;
    sign(s);
    const int32_t status = rwedge_contact_restore(s.size, s.number, &contact);
    assert_int_equal(status, contact ? RWEDGE_OK : RWEDGE_EDOMAIN);
    return contact;
}

static bool is_usable(contact_state s)
{
    rwedge_contact *contact = signed_and_restored(s);
    if (contact)
        use(owned(contact));
    return contact;
}

/* Of a contact, centred or not, that has slipped to and fro. */
static contact_state worn_state(int number)
{
    random_history h;
    rwedge_contact *contact = begin(&h, number);
    const double b = 0.4, M = number % 3 == 0 ? 0 : 0.02 * (number % 5 - 2);
    for (int i = 0; i < 4 && M == 0; i++)
        go_on(&h, contact);
    APPLY(contact, {0, 0, 0, 0}, {b, M, 0, 0});
    for (int i = 0; i < 4; i++) {
        const double Q = h.f * b * (i % 2 ? -0.7 : 0.7) / (1 + 0.2 * i);
        (void)rwedge_contact_apply(contact, b, M, Q, number % 2 * 0.1 * Q);
    }
    return state_of(contact);
}

static double mutated(double value, contact_state s, uint64_t *seed)
{
    const double draw = random_fraction(seed);
    const double other = s.number[(size_t)(random_fraction(seed) * (double)s.size)];
    const double mutants[] = {-value,
                              other,
                              value + other,
                              value * pow(10, 40 * draw - 20),
                              value * (1 + pow(10, -16 * draw)),
                              floor(6 * draw) - 2,
                              pow(10, 400 * draw - 200),
                              value * (2 * draw - 0.5)};
    return mutants[(int)(random_fraction(seed) * 8)];
}

/* Some once read beyond the memory, and some took minutes. */
CLAIM(mutants_are_refused_or_usable)
{
    enum { MUTANTS = 150, WORN = 60 };
    uint64_t seed = 3;
    int usable = 0;
    for (int number = 0; number < MUTANTS; number++) {
        const contact_state worn = worn_state(number % WORN), mutant = worn_state(number % WORN);
        assert_true(number >= WORN || is_usable(worn));
        for (double k = 0; k < 3 * random_fraction(&seed); k++) {
            const size_t i = 2 + (size_t)(random_fraction(&seed) * (double)(worn.size - 2));
            mutant.number[i] = mutated(mutant.number[i], worn, &seed);
        }
        usable += is_usable(mutant);
    }
    assert_true(usable > MUTANTS / 40 && usable < MUTANTS / 2);
}

static bool is_restored(contact_state s)
{
    rwedge_contact *contact = signed_and_restored(s);
    rwedge_contact_destroy(contact);
    return contact;
}

/* Each number in turn, and each length. How many damaged states are taken. (Of a path of one
 * corner, which has no slope, the stick zone was sought before the first.) */
static size_t damage_all(contact_state s, bool (*is_taken)(contact_state s))
{
    static const double BAD[] = {NAN, -HUGE_VAL, -1, 0, 0.25, 1, 2, 1e300, HUGE_VAL};
    size_t taken = 0;
    for (size_t i = 2; i < s.size; i++) {
        const double kept = s.number[i];
        for (size_t j = 0; j < sizeof BAD / sizeof *BAD; j++) {
            s.number[i] = BAD[j];
            taken += is_taken(s);
        }
        s.number[i] = kept;
        if (i + 1 < s.size)
            taken += is_taken((contact_state){i + 1, s.number});
    }
    return taken + is_taken((contact_state){s.size + 1, s.number});
}

CLAIM(damage_that_is_signed_does_no_harm)
{
    rwedge_contact *centred = create(0.4, 0.5), *tilted = create(0.4, 0.5), *none = create(0.4, 0);
    APPLY(centred, {0.5, 0, 0, 0}, {0.5, 0, 0.1, 0}, {0.7, 0, 0.1, 0}, {0.7, 0, -0.1, 0});
    APPLY(tilted, {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.1, 0.01});
    (void)damage_all(state_of(create(0.4, 0.5)), is_usable);
    (void)damage_all(state_of(centred), is_usable);
    (void)damage_all(state_of(tilted), is_usable);
    (void)damage_all(state_of(APPLY(create_flat(0.4, 10, A, 0.5), {0.2, 0.03, 0, 0})), is_usable);
    const contact_state s = state_of(none);
    (void)damage_all(s, is_usable);
    s.number[2] = 1e-50; /* theta */
    s.number[4] = 1e50;  /* A: each is in the domain, theta/A is not */
    (void)is_usable(s);
}

/* Of ten changes to each number. Most numbers of a traction may be any. */
CLAIM(damage_to_what_is_computed_is_refused_or_taken)
{
    const contact_state computed_shear = state_of(computed(0.5)),
                        pad = state_of(APPLY(create_flat(1, 2, A, 0.5), {0.5, 0, 0.1, 0}));
    assert_true(damage_all(computed_shear, is_restored) < 5 * computed_shear.size);
    assert_true(damage_all(pad, is_restored) < 3 * pad.size);
}

/* Twelve zones that stick, side by side, were more than there was room for on the stack. */
CLAIM(zones_of_one_label_side_by_side_are_refused)
{
    rwedge_contact *contact = computed(0.5);
    const contact_state s = state_of(contact);
    const rw_zones *zones = &contact->computed.now->now.shear.zones;
    size_t first = 0; /* the first zone: its ends and label */
    while (s.number[first] != zones->zone[0].left || s.number[first + 1] != zones->zone[0].right)
        first++;
    assert_true(is_restored(s));
    s.number[first + 2] = s.number[first + 5];
    assert_false(is_restored(s));
}

/* What is computed goes with a contact that holds no other shear, and has its edges. */
CLAIM(a_shear_of_another_contact_is_refused)
{
    rwedge_contact *bare = create(0.4, 0.5), *sheared = create(0.4, 0.5),
                   *layered = create(0.4, 0.5), *other = create(0.4, 0.5);
    load(bare, 0.5, 0);
    load(sheared, 0.5, 0.1);
    APPLY(layered, {0.3, 0, 0, 0}, {0.5, 0, 0.05, 0});
    load(other, 0.6, 0);
    const contact_state whole = state_of(computed(0.5));
    enum { END = 8 }; /* numbers of what is computed, and of what follows */
    const size_t from = rwedge_contact_state_size(bare) - END;
    const rwedge_contact *hosts[] = {bare, sheared, layered, other};
    for (int i = 0; i < 4; i++) {
        const contact_state host = state_of(hosts[i]);
        contact_state joint = {host.size - END + whole.size - from, NULL};
        joint.number = malloc(joint.size * sizeof *joint.number);
        assert_non_null(joint.number);
        memcpy(joint.number, host.number, (host.size - END) * sizeof *joint.number);
        memcpy(joint.number + host.size - END, whole.number + from,
               (whole.size - from) * sizeof *joint.number);
        assert_true(is_restored(joint) == (i == 0));
        free(joint.number);
    }
}

/* Takes numbers out of a state, in front of those up to `end`. */
static void leave_out(const contact_state *s, size_t at, size_t count, size_t end)
{
    for (size_t i = at; i < end; i++)
        s->number[i] = s->number[i + count];
}

/* A state of the first version, which did not hold the strain, is that of equal compliances. Since
 * the third, what is no wedge is after the energy, and what has no closed form at the end; since
 * the fifth, beta stands behind the pad, and how it is held and driven at the end. */
CLAIM(older_states_are_read)
{
    /* its place; that of three numbers of the pad and one of the bodies; numbers at the end */
    enum { STRAIN = 2 + 13, PAD = STRAIN + 2, OF_PAD = 3, END = 4 };
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {0.5, 0, 0.1, 0});
    contact_state s = state_of(contact);
    s.size -= 7; /* beta, whether the pad is held, and five numbers of a rig */
    leave_out(&s, PAD + OF_PAD, 1, s.size);
    s.number[0] = 4;
    sign(s);
    assert_state(restored(s), state_of(contact));
    s.size -= OF_PAD + END - 1;
    leave_out(&s, PAD, OF_PAD, s.size + END);
    s.number[0] = 2;
    sign(s);
    assert_state(restored(s), state_of(contact));
    s.size--;
    leave_out(&s, STRAIN, 1, s.size + END);
    s.number[0] = 1;
    sign(s);
    assert_state(restored(s), state_of(contact));
}
