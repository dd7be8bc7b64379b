/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact refuses; a refusal leaves it unchanged. Copies; lack of memory. This is linked
 * with
 * --wrap for malloc, calloc and realloc, because a compiler may make a calloc() of a malloc(). */
#include "histories.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* ---- Memory that runs short ---- */

/* How many allocations succeed before one fails; negative: all do. */
static int allocations_left = -1;

void *__real_malloc(size_t size);
void *__real_calloc(size_t number, size_t size);
void *__real_realloc(void *block, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t number, size_t size);
void *__wrap_realloc(void *block, size_t size);

static bool is_granted(void)
{
    if (allocations_left < 0)
        return true;
    return allocations_left-- > 0;
}

void *__wrap_malloc(size_t size)
{
    return is_granted() ? __real_malloc(size) : NULL;
}

void *__wrap_calloc(size_t number, size_t size)
{
    return is_granted() ? __real_calloc(number, size) : NULL;
}

void *__wrap_realloc(void *block, size_t size)
{
    return is_granted() ? __real_realloc(block, size) : NULL;
}

/* All that can be seen of a contact. */
typedef struct {
    double half_width, stick, energy, memory;
    double p[9], q[9], slip[9], sxx[9], syy[9], txy[9];
} appearance;

static appearance look(const rwedge_contact *contact)
{
    appearance seen;
    memset(&seen, 0, sizeof seen);
    seen.half_width = rwedge_contact_half_width(contact);
    seen.stick = rwedge_contact_stick_half_width(contact);
    seen.energy = rwedge_contact_dissipated_energy(contact);
    seen.memory = (double)rwedge_contact_memory(contact);
    double x[9], y[9];
    for (int i = 0; i < 9; i++) {
        x[i] = seen.half_width * (i - 4.1) / 5;
        y[i] = 0.1 * i;
    }
    assert_ok(rwedge_contact_tractions(contact, 9, x, seen.p, seen.q));
    assert_ok(rwedge_contact_slip(contact, 9, x, seen.slip));
    assert_ok(rwedge_contact_stresses(contact, 9, x, y, seen.sxx, seen.syy, seen.txy));
    return seen;
}

static void assert_looks(const rwedge_contact *contact, const appearance *before)
{
    const appearance now = look(contact);
    assert_memory_equal(&now, before, sizeof now);
}

static void a_load_without_memory_leaves_the_contact_as_it_was(void **state)
{
    int refused = 0;
    for (int number = 1; number <= 20; number++) {
        random_history h;
        rwedge_contact *contact = begin(&h, number);
        for (int step = 0; step < 15; step++) {
            random_history next = h;
            rwedge_contact *copy = NULL;
            assert_ok(rwedge_contact_copy(contact, &copy));
            go_on(&next, copy); /* what the load will be, and give */
            const appearance before = look(contact), after = look(copy);
            int32_t status = RWEDGE_ENOMEM;
            for (int granted = 0; status != RWEDGE_OK; granted++) {
                allocations_left = granted;
                status = rwedge_contact_load(contact, next.P, next.Q);
                allocations_left = -1;
                if (status == RWEDGE_OK)
                    break;
                refused++;
                assert_int_equal(status, RWEDGE_ENOMEM);
                assert_looks(contact, &before);
            }
            assert_looks(contact, &after);
            rwedge_contact_destroy(copy);
            h = next;
        }
        rwedge_contact_destroy(contact);
    }
    assert_true(refused > 20);
}

