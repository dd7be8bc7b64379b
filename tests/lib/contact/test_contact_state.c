/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact as numbers. */
#include "histories.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST = 4096 };

static size_t state_of(const rwedge_contact *contact, double numbers[MOST])
{
    const size_t n = rwedge_contact_state_size(contact);
    assert_true(n <= MOST);
    assert_ok(rwedge_contact_state(contact, n, numbers));
    return n;
}

static rwedge_contact *restore(size_t n, const double numbers[])
{
    rwedge_contact *restored;
    assert_ok(rwedge_contact_restore(n, numbers, &restored));
    return restored;
}

static void assert_same(const rwedge_contact *one, const rwedge_contact *other)
{
    static double first[MOST], second[MOST];
    const size_t n = state_of(one, first);
    assert_int_equal(state_of(other, second), n);
    assert_memory_equal(first, second, n * sizeof *first);
}

/* Random histories, saved after each load. */
CLAIM(a_restored_contact_goes_on_to_the_same_bits)
{
    static double numbers[MOST];
    for (int number = 0; number < 40; number++) {
        random_history history, of_restored;
        rwedge_contact *contact = begin(&history, number);
        for (int i = 0; i < 6; i++) {
            rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
            assert_same(contact, restored);
            of_restored = history;
            go_on(&of_restored, restored);
            go_on(&history, contact);
            assert_same(contact, restored);
            const double x = 0.7 * rwedge_contact_half_width(contact);
            assert_true(shear(contact, x) == shear(restored, x) &&
                        slip(contact, x) == slip(restored, x));
            rwedge_contact_destroy(restored);
        }
        rwedge_contact_destroy(contact);
    }
}

CLAIM(moment_and_tension_are_in_it)
{
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    const double loads[][4] = {{0.5, 0.1, 0, 0}, {0.5, 0.1, 0.15, 0.02}, {0.45, 0.09, 0.15, 0.02}};
    for (size_t i = 0; i < sizeof loads / sizeof *loads; i++) {
        assert_ok(
            rwedge_contact_apply(contact, loads[i][0], loads[i][1], loads[i][2], loads[i][3]));
        rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
        assert_same(contact, restored);
        double P, M, Q, sigma;
        assert_ok(rwedge_contact_loads(restored, &P, &M, &Q, &sigma));
        assert_true(P == loads[i][0] && M == loads[i][1] && Q == loads[i][2] &&
                    sigma == loads[i][3]);
        rwedge_contact_destroy(restored);
    }
    rwedge_contact_destroy(contact);
}

