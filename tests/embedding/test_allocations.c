/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every allocation of the library fails in turn: only once, or from then on. The call returns
 * RWEDGE_ENOMEM, changes nothing and leaks nothing. When there is memory again, it gives the same
 * result as before.
 *
 * With PROGRAM_HEAP this program defines the four functions of the heap itself. They stand before
 * those of glibc in every shared library too, so allocations of GSL and LAPACK count. Without
 * PROGRAM_HEAP it is linked with --wrap, and sees only the allocations of the library. */
#include "histories.h"
#include "rwedge.h"

#include <gsl/gsl_roots.h>
#include <stdlib.h>
#include <string.h>

/* ---- An allocator that fails ---- */

static struct {
    bool inside;    /* a call of the library: nothing else counts, or fails */
    size_t calls;   /* since the last arm() */
    size_t failing; /* the number of the call that fails; 0: none */
    bool for_ever;
    long outstanding; /* blocks that are not freed */
} heap;

#ifdef PROGRAM_HEAP
#define HEAP(function) function
#define REAL(function) __libc_##function
#else
#define HEAP(function) __wrap_##function
#define REAL(function) __real_##function
#endif

void *REAL(malloc)(size_t size);
void *REAL(calloc)(size_t count, size_t size);
void *REAL(realloc)(void *block, size_t size);
void REAL(free)(void *block);
void *HEAP(malloc)(size_t size);
void *HEAP(calloc)(size_t count, size_t size);
void *HEAP(realloc)(void *block, size_t size);
void HEAP(free)(void *block);

static bool is_granted(void)
{
    if (!heap.inside)
        return true;
    heap.calls++;
    return heap.failing == 0 ||
           (heap.for_ever ? heap.calls < heap.failing : heap.calls != heap.failing);
}

static void *counted(void *block)
{
    heap.outstanding += heap.inside && block != NULL ? 1 : 0;
    return block;
}

void *HEAP(malloc)(size_t size)
{
    return is_granted() ? counted(REAL(malloc)(size)) : NULL;
}

void *HEAP(calloc)(size_t count, size_t size)
{
    return is_granted() ? counted(REAL(calloc)(count, size)) : NULL;
}

void *HEAP(realloc)(void *block, size_t size)
{
    if (!is_granted())
        return NULL;
    return block == NULL ? counted(REAL(realloc)(block, size)) : REAL(realloc)(block, size);
}

void HEAP(free)(void *block)
{
    heap.outstanding -= heap.inside && block != NULL ? 1 : 0;
    REAL(free)(block);
}

static void arm(size_t failing, bool for_ever)
{
    heap.inside = false;
    heap.calls = 0;
    heap.failing = failing;
    heap.for_ever = for_ever;
}

/* A call of the library, which is all that counts: what the tests' own machinery allocates does
 * not. */
static int32_t left_with(int32_t status)
{
    heap.inside = false;
    return status;
}

#define STATUS_OF(call) (heap.inside = true, left_with(call))
#define RUN(call)                                                                                  \
    do {                                                                                           \
        heap.inside = true;                                                                        \
        call;                                                                                      \
        heap.inside = false;                                                                       \
    } while (0)

/* ---- Calls that allocate: what they give, as numbers ---- */

enum { NUMBERS = 64, SAMPLES = 200, TERMS = 60 };

typedef struct {
    int32_t status;
    double number[NUMBERS];
} outcome;

static double next_load(uint64_t *seed, double *Q)
{
    const double P = 0.05 + random_fraction(seed);
    *Q = 0.4 * P * (2 * random_fraction(seed) - 1);
    return P;
}

static void look(const rwedge_contact *contact, outcome *seen)
{
    const double b = rwedge_contact_half_width(contact), x[3] = {0.1 * b, -0.6 * b, 0.95 * b},
                 y[3] = {0, b, 0.1 * b};
    double *n = seen->number;
    n[0] = b;
    RUN(n[1] = rwedge_contact_stick_half_width(contact));
    RUN(n[2] = rwedge_contact_dissipated_energy(contact));
    RUN(n[3] = (double)rwedge_contact_memory(contact));
    assert_ok(STATUS_OF(rwedge_contact_tractions(contact, 3, x, n + 4, n + 7)));
    assert_ok(STATUS_OF(rwedge_contact_slip(contact, 3, x, n + 10)));
    assert_ok(STATUS_OF(rwedge_contact_stresses(contact, 3, x, y, n + 13, n + 16, n + 19)));
}

/* A contact, its loads, a copy that goes on: a call that fails is made again, when the heap is
 * sound. */