static void creating_and_copying_without_memory_says_so(void **state)
{
    random_history h;
    rwedge_contact *contact = begin(&h, 3), *other = NULL;
    for (int step = 0; step < 15; step++)
        go_on(&h, contact);
    int refused = 0;
    for (int granted = 0;; granted++) {
        allocations_left = granted;
        const int32_t status = rwedge_contact_copy(contact, &other);
        allocations_left = -1;
        if (status == RWEDGE_OK)
            break;
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_null(other);
        refused++;
    }
    assert_true(refused >= 3);
    rwedge_contact_destroy(other);
    other = NULL;
    for (int granted = 0; granted < 2; granted++) {
        allocations_left = granted;
        const int32_t status = rwedge_contact_create(THETA, 1, A, 0.5, &other);
        allocations_left = -1;
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_null(other);
    }
    rwedge_contact_destroy(contact);
    rwedge_contact_destroy(NULL);
}

/* ---- Moment and tension without memory ---- */

enum { NUMBERS = 256 };

static size_t numbers_of(const rwedge_contact *contact, double numbers[NUMBERS])
{
    const size_t n = rwedge_contact_state_size(contact);
    assert_true(n <= NUMBERS);
    assert_ok(rwedge_contact_state(contact, n, numbers));
    return n;
}

static void assert_numbers(const rwedge_contact *contact, const double before[], size_t n)
{
    double now[NUMBERS];
    assert_int_equal(numbers_of(contact, now), n);
    assert_memory_equal(now, before, n * sizeof *now);
}

static const double STEPS[][4] = {{0.5, 0.1, 0, 0},
                                  {0.5, 0.1, 0.1, 0.01},
                                  {0.5, 0.1, -0.05, 0},
                                  {0.6, 0.12, -0.05, 0},
                                  {0.6, 0.12, 0.02, 0.01}};
enum { STEP_COUNT = sizeof STEPS / sizeof *STEPS };

static void steps_off_centre_without_memory_leave_the_contact_as_it_was(void **state)
{
    rwedge_contact *contact = create(0.4, 0.5);
    int refused = 0;
    for (int i = 0; i < STEP_COUNT; i++) {
        const double *s = STEPS[i];
        double before[NUMBERS];
        const size_t n = numbers_of(contact, before);
        int32_t status = RWEDGE_ENOMEM;
        for (int granted = 0; status != RWEDGE_OK; granted++, refused++) {
            assert_int_equal(status, RWEDGE_ENOMEM);
            assert_numbers(contact, before, n);
            allocations_left = granted;
            status = rwedge_contact_apply(contact, s[0], s[1], s[2], s[3]);
            allocations_left = -1;
        }
    }
    assert_true(refused > 2 * STEP_COUNT);
    rwedge_contact_destroy(contact);
}

static void a_stress_history_without_memory_leaves_the_contact_as_it_was(void **state)
{
    rwedge_contact *contact = create(0.4, 0.5);
    double P[STEP_COUNT], M[STEP_COUNT], Q[STEP_COUNT], sigma[STEP_COUNT], before[NUMBERS];
    for (int i = 0; i < STEP_COUNT; i++) {
        P[i] = STEPS[i][0];
        M[i] = STEPS[i][1];
        Q[i] = STEPS[i][2];
        sigma[i] = STEPS[i][3];
    }
    const double x = 0.1, y = 0.2;
    double sxx[STEP_COUNT], syy[STEP_COUNT], txy[STEP_COUNT];
    const size_t n = numbers_of(contact, before);
    int32_t status = RWEDGE_ENOMEM;
    int refused = 0;
    for (int granted = 0; status != RWEDGE_OK; granted++, refused++) {
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_numbers(contact, before, n);
        allocations_left = granted;
        status = rwedge_contact_stress_history(contact, STEP_COUNT, P, M, Q, sigma, 1, &x, &y, sxx,
                                               syy, txy);
        allocations_left = -1;
    }
    assert_true(refused > 6);
    rwedge_contact_destroy(contact);
}

