/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every public function with arguments in its domain, at its edges and beyond them. The claims:
 * - The header's rules for errors hold.
 * - No exception but inexact and underflow is raised, and errno is left alone. (That the library
 *   cannot clear an exception, or change a trap or the rounding mode: ../package/symbols.sh.)
 * - The host's rounding mode does not matter.
 * - A stack of 64 KiB is enough.
 *
 *     test_calls [CALLS] [PATTERN]
 *
 * CALLS is the number of calls of each function (60). If there are more combinations of
 * arguments, they are drawn at random. */
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

static size_t limit = SIZE_MAX; /* of a claim */

static size_t most_calls(void)
{
    const size_t cases = (size_t)cases_or(60);
    return cases < limit ? cases : limit;
}

/* ---- All combinations of edges, or so many; a tenth of a function that takes milliseconds -- */

typedef struct {
    const public_call *call;
    size_t all, number, calls; /* combinations; the next one; how many will be made */
    uint64_t seed;
    int argument; /* that is outside of its domain, when these have been made */
    size_t edge;  /* where */
} combinations;

static bool takes_long(const char *name)
{
    static const char *const part[] = {"yield_factor", "planes",    "findley",
                                       "wohler",       "mcdiarmid", "criterion_field",
                                       "damage",       "cycle_",    "keep_cycle"};
    for (size_t i = 0; i < sizeof part / sizeof part[0]; i++)
        if (strstr(name, part[i]) != NULL)
            return true;
    return false;
}

static combinations combinations_of(const public_call *call)
{
    combinations c = {.call = call, .all = 1, .seed = 1};
    for (int i = 0; i < call->arguments; i++)
        c.all = c.all > most_calls() ? c.all : c.all * edge_count(call->argument[i]);
    c.calls = c.all < most_calls() ? c.all : most_calls() / (takes_long(call->name) ? 10 : 1);
    return c;
}

static double draw(combinations *c, const entry_argument *a, bool any)
{
    double v;
    if (a != &which_object && random_fraction(&c->seed) < 0.3)
        return draw_number(a, &c->seed);
    do
        v = edge(a, (size_t)(random_fraction(&c->seed) * (double)edge_count(a)));
    while (!any && !entry_allows(a, v));
    return v;
}

static void draw_sound(combinations *c, double v[])
{
    for (int i = 0; i < c->call->arguments; i++)
        v[i] = draw(c, c->call->argument[i], false);
}

/* At last all are 0, and each argument in turn is outside of its domain, all others in theirs. */
static bool next_outside(combinations *c, double v[])
{
    if (c->number++ == c->calls) {
        for (int i = 0; i < c->call->arguments; i++)
            v[i] = 0;
        return true;
    }
    for (; c->argument < c->call->arguments; c->argument++, c->edge = 0)
        while (c->edge < edge_count(c->call->argument[c->argument])) {
            const entry_argument *a = c->call->argument[c->argument];
            const double outside = edge(a, c->edge++);
            if (a == &which_object || entry_allows(a, outside))
                continue;
            draw_sound(c, v);
            v[c->argument] = outside;
            return true;
        }
    return false;
}

/* Most of those that are drawn have all of their arguments in the domain. */
static bool next(combinations *c, double v[])
{
    if (c->number >= c->calls)
        return next_outside(c, v);
    size_t rest = c->number++;
    for (int i = 0; i < c->call->arguments; i++) {
        const entry_argument *a = c->call->argument[i];
        const bool any = random_fraction(&c->seed) < 0.03;
        v[i] = c->all <= most_calls() ? edge(a, rest % edge_count(a)) : draw(c, a, any);
        rest /= edge_count(a);
    }
    return true;
}

static void show(const public_call *call, const double v[], const char *complaint)
{
    print_error("%s(", call->name);
    for (int i = 0; i < call->arguments; i++)
        print_error("%s%s = %.17g", i > 0 ? ", " : "", call->argument[i]->name, v[i]);
    print_error("): %s\n", complaint);
}

/* Something to be asked of every call: NULL, or what is wrong. */
typedef const char *question(const public_call *call, const double v[]);

static void ask_of_every_call(question *ask, size_t at_most)
{
    limit = at_most;
    size_t asked = 0, wrong = 0;
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        combinations c = combinations_of(&calls[i]);
        size_t shown = 0;
        for (double v[CALL_ARGUMENTS]; next(&c, v); asked++) {
            const char *answer = ask(&calls[i], v);
            if (answer == NULL)
                continue;
            wrong++;
            if (shown++ < 3)
                show(&calls[i], v, answer);
        }
    }
    limit = SIZE_MAX;
    print_message("    %zu calls of %d functions\n", asked, ENTRY_COUNT);
    if (wrong > 0)
        fail_msg("%zu of %zu calls", wrong, asked);
}

/* ---- Pointers ---- */

CLAIM(a_pointer_that_is_needed_may_not_be_null)
{
    enum { DRAWS = 20 };
    ask_of_every_call(complaint_about_null, 50);
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        double v[CALL_ARGUMENTS];
        uint64_t seed = 1;
        for (int k = 0; k < DRAWS; k++) {
            draw_inside(&calls[i], &seed, v);
            const char *complaint = complaint_about_null(&calls[i], v);
            if (complaint != NULL)
                fail_msg("%s: %s", calls[i].name, complaint);
        }
    }
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
    ask_of_every_call(flags, SIZE_MAX);
}

enum { COMPUTED_CALLS = 10 };

/* Arguments in the domain, the object a computed contact if it is a contact. */
static void draw_computed(const public_call *call, uint64_t *seed, double v[])
{
    draw_inside(call, seed, v);
    if (call->entry->takes_object && strcmp(call->entry->family, "contact") == 0)
        v[0] = COMPUTED;
}

/* NaN was compared, and divided by 0. */
CLAIM(no_call_with_a_computed_contact_raises_an_exception)
{
    size_t wrong = 0;
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        uint64_t seed = 1;
        for (int k = 0; k < COMPUTED_CALLS; k++) {
            double v[CALL_ARGUMENTS];
            draw_computed(&calls[i], &seed, v);
            const char *complaint = flags(&calls[i], v);
            if (complaint != NULL)
                show(&calls[i], v, complaint);
            wrong += complaint != NULL;
        }
    }
    assert_int_equal(wrong, 0);
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
    ask_of_every_call(rounds, 3000);
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
    const public_call *call = of_call;
    combinations c = combinations_of(call);
    c.calls = c.calls < 2000 ? c.calls : 2000;
    double v[CALL_ARGUMENTS], out[CALL_OUTPUTS];
    uint64_t seed = 1;
    int32_t status;
    while (next(&c, v))
        complaint_of(call, v, out, &status);
    for (int k = 0; k < COMPUTED_CALLS; k++) {
        draw_computed(call, &seed, v);
        complaint_of(call, v, out, &status);
    }
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
        print_message("    %-25s %6zu bytes of stack\n", call.name, used);
        most = used > most ? used : most;
        own = used < own ? used : own;
    }
    assert_true(most > own && most - own < MOST_OF_STACK);
}
