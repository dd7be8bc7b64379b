/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Allocations of every public function fail in turn, only once or from then on: each of the first
 * and of the last ones, fewer between. The call returns RWEDGE_ENOMEM, changes nothing and leaks
 * nothing. When there is memory again, it gives the same result as before.
 *
 * With PROGRAM_HEAP this program defines the four functions of the heap itself. They stand before
 * those of glibc in every shared library too, so allocations of GSL and LAPACK count. Without
 * PROGRAM_HEAP it is linked with --wrap, and sees only the allocations of the library. */
#include "calls.h"
#include "histories.h"

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
    heap.calls = 0;
    heap.failing = failing;
    heap.for_ever = for_ever;
}

static void set_inside(bool begins)
{
    heap.inside = begins;
}

/* That GSL's allocations are seen, which are where another library's are: the claim below holds
 * for them too. */
CLAIM(allocations_of_other_libraries_are_seen)
{
#ifdef PROGRAM_HEAP
    const long before = heap.outstanding;
    arm(0, false);
    set_inside(true);
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    set_inside(false);
    assert_non_null(solver);
    assert_true(heap.calls > 0 && heap.outstanding > before);
    set_inside(true);
    gsl_root_fsolver_free(solver);
    set_inside(false);
    assert_int_equal(heap.outstanding, before);
#else
    print_message("    not glibc, or under sanitizers: allocations inside shared GSL and LAPACK "
                  "are not seen here\n");
    skip();
#endif
}

/* ---- Every call ---- */

/* Arguments that are drawn for a call. A computed contact has fewer, as it takes its time. */
enum { DRAWS = 40, DRAWS_COMPUTED = 2, FEW = 20, MANY = 400 };

typedef struct {
    public_call call; /* that may lack memory */
    bool is_computed; /* the contact that it takes */
    double v[CALL_ARGUMENTS], out[CALL_OUTPUTS];
    size_t allocations;
} trial;

/* The status of the trial's call where the allocation of that number fails; 0: none. */
static int32_t status_of(const trial *t, double out[], size_t failing, bool for_ever)
{
    int32_t status;
    const long before = heap.outstanding;
    arm(failing, for_ever);
    const char *complaint = complaint_of(&t->call, t->v, out, &status);
    const size_t calls = heap.calls;
    arm(0, false);
    heap.calls = calls;
    if (complaint != NULL || heap.outstanding != before)
        fail_msg("%s, allocation %zu: %s", t->call.entry->name, failing,
                 complaint != NULL ? complaint : "a leak");
    return status;
}

static void assert_same_again(const trial *t)
{
    double again[CALL_OUTPUTS];
    assert_ok(status_of(t, again, 0, false));
    assert_memory_equal(again, t->out, sizeof again);
}

/* The number of the next one to fail: each of the first few, and of the last. */
static size_t next_to_fail(size_t failing, size_t all, size_t few)
{
    const size_t left = all - failing;
    return failing + 1 + (failing < left ? failing : left) / few;
}

/* Calls that make many take long. A computed contact may go without returning to closed form. */
static void fail_each(const trial *t)
{
    const size_t few = t->allocations < MANY ? FEW : 1;
    for (size_t k = 1; k <= t->allocations; k = next_to_fail(k, t->allocations, few))
        for (int for_ever = t->is_computed; for_ever < 2; for_ever++) {
            double out[CALL_OUTPUTS];
            const int32_t status = status_of(t, out, k, for_ever != 0);
            if (status != RWEDGE_ENOMEM && !(t->is_computed && status == RWEDGE_OK))
                fail_msg("%s, allocation %zu: status %d", t->call.entry->name, k, (int)status);
        }
    assert_same_again(t);
}

/* Arguments with a result, of which the call allocates most. */
static trial trial_of(const public_call *call, bool is_computed)
{
    trial best = {.call = *call, .is_computed = is_computed};
    uint64_t seed = 1;
    best.call.also_allowed |= 1u << RWEDGE_ENOMEM;
    for (int i = 0; i < (is_computed ? DRAWS_COMPUTED : DRAWS); i++) {
        trial t = best;
        draw_inside(call, &seed, t.v);
        if (call->entry->takes_object && is_computed != (t.v[0] == COMPUTED))
            t.v[0] = is_computed ? COMPUTED : i % COMPUTED;
        const int32_t status = status_of(&t, t.out, 0, false);
        t.allocations = heap.calls;
        if (status == RWEDGE_OK && t.allocations > best.allocations)
            best = t;
    }
    return best;
}