static int32_t worst_and_friction(const rwedge_contact *contact, double out[6])
{
    const double P[] = {0.6, 0.5}, M[] = {0, 0}, Q[] = {0.1, -0.1}, sigma[] = {0, 0}, x = 0.2,
                 value = 1e-9;
    const int32_t status =
        rwedge_contact_cycle_worst(contact, RWEDGE_MEASURE_STRESS_RANGE, 2, P, M, Q, sigma, 1, &x,
                                   &value, 0, 70, 0.3, 0, 0.4, 1, &out[0], &out[1]);
    return status != RWEDGE_OK ? status
                               : rwedge_contact_cycle_friction(contact, 2, P, M, Q, sigma, 1, &x,
                                                               &out[2], &out[3], &out[4], &out[5]);
}

static void a_cycle_without_memory_says_so(void **state)
{
    rwedge_contact *contact = create(0.4, 0.5);
    double out[6] = {7, 7, 7, 7, 7, 7};
    int32_t status = RWEDGE_ENOMEM;
    int refused = 0;
    load(contact, 0.5, 0);
    for (int granted = 0; status != RWEDGE_OK; granted++, refused++) {
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_true(out[5] == 7);
        allocations_left = granted;
        status = worst_and_friction(contact, out);
        allocations_left = -1;
    }
    assert_true(refused > 12);
    rwedge_contact_destroy(contact);
}

static void restoring_and_cycles_without_memory_say_so(void **state)
{
    rwedge_contact *contact = create(0.4, 0.5), *restored = NULL;
    double numbers[NUMBERS], left = 7, right = 7;
    load(contact, 0.5, 0);
    load(contact, 0.5, 0.1);
    load(contact, 0.6, 0.1);
    load(contact, 0.6, -0.1);
    const size_t n = numbers_of(contact, numbers);
    int32_t status = RWEDGE_ENOMEM;
    int refused = 0;
    for (int granted = 0; status != RWEDGE_OK; granted++, refused++) {
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_null(restored);
        allocations_left = granted;
        status = rwedge_contact_restore(n, numbers, &restored);
        allocations_left = -1;
    }
    assert_true(refused > 4);
    status = RWEDGE_ENOMEM;
    for (int granted = 0; status != RWEDGE_OK; granted++, refused++) {
        assert_int_equal(status, RWEDGE_ENOMEM);
        assert_true(left == 7 && right == 7);
        allocations_left = granted;
        status = rwedge_permanent_stick(THETA, 0.4, A, 0.5, 0.5, 0.1, -0.1, 0, 0.5, 0.1, 0.1, 0.01,
                                        &left, &right);
        allocations_left = -1;
    }
    assert_true(refused > 8);
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(contact);
}

/* ---- Copies ---- */

static void a_copy_is_independent(void **state)
{
    random_history h;
    rwedge_contact *contact = begin(&h, 6), *copy = NULL;
    for (int step = 0; step < 10; step++)
        go_on(&h, contact);
    assert_ok(rwedge_contact_copy(contact, &copy));
    const appearance before = look(contact);
    assert_looks(copy, &before);
    random_history other = h;
    for (int step = 0; step < 10; step++)
        go_on(&other, copy);
    assert_looks(contact, &before);
    const appearance after = look(copy);
    for (int step = 0; step < 10; step++)
        go_on(&h, contact);
    assert_looks(contact, &after); /* the same loads give the same bits */
    rwedge_contact_destroy(copy);
    assert_looks(contact, &after);
    rwedge_contact_destroy(contact);
}

/* ---- Refusals ---- */

