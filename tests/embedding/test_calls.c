/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every public function with arguments in its domain, at its edges and beyond them. The claims:
 * - The header's rules for errors hold.
 * - No exception but inexact and underflow is raised, and errno is left alone. (That the library
 *   cannot clear an exception, or change a trap or the rounding mode: ../package/symbols.sh.)
 * - The host's rounding mode does not matter.
 * - A stack of 64 KiB is enough.
 *
 *     test_calls [CALLS [SEED]] [PATTERN]
 *
 * CALLS is the number of calls of each function with random arguments (60). */
#include "calls.h"
#include "claims.h"
#include "rwedge.h"

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- The arguments of which each function is asked ---- */

enum { USUAL = 10 };

/* Each argument in turn outside of its domain, all others in theirs; then most of them in their
 * domains, at random; at last usual ones, with a computed contact where it takes a contact. */
typedef struct {
    const public_call *call;
    int argument; /* that is at its edge */
    size_t edge;
    long random, usual; /* how many are left */
    uint64_t seed;
} arguments;

static arguments arguments_of(const public_call *call, long random)
{
    return (arguments){.call = call, .random = random, .usual = USUAL, .seed = seed_or(1)};
}

/* Of any size that a double has. */
static double any_double(uint64_t *seed)
{
    return ldexp(random_between(seed, -1, 1), (int)random_between(seed, -1080, 1025));
}

/* In the domain, or anywhere. */
static double draw(const entry_argument *a, bool anywhere, uint64_t *seed)
{
    double v;
    if (a != &which_object && random_fraction(seed) < 0.3)
        return draw_number(a, seed);
    do
        v = !a->whole && random_fraction(seed) < 0.1
                ? any_double(seed)
                : edge(a, (size_t)(random_fraction(seed) * (double)edge_count(a)));
    while (!anywhere && !entry_allows(a, v));
    return v;
}

/* At last all are 0. */
static bool take_usual(arguments *left, double v[])
{
    const entry *e = left->call->entry;
    draw_inside(left->call, &left->seed, v);
    if (strcmp(e->object, "contact") == 0)
        v[0] = COMPUTED;
    for (int i = 0; left->usual == 0 && i < left->call->arguments; i++)
        v[i] = 0;
    return left->usual-- >= 0;
}

/* The next argument and edge where that is outside of its domain, if there are any. */
static bool find_outside(arguments *left)
{
    for (; left->argument < left->call->arguments; left->argument++, left->edge = 0) {
        const entry_argument *a = left->call->argument[left->argument];
        for (; a != &which_object && left->edge < edge_count(a); left->edge++)
            if (!entry_allows(a, edge(a, left->edge)))
                return true;
    }
    return false;
}

/* The next ones; false where there are no more. */
static bool take(arguments *left, double v[])
{
    const bool is_outside = find_outside(left);
    if (!is_outside && left->random-- <= 0)
        return take_usual(left, v);
    for (int i = 0; i < left->call->arguments; i++) {
        const bool anywhere = !is_outside && random_fraction(&left->seed) < 0.03;
        v[i] = draw(left->call->argument[i], anywhere, &left->seed);
    }
    if (is_outside)
        v[left->argument] = edge(left->call->argument[left->argument], left->edge++);
    return true;
}

static void show(const public_call *call, const double v[], const char *complaint)
{
    print_error("%s(", call->entry->name);
    for (int i = 0; i < call->arguments; i++)
        print_error("%s%s = %.17g", i > 0 ? ", " : "", call->argument[i]->name, v[i]);
    print_error("): %s\n", complaint);
}

/* Something to be asked of every call: NULL, or what is wrong. */
typedef const char *question(const public_call *call, const double v[]);

static void ask_of_every_call(question *ask, long random)
{
    size_t asked = 0, wrong = 0;
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        arguments left = arguments_of(&calls[i], random);
        for (double v[CALL_ARGUMENTS]; take(&left, v); asked++) {
            const char *answer = ask(&calls[i], v);
            if (answer != NULL && wrong++ < 20)
                show(&calls[i], v, answer);
        }
    }
    print_message("    %zu calls of %d functions\n", asked, ENTRY_COUNT);
    if (wrong > 0)
        fail_msg("%zu of %zu calls", wrong, asked);
}

CLAIM(a_pointer_that_is_needed_may_not_be_null)
{
    ask_of_every_call(complaint_about_null, 60);
}

/* Each argument is in its domain; what becomes of them is not, or is at the sharp apex. */
CLAIM(what_leaves_the_domain_together_is_refused)
{
    rwedge_contact *contact = NULL;
    double s[3];
    const double apex = 0;
    assert_nan(rwedge_compliance(HUGE_VAL, 0.3, HUGE_VAL, 0.3));
    assert_nan(rwedge_compliance(1e-60, 0.3, 1, 0.3));
    assert_nan(rwedge_dundurs_beta(HUGE_VAL, 0.3, HUGE_VAL, 0.3));
    assert_nan(rwedge_radius(1e-10, 1e55));
    assert_nan(rwedge_rounding(1e-40, 1e-40));
    assert_nan(rwedge_a_over_b(1e-121));
    assert_nan(rwedge_a_over_b(3e60));
    assert_nan(rwedge_half_width(1e-50, 0, 1e50, 1e20));
    assert_nan(rwedge_normal_load(1, 0, 1e-60, 1e50));
    assert_nan(rwedge_pressure(0, 0));
    assert_nan(rwedge_peak_pressure(0));
    assert_nan(rwedge_transition_pressure(0));
    assert_nan(rwedge_shear(0, 0, 0));
    assert_int_equal(rwedge_stress(0, 0.3, 0, 0, 0, &s[0], &s[1], &s[2]), RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_stresses(0, 0.3, 0, 1, &apex, &apex, &s[0], &s[1], &s[2]),
                     RWEDGE_EDOMAIN);
    assert_int_equal(rwedge_contact_create(1e-50, 0.1, 1e50, 0.3, &contact), RWEDGE_EDOMAIN);
}

