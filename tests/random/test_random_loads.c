/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads of P, M, Q and bulk tension at random, as tests and joints have them. They are computed
 * where there is no closed form. Each load is done or it does not converge. One that is done leaves
 * a shear that is finite and within friction; one that is not leaves the contact as it was, to the
 * last bit.
 *
 *     test_random_loads HISTORIES [SEED] [PATTERN]
 *
 * f = 0.1 to 1, A = 1. Of the rounded wedge (theta = a = 1) the mean P is 0.2 to 20, in the
 * logarithm: a/b from 0.1 to 3; of a flat pad and of a profile that is not symmetric, a tenth.
 * There are four kinds of history, of 24 loads after the first one, which is P and M alone:
 *   steps under constant P and M; steps of P too, by a tenth; steps of P and M, by P b/10;
 *   a log: Q and tension swing, one after the other, and all four scatter by up to 3 %.
 * |Q| is up to 0.95 f P, in every sixteenth load f P; |sigma| up to 4 f P/(pi b).
 * Each history has a seed of its own, SEED and those after it. A load that does not converge, or
 * takes longer than LONGEST, is told with the command that follows its history alone.
 *
 * The claim fails if more than one load in 10,000 does not converge, or if one takes more than
 * LONGEST seconds of the processor. Whether the error that is told is honest: test_random_errors.c.
 * What else a computed shear obeys: ../lib/contact/test_shear_laws.c. */
#include "computed/computed_load.h"
#include "histories.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { STEPS, STEPS_OF_P, STEPS_OF_ALL, LOG, KINDS };
enum { LOADS = 24, POINTS = 41, LOADS_PER_UNSOLVED = 10000 };

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
static const double LONGEST = 200;
#else
static const double LONGEST = 1;
#endif

static uint64_t seed;

/* What the loads have come to so far. */
static struct {
    long history, loads, computed, unsolved;
    double slowest, worst; /* load, in seconds of the processor; error that was told */
} tally;

typedef struct {
    int kind;
    double f, tolerance, swing, lag, scatter; /* swing: of Q over f P */
    rw_loads first;
    double b; /* under the first P */
    rwedge_contact *contact;
} programme;

static double sign_and_size(void)
{
    return random_between(&seed, -1, 1);
}

/* Of three pads. */
enum { PADS = 3 };

static rwedge_contact *create_pad(int pad, double f)
{
    const double x[] = {-1.2, -0.4, 0.1, 0.5, 1}, slope[] = {-1.2, -0.2, -0.1, 0.5, 1.5};
    rwedge_contact *contact;
    assert_ok(pad == 0   ? rwedge_contact_create(1, 1, 1, f, &contact)
              : pad == 1 ? rwedge_contact_create_flat(0.8, 3, 1, f, &contact)
                         : rwedge_contact_create_profile(5, x, slope, 1, f, &contact));
    return owned(contact);
}

static programme draw_programme(long history, int kind, int pad)
{
    programme p = {.kind = kind};
    tally.history = history;
    seed = (uint64_t)history;
    p.tolerance = random_fraction(&seed) < 0.5 ? 1e-3 : 1e-4;
    p.f = random_between(&seed, 0.1, 1);
    p.contact = create_pad(pad, p.f);
    p.first.P = (pad == 0 ? 0.2 : 0.02) * pow(100, random_fraction(&seed));
    apply(p.contact, p.first.P, 0, 0, 0);
    p.b = rwedge_contact_half_width(p.contact);
    p.first.M = 0.2 * p.first.P * p.b * sign_and_size();
    p.swing = random_between(&seed, 0, 0.95);
    p.lag = random_between(&seed, 0, PI);
    p.scatter = random_between(&seed, 0, 0.03);
    allowing(p.contact, p.tolerance);
    return p;
}