static void a_refused_load_changes_nothing(void **state)
{
    const double f = 0.5, P = 0.2;
    rwedge_contact *contact = create(0.1, f);
    load(contact, P, 0);
    load(contact, P, 0.05);
    const appearance before = look(contact);
    const struct {
        double P, Q;
        int32_t status;
    } loads[] = {
        {P, 0.1 * (1 + 1e-14), RWEDGE_ESLIDING},
        {P, -0.1 * (1 + 1e-14), RWEDGE_ESLIDING},
        {P, HUGE_VAL, RWEDGE_EDOMAIN},
        {P, NAN, RWEDGE_EDOMAIN},
        {NAN, 0, RWEDGE_EDOMAIN},
        {HUGE_VAL, 0, RWEDGE_EDOMAIN},
        {-1, 0, RWEDGE_EDOMAIN},
        {-0.1, 0, RWEDGE_EDOMAIN},
        {0, 1e-9, RWEDGE_ESLIDING},
        {9e-61, 0, RWEDGE_EDOMAIN},
        {1.1e60, 0.1, RWEDGE_EDOMAIN},
        {P, 9e-61, RWEDGE_EDOMAIN},
        {1e-10, 0, RWEDGE_ERANGE}, /* below 1e-8 of the last */
    };
    for (size_t i = 0; i < sizeof loads / sizeof *loads; i++) {
        assert_int_equal(rwedge_contact_load(contact, loads[i].P, loads[i].Q), loads[i].status);
        assert_looks(contact, &before);
    }
    rwedge_contact_destroy(contact);
}

static void equality_is_full_sliding_to_rounding(void **state)
{
    uint64_t seed = 9;
    for (int i = 0; i < 1000; i++) {
        const double f = random_fraction(&seed), P = random_fraction(&seed);
        const double Q =
            f * P * (1 + (2 * random_fraction(&seed) - 1) * 4 * DBL_EPSILON) * (i % 2 ? 1 : -1);
        rwedge_contact *contact = create(0.1, f);
        load(contact, P, 0);
        load(contact, P, Q);
        assert_true(rwedge_contact_stick_half_width(contact) == 0);
        const double x = 0.3 * rwedge_contact_half_width(contact);
        assert_close(shear(contact, x), (i % 2 ? 1 : -1) * f * pressure(contact, x), 1e-15);
        rwedge_contact_destroy(contact);
    }
}

/* A caller who interpolates along the line of full sliding rounds like the larger load. */
static void an_interpolated_load_may_slide(void **state)
{
    const double f = 0.3, from = 0.7, to = 0.003;
    rwedge_contact *contact = create(0.1, f);
    for (int i = 1; i < 1000; i++) {
        const double t = i / 1000.0;
        load(contact, from, f * from);
        load(contact, from + t * (to - from), f * from + t * (f * to - f * from));
        assert_true(rwedge_contact_stick_half_width(contact) == 0);
    }
    rwedge_contact_destroy(contact);
}

/* In many steps all are rounded like the first: once refused, or a ring of rounding stuck. */
static void a_ramp_between_two_sliding_loads_slides(void **state)
{
    uint64_t seed = 3;
    for (int number = 0; number < 200; number++) {
        const double f = 0.05 + random_fraction(&seed), from = 0.1 + random_fraction(&seed),
                     to = from * 0.2 * random_fraction(&seed) + 1e-4, sign = number % 2 ? 1 : -1;
        rwedge_contact *contact = create(0.1, f);
        load(contact, from, sign * f * from);
        for (int i = 1; i <= 49; i++) {
            const double t = i / 49.0;
            load(contact, from + t * (to - from), sign * (f * from + t * (f * to - f * from)));
            assert_true(rwedge_contact_stick_half_width(contact) == 0);
        }
        /* what does not slide is not taken for it: the rounding of the first load is over */
        load(contact, to, 0);
        load(contact, to, sign * f * to * (1 - 1e-14));
        assert_true(rwedge_contact_stick_half_width(contact) > 0);
        rwedge_contact_destroy(contact);
    }
}

/* A ring that grows by roundings, with less shear than makes it slip: each of its steps alone might
 * be as steep as friction. */
static void a_ring_that_grows_by_roundings_does_not_slip(void **state)
{
    const double f = 0.5;
    rwedge_contact *contact = create(0.1, f);
    load(contact, 1, 0);
    load(contact, 1, 0.2 * f);
    for (int i = 1; i <= 3000; i++)
        load(contact, 1 + 2 * i * DBL_EPSILON, (0.2 + 0.6 * i * DBL_EPSILON) * f);
    assert_close(rw_memory_end(&contact->memory)->ratio, 0.3, 0.02);
    assert_true(rwedge_contact_stick_half_width(contact) == rwedge_contact_half_width(contact));
    rwedge_contact_destroy(contact);
}