/* ---- The host's exceptions ---- */

static const char *flags(const public_call *call, const double v[])
{
    double out[CALL_OUTPUTS];
    int32_t status;
    errno = 12345;
    feclearexcept(FE_ALL_EXCEPT);
    const char *complaint = complaint_of(call, v, out, &status);
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    return complaint != NULL              ? complaint
           : errno != 12345               ? "errno is set"
           : (raised & FE_INVALID) != 0   ? "invalid is raised"
           : (raised & FE_DIVBYZERO) != 0 ? "division by zero is raised"
           : (raised & FE_OVERFLOW) != 0  ? "overflow is raised"
                                          : NULL;
}

CLAIM(answers_follow_the_rules_and_raise_only_inexact_and_underflow)
{
    ask_of_every_call(flags, cases_or(60));
}

/* The contact is 1e60 times as wide as its rounding, which is not in the domain: its half-width is
 * NaN, and was compared. */
CLAIM(a_moment_on_next_to_no_rounding_is_refused_without_an_exception)
{
    rwedge_contact *contact = NULL;
    assert_ok(
        rwedge_contact_create(0.5 - DBL_EPSILON / 4, 3.0000000000000002e-60, 1.5, 0.5, &contact));
    feclearexcept(FE_ALL_EXCEPT);
    assert_int_equal(rwedge_contact_apply(contact, 2, -6e-60, 0, 0), RWEDGE_EDOMAIN);
    assert_int_equal(fetestexcept(FE_INVALID), 0);
    rwedge_contact_destroy(contact);
}

/* ---- Rounding modes ---- */

/* At the ends of the range of a double the direction of rounding decides whether there is a
 * result at all. */
static bool is_far_from_the_ends(const public_call *call, const double v[])
{
    for (int i = 0; i < call->arguments; i++)
        if (v[i] != 0 && isfinite(v[i]) && (fabs(v[i]) < 1e-300 || fabs(v[i]) > 1e300))
            return false;
    return true;
}

/* Each call in the next of the modes. */
static const char *rounds(const public_call *call, const double v[])
{
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    static size_t calls;
    const int mode = modes[calls++ % 3];
    double out[CALL_OUTPUTS];
    int32_t status;
    fesetround(mode);
    const char *complaint = complaint_of(call, v, out, &status);
    const int after = fegetround();
    fesetround(FE_TONEAREST);
    if (after != mode)
        return "the rounding mode is changed";
    return is_far_from_the_ends(call, v) ? complaint : NULL;
}

CLAIM(every_other_rounding_mode_gives_answers_by_the_rules)
{
    ask_of_every_call(rounds, cases_or(60));
}

/* ---- Stack ---- */

/* A quarter is left to the host. The address sanitizer needs room around every array. */
#ifdef __SANITIZE_ADDRESS__
enum { STACK = 1 << 18 };
#else
enum { STACK = 1 << 16 };
#endif
enum { MOST_OF_STACK = STACK - STACK / 4, PAINT = 0xa5 };

/* One function on a thread of its own; what it leaves of its painted stack is what was not used. */
static void *run_on_small_stack(void *of_call)
{
    arguments left = arguments_of(of_call, cases_or(60));
    double out[CALL_OUTPUTS];
    int32_t status;
    for (double v[CALL_ARGUMENTS]; take(&left, v);)
        complaint_of(of_call, v, out, &status);
    return NULL;
}

static size_t used_stack(void *(*run)(void *), void *argument)
{
    unsigned char *stack;
    assert_int_equal(posix_memalign((void **)&stack, 1 << 16, STACK), 0);
    memset(stack, PAINT, STACK);
    pthread_attr_t attributes;
    pthread_t thread;
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstack(&attributes, stack, STACK), 0);
    assert_int_equal(pthread_create(&thread, &attributes, run, argument), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&attributes);
    size_t unused = 0;
    while (unused < STACK && stack[unused] == PAINT)
        unused++;
    free(stack);
    return STACK - unused;
}

CLAIM(a_stack_of_64_KiB_is_enough)
{
    size_t most = 0, own = STACK; /* what the test itself uses is the host's */
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        public_call call = calls[i];
        const size_t used = used_stack(run_on_small_stack, &call);
        print_message("    %-25s %6zu bytes of stack\n", call.entry->name, used);
        most = used > most ? used : most;
        own = used < own ? used : own;
    }
    assert_true(most > own && most - own < MOST_OF_STACK);
}