static rw_loads draw_loads(const programme *p, int number)
{
    const double reach = 4 * p->f * p->first.P / (PI * p->b), turn = 2 * PI * number / 16;
    rw_loads to = p->first;
    if (p->kind == LOG) {
        to.P *= 1 + p->scatter * sign_and_size();
        to.M += p->scatter * p->first.P * p->b * sign_and_size();
        to.Q = p->swing * p->f * p->first.P * (sin(turn) + p->scatter * sign_and_size());
        to.sigma = p->swing * reach * (sin(turn - p->lag) + p->scatter * sign_and_size());
        return to;
    }
    if (p->kind > STEPS)
        to.P *= 1 + 0.1 * sign_and_size();
    if (p->kind > STEPS_OF_P)
        to.M += 0.1 * p->first.P * p->b * sign_and_size();
    to.Q = p->f * to.P * (random_fraction(&seed) < 1.0 / 16 ? 1 : 0.95 * sign_and_size());
    to.sigma = reach * sign_and_size();
    return to;
}

static void assert_possible(const rwedge_contact *contact, double f)
{
    const rw_patch edges = edges_of(contact);
    const double error = rwedge_contact_error(contact);
    double x[POINTS], p[POINTS], q[POINTS], s[POINTS], peak = 0;
    assert_true(isfinite(error) && error >= 0);
    for (int i = 0; i < POINTS; i++)
        x[i] = (edges.left + edges.right) / 2 -
               (edges.right - edges.left) / 2 * cos(PI * (i + 0.5) / POINTS);
    assert_ok(rwedge_contact_tractions(contact, POINTS, x, p, q));
    for (int i = 0; i < POINTS; i++)
        peak = fmax(peak, -p[i]);
    for (int i = 0; i < POINTS; i++)
        if (!(fabs(q[i]) <= f * (-p[i] + (error + 1e-12) * peak)))
            fail_msg("x %.17g: q %g, f p %g, error %g", x[i], q[i], f * p[i], error * f * peak);
    if (error > 0 && rwedge_contact_slip(contact, POINTS, x, s) == RWEDGE_OK)
        for (int i = 0; i < POINTS; i++)
            assert_true(isfinite(s[i]));
}

static int32_t timed_apply(rwedge_contact *contact, rw_loads to)
{
    const clock_t start = clock();
    const int32_t status = rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    tally.slowest = fmax(tally.slowest, seconds);
    tally.loads++;
    tally.unsolved += status == RWEDGE_ENOCONV;
    if (status != RWEDGE_OK || seconds > LONGEST)
        print_message(
            "    test_random_loads 1 %ld: status %d after %.2f s at P %.17g M %.17g Q %.17g "
            "sigma %.17g\n",
            tally.history, (int)status, seconds, to.P, to.M, to.Q, to.sigma);
    return status;
}

static void go_to(rwedge_contact *contact, double f, rw_loads to)
{
    const contact_state before = state_of(contact);
    const double energy = rwedge_contact_dissipated_energy(contact);
    const int32_t status = timed_apply(contact, to);
    if (status == RWEDGE_ENOCONV) {
        assert_state(contact, before);
        return;
    }
    assert_ok(status);
    assert_possible(contact, f);
    const double after = rwedge_contact_dissipated_energy(contact);
    assert_true(!(after < energy) && !isinf(after));
    tally.computed += rwedge_contact_error(contact) > 0;
    tally.worst = fmax(tally.worst, rwedge_contact_error(contact));
}

CLAIM(loads_as_tests_have_them_are_done)
{
    const long first = (long)seed_or(3);
    for (long i = first; i < first + cases_or(6); i++) {
        const programme p = draw_programme(i, (int)(i % KINDS), (int)(i / KINDS % PADS));
        go_to(p.contact, p.f, p.first);
        for (int k = 1; k <= LOADS; k++)
            go_to(p.contact, p.f, draw_loads(&p, k));
    }
    print_message(
        "    %ld loads, %ld of them computed, %ld did not converge; the slowest took %.2f s, "
        "the largest error is %.1e\n",
        tally.loads, tally.computed, tally.unsolved, tally.slowest, tally.worst);
    assert_true(tally.unsolved <= tally.loads / LOADS_PER_UNSOLVED);
    assert_true(tally.slowest <= LONGEST);
}