/* The header says of rwedge_contact_obstacle(), which gives a text, that it allocates too. Where
 * the object is changed, a copy of it is made. */
static bool may_allocate(const entry *e)
{
    return (e->errors & 1u << RWEDGE_ENOMEM) != 0 || e->text != NULL || e->changes_object;
}

CLAIM(every_failed_allocation_is_survived)
{
    size_t allocating = 0;
    const public_call *calls = public_calls();
    on_call = set_inside;
    for (size_t i = 0; i < 2 * (size_t)ENTRY_COUNT; i++) {
        const entry *e = calls[i / 2].entry;
        if (i % 2 == 1 && strcmp(e->object, "contact") != 0)
            continue;
        const trial t = trial_of(&calls[i / 2], i % 2 == 1);
        if (t.allocations == 0)
            continue;
        allocating++;
        print_message("    %-32s %zu allocations\n", t.call.entry->name, t.allocations);
        assert_true(may_allocate(e));
        if (e->has_status)
            fail_each(&t);
    }
    on_call = NULL;
    assert_true(allocating > 20);
}

/* ---- Loads and states ---- */

/* The last load of each is computed, or comes after one that is: it touches, slides, separates or
 * returns to a closed form. */
typedef struct {
    bool is_flat; /* or else a wedge */
    bool returns; /* to a closed form, unless memory is short */
    int last;
    rw_loads load[4];
} history;

static const history histories[] = {
    {false, false, 2, {{4, 0, 0, 0}, {4, 0, 0.5, 0.9}, {2, 1.2, -0.7, 3}}},
    {false, false, 2, {{4, 0, 0, 0}, {4, 0, 0.5, 0.9}, {0, 0, 0, 0}}},
    {false, false, 2, {{4, 0, 0, 0}, {4, 0, 0.5, 0.9}, {4, 0, 2, 0.9}}},
    {false, true, 3, {{4, 0, 0, 0}, {4, 0, 0.5, 0.9}, {4, 0, -0.4, -0.6}, {4, 0, 1.7, 0.3}}},
    {false, false, 1, {{4, 0, 0, 0}, {4, 0, 0.5, 0.9}}},
    {false, false, 1, {{2, 0, 0.2, 0.05}, {4, 0, 0.4, 0.1}}},
    {false, false, 0, {{4, 0.4, 0.8, 0.4}}},
    {true, false, 2, {{0.2, 0, 0, 0}, {0.2, 0, 0.03, 0}, {0.2, 0, 0.02, 0.05}}},
    {true, false, 2, {{0.2, 0.03, 0, 0}, {0.2, 0.03, 0.06, 0.002}, {0.2, 0.01, 0.05, 0.02}}},
    {true, false, 0, {{0.14, 0.01, -0.036, 0.052}}},
};

/* Pressed; sheared; from full sliding back, and into it. */
static const history unlike_histories[] = {
    {false, false, 0, {{4, 0, 0, 0}}},
    {false, false, 1, {{4, 0, 0, 0}, {4, 0, 1, 0}}},
    {false, false, 1, {{4, 0, 2, 0}, {4, 0, 1.7, 0}}},
    {false, false, 2, {{4, 0, 0, 0}, {4, 0, 1, 0}, {4, 0, 2, 0}}},
};

/* A contact, as numbers too, and a load that it may take. */
typedef struct {
    const rwedge_contact *contact;
    contact_state state;
    rw_loads to;
} beginning;

/* What may lack memory. Where it does not, it leaves a contact. */
typedef int32_t step(const beginning *from, rwedge_contact **after);

/* By way of a history of stresses, which copies what is computed too. */
static int32_t follow(const beginning *from, rwedge_contact **after)
{
    const rw_loads to = from->to;
    int32_t status = rwedge_contact_copy(from->contact, after);
    if (status != RWEDGE_OK)
        return status;
    status = rwedge_contact_stress_history(*after, 1, &to.P, &to.M, &to.Q, &to.sigma, 0, NULL, NULL,
                                           NULL, NULL, NULL);
    if (status != RWEDGE_OK)
        rwedge_contact_destroy(*after);
    return status;
}