static void far_points_have_no_stress(void **state)
{
    rwedge_contact *contact = create(1e-3, 0.3);
    load(contact, 1e-4, 0);
    load(contact, 1e-4, 1e-5);
    const double far[3] = {1e56, -1e56, 1e50}, deep[3] = {0, 1e56, 1e50};
    double s[3][3];
    assert_ok(rwedge_contact_stresses(contact, 3, far, deep, s[0], s[1], s[2]));
    for (int i = 0; i < 9; i++)
        assert_true(fabs(s[i / 3][i % 3]) < 1e-45);
    const double beyond = 1.1e60;
    assert_int_equal(rwedge_contact_stresses(contact, 1, &beyond, deep, s[0], s[1], s[2]),
                     RWEDGE_EDOMAIN);
    rwedge_contact_destroy(contact);
}

static void without_friction_there_is_no_tangential_load(void **state)
{
    rwedge_contact *contact = create(0.1, 0);
    load(contact, 0.2, 0);
    assert_int_equal(rwedge_contact_load(contact, 0.2, 1e-60), RWEDGE_ESLIDING);
    assert_true(shear(contact, 0.1) == 0 && slip(contact, 0.1) == 0);
    rwedge_contact_destroy(contact);
}

static void bad_arguments_are_refused(void **state)
{
    static const double BAD[] = {-1, NAN, HUGE_VAL, -HUGE_VAL};
    rwedge_contact *contact = NULL;
    for (int i = 0; i < 4; i++)
        for (int position = 0; position < 4; position++) {
            double v[4] = {0.1, 1, 1, 0.5};
            v[position] = BAD[i];
            assert_int_equal(rwedge_contact_create(v[0], v[1], v[2], v[3], &contact),
                             RWEDGE_EDOMAIN);
            assert_null(contact);
        }
    assert_int_equal(rwedge_contact_create(0, 1, 1, 0.5, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create(1.6, 1, 1, 0.5, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create(0.1, 1, 0, 0.5, &contact), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create(0.1, 1, 1, 0.5, NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_copy(NULL, &contact), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_load(NULL, 1, 0), RWEDGE_ENULL);
    assert_nan(rwedge_contact_half_width(NULL));
    assert_nan(rwedge_contact_stick_half_width(NULL));
    assert_nan(rwedge_contact_dissipated_energy(NULL));
    assert_int_equal(rwedge_contact_memory(NULL), 0);
    assert_int_equal(rwedge_contact_apply(NULL, 1, 0, 0, 0), RWEDGE_ENULL);
    assert_string_equal(rwedge_contact_obstacle(NULL, 1, 0, 0, 0), "");
    assert_nan(rwedge_contact_largest_tension_step(NULL, 0));
    assert_nan(rwedge_contact_tilt(NULL));
    contact = create(0.4, 0.5);
    assert_nan(rwedge_contact_largest_tension_step(contact, NAN));
    assert_true(rwedge_contact_largest_tension_step(contact, 1) == 0); /* there is no contact */
    double out[4] = {7, 7, 7, 7};
    for (int i = 0; i < 5; i++) {
        const rwedge_contact *first = i == 4 ? NULL : contact;
        double *to[4] = {&out[0], &out[1], &out[2], &out[3]};
        if (i < 4)
            to[i] = NULL;
        assert_int_equal(rwedge_contact_loads(first, to[0], to[1], to[2], to[3]), RWEDGE_ENULL);
        assert_int_equal(rwedge_contact_edge_asymptotes(first, to[0], to[1], to[2], to[3]),
                         RWEDGE_ENULL);
        if (i < 2 || i == 4) {
            assert_int_equal(rwedge_contact_edges(first, to[0], to[1]), RWEDGE_ENULL);
            assert_int_equal(rwedge_contact_stick_zone(first, to[0], to[1]), RWEDGE_ENULL);
        }
        if (i < 2)
            assert_int_equal(
                rwedge_permanent_stick(0.1, 1, 1, 0.5, 1, 0, 0, 0, 1, 0, 0.1, 0, to[0], to[1]),
                RWEDGE_ENULL);
    }
    assert_int_equal(rwedge_contact_edges(contact, &out[0], &out[1]), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_stick_zone(contact, &out[0], &out[1]), RWEDGE_EABSENT);
    assert_int_equal(rwedge_contact_edge_asymptotes(contact, &out[0], &out[1], &out[2], &out[3]),
                     RWEDGE_EABSENT);
    for (int i = 0; i < 4; i++)
        assert_true(out[i] == 7);
    rwedge_contact_destroy(contact);
}

static void bad_points_write_nothing(void **state)
{
    rwedge_contact *sharp = create(0, 0.5), *contact = create(0.1, 0.5);
    double x[2] = {0.1, 0}, y[2] = {0, 0}, s[3][2] = {{7, 7}, {7, 7}, {7, 7}}, factor = 7;
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.3, 1, &factor, NULL, NULL),
                     RWEDGE_EABSENT);
    /* separated: no apex yet */
    assert_ok(rwedge_contact_stresses(sharp, 2, x, y, s[0], s[1], s[2]));
    assert_true(s[0][1] == 0);
    s[0][0] = s[0][1] = s[1][0] = s[2][0] = 7;
    load(sharp, 0.2, 0);
    load(contact, 0.2, 0.05);
    assert_int_equal(rwedge_contact_tractions(sharp, 2, x, s[0], s[1]), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_stresses(sharp, 2, x, y, s[0], s[1], s[2]), RWEDGE_EDOMAIN);
    const double b = rwedge_contact_half_width(contact),
                 bad[] = {NAN, HUGE_VAL, -HUGE_VAL, 1.0001 * b, -1.0001 * b};
    for (int i = 0; i < 5; i++) {
        const double alone = x[1] = bad[i];
        assert_int_equal(rwedge_contact_slip(contact, 1, &alone, s[0]), RWEDGE_EDOMAIN);
        assert_int_equal(rwedge_contact_slip(contact, 2, x, s[0]), RWEDGE_EDOMAIN);
        if (i < 3) {
            assert_int_equal(rwedge_contact_tractions(contact, 2, x, s[0], s[1]), RWEDGE_EDOMAIN);
            assert_int_equal(rwedge_contact_stresses(contact, 2, x, y, s[0], s[1], s[2]),
                             RWEDGE_EDOMAIN);
        }
    }
    x[1] = 0;
    y[1] = -1e-9;
    assert_int_equal(rwedge_contact_stresses(contact, 2, x, y, s[0], s[1], s[2]), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_stresses(contact, 1, x, y, s[0], s[1], NULL), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_tractions(contact, 1, NULL, s[0], s[1]), RWEDGE_ENULL);
    assert_int_equal(rwedge_contact_slip(NULL, 1, x, s[0]), RWEDGE_ENULL);
    assert_ok(rwedge_contact_slip(contact, 0, NULL, NULL));
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.6, 1, &factor, NULL, NULL),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.3, 0, &factor, NULL, NULL),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_yield_factor(contact, 0.3, 1, NULL, NULL, NULL), RWEDGE_ENULL);
    assert_true(s[0][0] == 7 && s[0][1] == 7 && s[1][0] == 7 && s[2][0] == 7 && factor == 7);
    rwedge_contact_destroy(sharp);
    rwedge_contact_destroy(contact);
}