static outcome history(void)
{
    outcome seen = {0};
    rwedge_contact *contact = NULL, *copy = NULL;
    seen.status = STATUS_OF(rwedge_contact_create(0.1, 0.3, 0.5, 0.4, &contact));
    assert_true((contact == NULL) == (seen.status != RWEDGE_OK));
    uint64_t seed = 7;
    for (int i = 0; i < 40 && seen.status == RWEDGE_OK; i++) {
        double Q;
        const double P = next_load(&seed, &Q);
        outcome before = {0}, after = {0};
        if (i > 0)
            look(contact, &before);
        seen.status = STATUS_OF(rwedge_contact_load(contact, P, Q));
        if (seen.status == RWEDGE_OK || i == 0)
            continue;
        look(contact, &after);
        assert_memory_equal(&before, &after, sizeof before);
    }
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_copy(contact, &copy));
    assert_true((copy == NULL) == (seen.status != RWEDGE_OK));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_load(copy, 2, 0.7));
    if (seen.status == RWEDGE_OK)
        look(copy, &seen);
    RUN(rwedge_contact_destroy(copy));
    RUN(rwedge_contact_destroy(contact));
    return seen;
}

/* ---- Moment, tension and cycles ---- */

static const double STEPS[][4] = {{0.5, 0.1, 0, 0},
                                  {0.5, 0.1, 0.1, 0.01},
                                  {0.5, 0.1, -0.05, 0},
                                  {0.6, 0.12, -0.05, 0},
                                  {0.6, 0.12, 0.02, 0.01}};
enum { STEP_COUNT = sizeof STEPS / sizeof *STEPS };

/* Loads one by one and all at once, and a contact that is restored from their state. */
static outcome off_centre(void)
{
    outcome seen = {0};
    double P[STEP_COUNT], M[STEP_COUNT], Q[STEP_COUNT], sigma[STEP_COUNT], s[3][STEP_COUNT];
    const double x = 0.1, y = 0.2;
    rwedge_contact *contact = NULL, *restored = NULL;
    seen.status = STATUS_OF(rwedge_contact_create(0.1, 0.4, 0.5, 0.5, &contact));
    for (int i = 0; i < STEP_COUNT && seen.status == RWEDGE_OK; i++) {
        const contact_state before = state_of(contact);
        P[i] = STEPS[i][0], M[i] = STEPS[i][1], Q[i] = STEPS[i][2], sigma[i] = STEPS[i][3];
        seen.status = STATUS_OF(rwedge_contact_apply(contact, P[i], M[i], Q[i], sigma[i]));
        if (seen.status != RWEDGE_OK)
            assert_state(contact, before);
    }
    if (seen.status == RWEDGE_OK) {
        const contact_state before = state_of(contact);
        seen.status = STATUS_OF(rwedge_contact_stress_history(contact, STEP_COUNT, P, M, Q, sigma,
                                                              1, &x, &y, s[0], s[1], s[2]));
        if (seen.status != RWEDGE_OK)
            assert_state(contact, before);
    }
    if (seen.status == RWEDGE_OK) {
        const contact_state last = state_of(contact);
        seen.status = STATUS_OF(rwedge_contact_restore(last.size, last.number, &restored));
        assert_true((restored == NULL) == (seen.status != RWEDGE_OK));
    }
    if (seen.status == RWEDGE_OK)
        memcpy(seen.number, s, sizeof s);
    RUN(rwedge_contact_destroy(restored));
    RUN(rwedge_contact_destroy(contact));
    return seen;
}

/* Where memory was short at a place of the search, the worst one was once sought without it. */
static outcome cycles(void)
{
    static const int32_t measures[] = {RWEDGE_MEASURE_STRESS_RANGE, RWEDGE_MEASURE_DANG_VAN};
    outcome seen = {0};
    const double P[] = {0.6, 0.5}, M[] = {0, 0}, Q[] = {0.1, -0.1}, sigma[] = {0, 0}, x = 0.2,
                 value = 1e-9;
    double n[16];
    rwedge_contact *contact = NULL;
    seen.status = STATUS_OF(rwedge_contact_create(0.1, 0.4, 0.5, 0.5, &contact));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_load(contact, 0.5, 0));
    for (int line = 0; line < 2 && seen.status == RWEDGE_OK; line++)
        seen.status = STATUS_OF(rwedge_contact_cycle_below(contact, 2, P, M, Q, sigma, x, 0, 0.1,
                                                           line, &n[10], &n[12], &n[14]));
    for (int i = 0; i < 2 && seen.status == RWEDGE_OK; i++)
        seen.status = STATUS_OF(rwedge_contact_cycle_worst(contact, measures[i], 2, P, M, Q, sigma,
                                                           1, &x, &value, 0, 70, 0.3, 0, 0.4, 1,
                                                           &n[2 * i], &n[2 * i + 1]));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_cycle_friction(contact, 2, P, M, Q, sigma, 1, &x,
                                                              &n[4], &n[5], &n[6], &n[7]));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_keep_cycle(contact, 2, P, M, Q, sigma));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_permanent_stick(0.1, 0.4, 0.5, 0.5, 0.5, 0.1, -0.1, 0, 0.5,
                                                       0.1, 0.1, 0.01, &n[8], &n[9]));
    if (seen.status == RWEDGE_OK)
        memcpy(seen.number, n, sizeof n);
    RUN(rwedge_contact_destroy(contact));
    return seen;
}