/* What the load does as a cycle. */
static int32_t rub(const beginning *from, rwedge_contact **after)
{
    const rw_loads to = from->to;
    const double x = 0;
    double range, f1, f2, energy;
    rwedge_cycle *cycle = NULL;
    int32_t status = rwedge_contact_copy(from->contact, after);
    if (status != RWEDGE_OK)
        return status;
    status = rwedge_cycle_create(*after, 1, &to.P, &to.M, &to.Q, &to.sigma, &cycle);
    if (status == RWEDGE_OK)
        status = rwedge_cycle_friction(cycle, 1, &x, &range, &f1, &f2, &energy);
    rwedge_cycle_destroy(cycle);
    if (status != RWEDGE_OK)
        rwedge_contact_destroy(*after);
    return status;
}

static int32_t restore(const beginning *from, rwedge_contact **after)
{
    return rwedge_contact_restore(from->state.size, from->state.number, after);
}

/* Returns how many allocations the step makes. */
static size_t survive(step *take, const beginning *from, bool returns, size_t failing,
                      bool for_ever)
{
    rwedge_contact *after = NULL;
    const long outstanding = heap.outstanding;
    arm(failing, for_ever);
    set_inside(true);
    const int32_t status = take(from, &after);
    const size_t calls = heap.calls;
    const bool was_short = calls >= failing;
    arm(0, false);
    const bool has_error = status == RWEDGE_OK && rwedge_contact_error(after) > 0;
    if (status == RWEDGE_OK)
        rwedge_contact_destroy(after);
    set_inside(false);
    assert_true(status == (was_short ? RWEDGE_ENOMEM : RWEDGE_OK) || (returns && has_error));
    assert_int_equal(heap.outstanding, outstanding);
    return calls;
}

static void lack_memory(step *take, const beginning *from, bool returns, size_t few)
{
    const size_t all = survive(take, from, returns, SIZE_MAX, false);
    assert_true(all > 1);
    for (size_t k = 1; k <= all; k = next_to_fail(k, all, few))
        for (int for_ever = 0; for_ever < 2; for_ever++)
            survive(take, from, returns, k, for_ever != 0);
}

static void lack_memory_along(const history *h, double beta)
{
    rwedge_contact *contact =
        h->is_flat ? create_flat(0.4, 10, A, 0.5) : create_wedge(1, 1, 1, 0.5);
    assert_ok(rwedge_contact_set_beta(contact, beta));
    apply_all(allowing(contact, 1e-2), (size_t)h->last, h->load);
    beginning from = {contact, state_of(contact), h->load[h->last]};
    lack_memory(follow, &from, h->returns, FEW);
    if (h->last > 0)
        lack_memory(restore, &from, false, FEW);
    from.state = state_of(apply_all(contact, 1, &from.to));
    lack_memory(restore, &from, false, FEW);
}

/* From some allocations on a load was said not to converge, at the loosest tolerance. */
CLAIM(a_load_or_a_state_that_lacks_memory_says_so)
{
    for (size_t i = 0; i < sizeof histories / sizeof histories[0]; i++)
        lack_memory_along(&histories[i], 0);
}

CLAIM(a_load_of_unlike_bodies_that_lacks_memory_says_so)
{
    for (size_t i = 0; i < sizeof unlike_histories / sizeof unlike_histories[0]; i++)
        lack_memory_along(&unlike_histories[i], -0.1);
}

/* The contact grows from touching on cells, which takes longer: fewer allocations fail, but each of
 * those of the cells. */
CLAIM(a_first_load_of_unlike_bodies_that_lacks_memory_says_so)
{
    enum { FEW_OF_GROWTH = 12 };
    rwedge_contact *contact = create_wedge(1, 1, 1, 0.5);
    assert_ok(rwedge_contact_set_beta(contact, -0.1));
    const beginning from = {.contact = allowing(contact, 1e-2), .to = {4, 0, 1.9, 0}};
    lack_memory(follow, &from, false, FEW_OF_GROWTH);
}

/* The slip is not known: it was lost under the last load but one, in closed form, and then none was
 * left. */
CLAIM(a_cycle_that_counts_its_slip_anew_says_that_it_lacks_memory)
{
    rwedge_contact *contact = create(0.4, 0.5);
    for (int turn = 0; turn < 3; turn++)
        APPLY(contact, {1.2, 0, 0.5, 0}, {0.8, 0, -0.3, 0});
    APPLY(contact, {1.2, 0, 0.5, 1e-7}, {0.8, 0, -0.3, 0});
    APPLY(allowing(contact, 1e-2), {0.8, 0, -0.3, 0.3});
    assert_true(rwedge_contact_error(contact) > 0);
    const beginning from = {.contact = contact, .to = {0.9, 0, 0.4, 0}};
    lack_memory(rub, &from, false, FEW);
}