static void outputs_may_be_the_inputs(void **state)
{
    rwedge_contact *contact = create(0.1, 0.5);
    load(contact, 0.2, 0.05);
    double x[70], y[70], sxx[70], syy[70], txy[70];
    for (int i = 0; i < 70; i++) {
        x[i] = 0.01 * i - 0.3;
        y[i] = 0.005 * i;
    }
    assert_ok(rwedge_contact_stresses(contact, 70, x, y, sxx, syy, txy));
    assert_ok(rwedge_contact_stresses(contact, 70, x, y, y, x, txy));
    assert_memory_equal(x, syy, sizeof x);
    assert_memory_equal(y, sxx, sizeof y);
    rwedge_contact_destroy(contact);
}

/* Scales far from 1, where a careless intermediate result would over- or underflow. */
static void results_scale_with_the_units(void **state)
{
    for (int length = -60; length <= 60; length += 15)
        for (int stress = -40; stress <= 40; stress += 20) {
            const double L = ldexp(1, length), S = ldexp(1, stress);
            rwedge_contact *unit = create(0.1, 0.5), *scaled = NULL;
            assert_ok(rwedge_contact_create(THETA, 0.1 * L, A / S, 0.5, &scaled));
            for (int i = 0; i < 3; i++) {
                const double Q = i == 0 ? 0 : i == 1 ? 0.05 : -0.02;
                load(unit, 0.2, Q);
                load(scaled, 0.2 * S * L, Q * S * L);
            }
            assert_close(rwedge_contact_half_width(scaled), L * rwedge_contact_half_width(unit),
                         1e-14);
            assert_close(shear(scaled, 0.3 * L), S * shear(unit, 0.3), 1e-13);
            assert_close(slip(scaled, 0.3 * L), L * slip(unit, 0.3), 1e-13);
            assert_close(rwedge_contact_dissipated_energy(scaled),
                         S * L * L * rwedge_contact_dissipated_energy(unit), 1e-13);
            for (int i = 0; i < 20; i++) {
                const double x = 0.1 * (i - 9.3), y = 0.01 * i * i, x_scaled = L * x,
                             y_scaled = L * y;
                double s[3], expected[3];
                assert_int_equal(rwedge_contact_stresses(unit, 1, &x, &y, &expected[0],
                                                         &expected[1], &expected[2]),
                                 0);
                assert_int_equal(
                    rwedge_contact_stresses(scaled, 1, &x_scaled, &y_scaled, &s[0], &s[1], &s[2]),
                    0);
                for (int j = 0; j < 3; j++)
                    assert_within(s[j] / S, expected[j], 1e-14);
            }
            rwedge_contact_destroy(unit);
            rwedge_contact_destroy(scaled);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_load_without_memory_leaves_the_contact_as_it_was),
        cmocka_unit_test(creating_and_copying_without_memory_says_so),
        cmocka_unit_test(steps_off_centre_without_memory_leave_the_contact_as_it_was),
        cmocka_unit_test(a_stress_history_without_memory_leaves_the_contact_as_it_was),
        cmocka_unit_test(a_cycle_without_memory_says_so),
        cmocka_unit_test(restoring_and_cycles_without_memory_say_so),
        cmocka_unit_test(a_copy_is_independent),
        cmocka_unit_test(a_refused_load_changes_nothing),
        cmocka_unit_test(equality_is_full_sliding_to_rounding),
        cmocka_unit_test(an_interpolated_load_may_slide),
        cmocka_unit_test(a_ramp_between_two_sliding_loads_slides),
        cmocka_unit_test(a_ring_that_grows_by_roundings_does_not_slip),
        cmocka_unit_test(far_points_have_no_stress),
        cmocka_unit_test(without_friction_there_is_no_tangential_load),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(bad_points_write_nothing),
        cmocka_unit_test(outputs_may_be_the_inputs),
        cmocka_unit_test(results_scale_with_the_units),
    };
    return RUN_CLAIMS("contact_failures", tests);
}