/* A pad, and what has no closed form. */
static outcome computed(void)
{
    static const double place[] = {-2, -1, 1, 2}, slope[] = {-0.1, 0, 0, 0.1};
    static const double STEP[][4] = {{0.5, 0, 0, 0}, {0.5, 0, 0.1, 0.9}};
    outcome seen = {0};
    const double x = 0.1;
    double s[5];
    rwedge_contact *contact = NULL, *other = NULL;
    seen.status = STATUS_OF(rwedge_contact_create_flat(1, 1, 0.5, 0.5, &contact));
    RUN(rwedge_contact_destroy(contact));
    contact = NULL;
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_create_profile(4, place, slope, 0.5, 0.5, &contact));
    if (seen.status == RWEDGE_OK)
        seen.status = rwedge_contact_allow_error(contact, 1e-2);
    for (int i = 0; i < 2 && seen.status == RWEDGE_OK; i++) {
        const contact_state before = state_of(contact);
        seen.status = STATUS_OF(
            rwedge_contact_apply(contact, STEP[i][0], STEP[i][1], STEP[i][2], STEP[i][3]));
        if (seen.status != RWEDGE_OK)
            assert_state(contact, before);
    }
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_contact_copy(contact, &other));
    RUN(rwedge_contact_destroy(other));
    other = NULL;
    if (seen.status == RWEDGE_OK) {
        const contact_state last = state_of(contact);
        seen.status = STATUS_OF(rwedge_contact_restore(last.size, last.number, &other));
    }
    if (seen.status == RWEDGE_OK)
        seen.status =
            STATUS_OF(rwedge_contact_stress_history(other, 1, &STEP[1][0], &STEP[1][1], &STEP[1][2],
                                                    &STEP[1][3], 1, &x, &x, s, s + 1, s + 2));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(
            rwedge_contact_permanent_stick(contact, 0.5, 0, -0.1, 0, 0.5, 0, 0.1, 0, &s[3], &s[4]));
    if (seen.status == RWEDGE_OK)
        memcpy(seen.number, s, sizeof s);
    RUN(rwedge_contact_destroy(other));
    RUN(rwedge_contact_destroy(contact));
    return seen;
}

static outcome planes(void)
{
    outcome seen = {0};
    const double sxx[] = {1, -2}, syy[] = {0, 0.5}, txy[] = {0.3, 0.1};
    double n[13];
    seen.status = STATUS_OF(rwedge_findley(2, sxx, syy, txy, 0.3, 0.2, &n[0], &n[1], &n[2]));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_smith_watson_topper_damage(
            2, sxx, syy, txy, 2e5, 0.3, 0, 1000, -0.1, 0.5, -0.6, 0, &n[3], &n[4], &n[5], &n[6]));
    if (seen.status == RWEDGE_OK)
        seen.status = STATUS_OF(rwedge_rainflow(2, sxx, 1, &n[7], &n[9], &n[11]));
    if (seen.status == RWEDGE_OK)
        memcpy(seen.number, n, sizeof n);
    return seen;
}

/* ---- Series ---- */

static void keep_series(rwedge_series *series, outcome *seen)
{
    assert_true((series == NULL) == (seen->status != RWEDGE_OK));
    for (int k = 0; series != NULL && k < NUMBERS - 1; k++)
        RUN(seen->number[k] = rwedge_series_coefficient(series, k));
    if (series != NULL)
        RUN(seen->number[NUMBERS - 1] = rwedge_series_residual(series));
    RUN(rwedge_series_destroy(series));
}

static outcome series_create(void)
{
    outcome seen = {0};
    rwedge_series *series = NULL;
    seen.status = STATUS_OF(rwedge_series_create(0.3, 101, &series));
    keep_series(series, &seen);
    return seen;
}

/* With the work space of LAPACK. */
static outcome series_fit(void)
{
    outcome seen = {0};
    static double x[SAMPLES], p[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        x[i] = cos((i + 0.5) * 3.14159265358979323846 / SAMPLES);
        p[i] = rwedge_pressure(0.3, x[i]);
    }
    rwedge_series *series = NULL;
    seen.status = STATUS_OF(rwedge_series_fit(SAMPLES, x, p, TERMS, &series));
    keep_series(series, &seen);
    return seen;
}

