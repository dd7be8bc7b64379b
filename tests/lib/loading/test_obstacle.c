/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the contact says of a load that it refuses. */
#include "histories.h"

#include <string.h>

enum { PRESSING, SHEAR, TENSION, FARTHER, ANEW };

/* What the text may advise, and the loads that do it. */
static const struct {
    const char *words;
    int way;
} ADVICE[] = {
    {"apply it as two loads: first P and M, then Q and sigma", PRESSING},
    {"apply it as two loads: first Q and sigma, then P and M", SHEAR},
    {"change sigma by less", TENSION},
    {"go twice as far along the same straight line", FARTHER},
    {"then apply sigma with P = 0, then P and M, then Q", ANEW},
};

static int32_t follow(rwedge_contact *contact, int way, rw_loads to)
{
    const rw_loads now = contact->loads;
    const double most = rwedge_contact_largest_tension_step(contact, to.Q);
    int32_t status = RWEDGE_OK;
    if (way == PRESSING)
        status = try_load(contact, (rw_loads){to.P, to.M, now.Q, now.sigma});
    else if (way == SHEAR)
        status = try_load(contact, (rw_loads){now.P, now.M, to.Q, to.sigma});
    else if (way == TENSION) {
        const double change = to.sigma - now.sigma;
        assert_true(fabs(change) > 0);
        to.sigma = now.sigma + copysign(fmin(0.99 * most, fabs(change)), change);
    } else if (way == FARTHER)
        to = (rw_loads){2 * to.P - now.P, 2 * to.M - now.M, 2 * to.Q - now.Q,
                        2 * to.sigma - now.sigma};
    else {
        status = try_load(contact, (rw_loads){0, 0, 0, to.sigma});
        assert_ok(try_load(contact, (rw_loads){to.P, to.M, 0, to.sigma}));
    }
    return status == RWEDGE_OK ? try_load(contact, to) : status;
}

/* The advice for a load that is refused, after it was followed. */
static int advice_for(const rwedge_contact *contact, rw_loads to)
{
    const char *text = rwedge_contact_obstacle(contact, to.P, to.M, to.Q, to.sigma);
    for (size_t i = 0; i < sizeof ADVICE / sizeof *ADVICE; i++) {
        if (!strstr(text, ADVICE[i].words))
            continue;
        rwedge_contact *trial = copy_of(contact);
        assert_ok(follow(trial, ADVICE[i].way, to));
        return ADVICE[i].way;
    }
    fail_msg("no advice in \"%s\"", text);
    return -1;
}

static rw_loads next_loads(const rwedge_contact *contact, double f, uint64_t *seed)
{
    rw_loads to = contact->loads;
    if (to.P == 0 || random_fraction(seed) < 0.3) {
        to.P = random_between(seed, 0.3, 1);
        to.M = random_between(seed, -0.3, 0.3) * to.P;
    }
    to.Q = random_between(seed, -0.9, 0.9) * f * to.P;
    if (random_fraction(seed) < 0.7)
        to.sigma +=
            random_between(seed, -1.2, 1.2) * rwedge_contact_largest_tension_step(contact, to.Q);
    return to;
}

/* Every advice comes up, and what it says leads there, on the very history. */
CLAIM(advice_leads_there)
{
    const double f = 0.5;
    uint64_t seed = 7;
    int times[5] = {0};
    for (int number = 0; number < 60; number++) {
        rwedge_contact *contact = create(0.2 * (number % 4), f);
        if (number % 3 > 0)
            assert_ok(try_load(contact, (rw_loads){0.5, 0.05 * (number % 5), 0, 0}));
        for (int i = 0; i < 8; i++) {
            const rw_loads to = next_loads(contact, f, &seed);
            if (try_load(contact, to) == RWEDGE_EPATH)
                times[advice_for(contact, to)]++;
        }
    }
    for (int i = 0; i < 5; i++)
        assert_true(times[i] > 0);
}

/* A load that one says to be in the way of slip, although it is one of Q and sigma alone. */
CLAIM(a_load_of_q_and_sigma_is_not_told_to_be_one)
{
    rwedge_contact *contact = create(0.4, 0.5);
    assert_ok(try_load(contact, (rw_loads){0.5, 0.1, 0, 0}));
    const rw_loads to = {0.5, 0.1, 0.1, 1};
    assert_int_equal(advice_for(contact, to), TENSION);
}