/* Each number, changed; each length but the right one. */
CLAIM(damage_is_noticed)
{
    static double numbers[MOST];
    random_history history;
    rwedge_contact *contact = begin(&history, 3), *untouched = NULL;
    for (int i = 0; i < 5; i++)
        go_on(&history, contact);
    const size_t n = state_of(contact, numbers);
    for (size_t i = 0; i < n; i++) {
        const double kept = numbers[i];
        numbers[i] = isfinite(kept) ? nextafter(kept, 7) : 0;
        assert_int_equal(rwedge_contact_restore(n, numbers, &untouched), RWEDGE_EDOMAIN);
        numbers[i] = kept;
        assert_int_equal(rwedge_contact_restore(i, numbers, &untouched), RWEDGE_EDOMAIN);
    }
    assert_null(untouched);
    assert_int_equal(rwedge_contact_restore(n, NULL, &untouched), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_restore(n, numbers, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state(contact, n + 1, numbers), RWEDGE_ERANGE);
    assert_int_equal(rwedge_contact_state(NULL, n, numbers), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state(contact, n, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_state_size(NULL), 0);
    rwedge_contact_destroy(contact);
}

/* A state that was damaged on purpose, its sum of bits put right. */
static void sign(size_t n, double numbers[])
{
    uint64_t sum = 0xcbf29ce484222325;
    for (size_t i = 2; i < n; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        sum = (sum ^ bits) * 0x100000001b3 ^ (sum >> 29);
    }
    numbers[1] = (double)(sum >> 12);
}

/* Every function, within a second of the processor's time. */
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
    const rw_loads next[] = {{l.P, l.M, -l.Q, l.sigma},
                             {l.P, l.M, l.Q / 2, -l.sigma},
                             {1.1 * l.P, 1.1 * l.M, l.Q, l.sigma},
                             {l.P / 2, l.M / 2, l.Q / 2, l.sigma},
                             {0.5, 0, 0.01, 0},
                             {0, 0, 0, 0}};
    for (size_t i = 0; i < sizeof next / sizeof *next; i++) {
        (void)rwedge_contact_obstacle(contact, next[i].P, next[i].M, next[i].Q, next[i].sigma);
        (void)rwedge_contact_apply(contact, next[i].P, next[i].M, next[i].Q, next[i].sigma);
        (void)rwedge_contact_slip(contact, N, x, s);
    }
    assert_true(clock() - start < CLOCKS_PER_SEC);
}

static bool is_usable(size_t n, double numbers[])
{
    rwedge_contact *restored = NULL;
    sign(n, numbers);
    const int32_t status = rwedge_contact_restore(n, numbers, &restored);
    if (status != RWEDGE_OK) {
        assert_int_equal(status, RWEDGE_EDOMAIN);
        assert_null(restored);
        return false;
    }
    use(restored);
    rwedge_contact_destroy(restored);
    return true;
}

/* Of a contact, centred or not, that has slipped to and fro. */
static size_t worn_state(int number, double numbers[])
{
    random_history h;
    rwedge_contact *contact = begin(&h, number);
    const double b = 0.4, M = number % 3 == 0 ? 0 : 0.02 * (number % 5 - 2);
    for (int i = 0; i < 4 && M == 0; i++)
        go_on(&h, contact);
    apply(contact, 0, 0, 0, 0);
    apply(contact, b, M, 0, 0);
    for (int i = 0; i < 4; i++) {
        const double Q = h.f * b * (i % 2 ? -0.7 : 0.7) / (1 + 0.2 * i);
        (void)rwedge_contact_apply(contact, b, M, Q, number % 2 * 0.1 * Q);
    }
    const size_t n = state_of(contact, numbers);
    rwedge_contact_destroy(contact);
    return n;
}

static double mutated(double value, const double numbers[], size_t n, uint64_t *seed)
{
    const double draw = random_fraction(seed);
    const double other = numbers[(size_t)(random_fraction(seed) * (double)n)];
    switch ((int)(random_fraction(seed) * 8)) {
    case 0:
        return -value;
    case 1:
        return other;
    case 2:
        return value + other;
    case 3:
        return value * pow(10, 40 * draw - 20);
    case 4:
        return value * (1 + pow(10, -16 * draw));
    case 5:
        return floor(6 * draw) - 2;
    case 6:
        return pow(10, 400 * draw - 200);
    default:
        return value * (2 * draw - 0.5);
    }
}

/* Some once read beyond the memory, and some took minutes. */
CLAIM(mutants_are_refused_or_usable)
{
    static double numbers[MOST], mutant[MOST];
    uint64_t seed = 3;
    int usable = 0;
    const char *more = getenv("RWEDGE_MUTANTS");
    const int mutants = more ? atoi(more) : 150;
    for (int number = 0; number < mutants; number++) {
        const size_t n = worn_state(number % 60, numbers);
        assert_true(number >= 60 || is_usable(n, numbers));
        memcpy(mutant, numbers, n * sizeof *mutant);
        for (double k = 0; k < 3 * random_fraction(&seed); k++) {
            const size_t i = 2 + (size_t)(random_fraction(&seed) * (double)(n - 2));
            mutant[i] = mutated(mutant[i], numbers, n, &seed);
        }
        usable += is_usable(n, mutant);
    }
    assert_true(usable > mutants / 40 && usable < mutants / 2);
}

/* The stick zone was then sought before the first corner. */
CLAIM(a_path_of_one_corner_has_no_slope)
{
    double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    const size_t n = state_of(contact, numbers);
    for (size_t i = 2; i < n; i++) {
        double changed[MOST];
        memcpy(changed, numbers, sizeof changed);
        changed[i] = 1;
        (void)is_usable(n, changed);
    }
    rwedge_contact_destroy(contact);
}

CLAIM(damage_that_is_signed_does_no_harm)
{
    static const double BAD[] = {NAN, HUGE_VAL, -HUGE_VAL, -1, 0, 0.5, 1, 2, 1e300};
    static double numbers[MOST];
    rwedge_contact *centred = create(0.4, 0.5), *tilted = create(0.4, 0.5), *none = create(0.4, 0);
    load(centred, 0.5, 0);
    load(centred, 0.5, 0.1);
    load(centred, 0.7, 0.1);
    load(centred, 0.7, -0.1);
    apply(tilted, 0.5, 0.1, 0, 0);
    apply(tilted, 0.5, 0.1, 0.1, 0.01);
    const rwedge_contact *contacts[] = {centred, tilted, none};
    for (int k = 0; k < 3; k++) {
        const size_t n = state_of(contacts[k], numbers);
        for (size_t i = 2; i < n; i++) {
            const double kept = numbers[i];
            for (size_t j = 0; j < sizeof BAD / sizeof *BAD; j++) {
                numbers[i] = BAD[j];
                (void)is_usable(n, numbers);
            }
            numbers[i] = kept;
            (void)is_usable(i + 1, numbers);
        }
        (void)is_usable(n + 1, numbers);
    }
    const size_t n = state_of(none, numbers);
    numbers[2] = 1e-50; /* theta */
    numbers[4] = 1e50;  /* A: each is in the domain, theta/A is not */
    (void)is_usable(n, numbers);
    rwedge_contact_destroy(centred);
    rwedge_contact_destroy(tilted);
    rwedge_contact_destroy(none);
}

/* A state of the first version, which did not hold the strain, is that of equal compliances. Since
 * the third, what is no wedge is after the energy, and what has no closed form at the end. */
CLAIM(older_states_are_read)
{
    /* its place; that of three numbers of the pad; numbers at the end */
    enum { STRAIN = 2 + 13, PAD = STRAIN + 2, END = 2 };
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    load(contact, 0.5, 0.1);
    const size_t n = state_of(contact, numbers) - 3;
    memmove(numbers + PAD, numbers + PAD + 3, (n - PAD) * sizeof *numbers);
    numbers[0] = 2;
    sign(n - END, numbers);
    rwedge_contact *restored = restore(n - END, numbers);
    assert_same(restored, contact);
    rwedge_contact_destroy(restored);
    memmove(numbers + STRAIN, numbers + STRAIN + 1, (n - STRAIN - 1) * sizeof *numbers);
    numbers[0] = 1;
    sign(n - 1 - END, numbers);
    restored = restore(n - 1 - END, numbers);
    assert_same(restored, contact);
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(contact);
}

CLAIM(the_strain_is_in_it)
{
    static double numbers[MOST];
    rwedge_contact *contact = create(0.4, 0.5);
    assert_ok(rwedge_contact_set_strain(contact, A));
    rwedge_contact *restored = restore(state_of(contact, numbers), numbers);
    load(contact, 1, 0);
    load(restored, 1, 0);
    assert_true(rwedge_contact_largest_tension_step(restored, 0.1) ==
                rwedge_contact_largest_tension_step(contact, 0.1));
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(contact);
}