/* What must not allocate at all. */
static outcome the_rest(void)
{
    outcome seen = {0};
    double *n = seen.number;
    const double alpha[2] = {0.3, 0.02}, f[2] = {0.1, 0.5}, x[2] = {0.1, 2}, y[2] = {0, 1};
    heap.inside = true;
    seen.status = rwedge_elastic_limits(2, alpha, f, 0.3, n) +
                  rwedge_stresses(0.2, 0.3, 0.4, 2, x, y, n + 2, n + 4, n + 6) +
                  rwedge_yield_point(0.1, 0.3, 0.3, n + 8, n + 9, n + 10) +
                  rwedge_subsurface_yield(0.1, 0.1, 0.3, n + 11, n + 12, n + 13) +
                  rwedge_surface_yield(0.1, 0.3, 0.3, n + 14, n + 15);
    n[16] = rwedge_critical_friction(0.3, 0.3);
    n[17] = rwedge_a_over_b(3);
    n[18] = rwedge_stick_width(0.3, 0.5);
    n[19] = rwedge_coefficient(0.3, 77);
    n[20] = rwedge_yield_load(0.01, 1, 1e-5, 0.3, 0.3, 300);
    n[21] = rwedge_shear(0.3, 0.2, 0.1);
    heap.inside = false;
    return seen;
}

/* ---- Claims ---- */

/* That GSL's allocations are seen, which are where another library's are: the claims below hold
 * for them too. */
CLAIM(allocations_of_other_libraries_are_seen)
{
#ifdef PROGRAM_HEAP
    gsl_root_fsolver *solver = NULL;
    const long before = heap.outstanding;
    arm(0, false);
    RUN(solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    assert_non_null(solver);
    assert_true(heap.calls > 0 && heap.outstanding > before);
    RUN(gsl_root_fsolver_free(solver));
    assert_int_equal(heap.outstanding, before);
#else
    print_message("    not glibc, or under sanitizers: allocations inside shared GSL and LAPACK "
                  "are not seen here\n");
    skip();
#endif
}

static void assert_refused(const outcome *failed)
{
    assert_int_equal(failed->status, RWEDGE_ENOMEM);
    for (int i = 0; i < NUMBERS; i++)
        assert_true(failed->number[i] == 0);
}

static size_t every_allocation_of(const char *name, outcome (*call)(void))
{
    const long before = heap.outstanding;
    arm(0, false);
    const outcome expected = call();
    const size_t allocations = heap.calls;
    assert_ok(expected.status);
    for (size_t k = 1; k <= allocations; k++)
        for (int for_ever = 0; for_ever < 2; for_ever++) {
            arm(k, for_ever != 0);
            const outcome failed = call();
            arm(0, false);
            assert_refused(&failed);
            assert_int_equal(heap.outstanding, before);
            const outcome again = call();
            assert_memory_equal(&again, &expected, sizeof again);
        }
    assert_int_equal(heap.outstanding, before);
    print_message("    %-15s %zu of %zu allocations survived, once and for ever\n", name,
                  allocations, allocations);
    return allocations;
}

CLAIM(every_failed_allocation_is_survived)
{
    assert_true(every_allocation_of("contact", history) >= 10);
    assert_true(every_allocation_of("off_centre", off_centre) >= 20);
    assert_true(every_allocation_of("cycles", cycles) >= 12);
    assert_true(every_allocation_of("planes", planes) >= 4);
    assert_int_equal(every_allocation_of("series_create", series_create), 1);
    assert_int_equal(every_allocation_of("series_fit", series_fit), 4);
}

/* Where memory fails once, another trial may have enough. There are many allocations: most are
 * tried at the beginning. */
CLAIM(no_load_is_computed_where_memory_stays_short)
{
    const long before = heap.outstanding;
    arm(0, false);
    const outcome expected = computed();
    const size_t allocations = heap.calls;
    assert_ok(expected.status);
    for (size_t k = 1; k <= allocations; k += 1 + k / 40) {
        arm(k, true);
        const outcome failed = computed();
        arm(0, false);
        assert_refused(&failed);
        assert_int_equal(heap.outstanding, before);
    }
}

CLAIM(nothing_else_allocates)
{
    arm(1, true);
    const outcome without = the_rest();
    const size_t calls = heap.calls;
    arm(0, false);
    const outcome with = the_rest();
    assert_int_equal(calls, 0);
    assert_ok(without.status);
    assert_memory_equal(&without, &with, sizeof with);
}
