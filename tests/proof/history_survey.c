/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random histories without a closed form: four loads each after the first, of Q and tension, in
 * every other one of P and M too. Each load is done or refused as a whole. The shear is finite,
 * within friction, and adds up to Q. The error that is told is held against a contact that goes
 * there in twenty parts, the shorter the earlier, to a hundredth of the tolerance. Within a
 * hundredth of the half-width of a front of slip, at or within any of the loads, it is not: q rises
 * there like a root.
 *
 *     history_survey HISTORIES [SEED]
 *
 * The exit status is 1 where a claim fails, or where the error that is told is not between the true
 * one and 30 times that in 9 of 10 histories, but for one. A tenth of the tolerance counts as none.
 */
#include "claims.h"
#include "contact/contact.h"
#include "contact/numerical.h"
#include "rwedge.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double TOLERANCE = 1e-3;

/* One load may take, in seconds: an unoptimised build, a slow machine. */
static const double LONGEST = 30;

enum { LOADS = 4, POINTS = 400 };

typedef struct {
    double P, M, Q, sigma;
} loads;

static int faults, unsolved;
static double slowest;

static void claim(bool holds, long history, const char *complaint)
{
    if (holds)
        return;
    faults++;
    printf("history %ld: %s\n", history, complaint);
}

static double signed_fraction(uint64_t *state)
{
    return 2 * random_fraction(state) - 1;
}

static rwedge_contact *new_contact(double a, double f, double tolerance, double P)
{
    rwedge_contact *contact = NULL;
    if (rwedge_contact_create(1, a, 1, f, &contact) != RWEDGE_OK ||
        rwedge_contact_allow_error(contact, tolerance) != RWEDGE_OK ||
        rwedge_contact_apply(contact, P, 0, 0, 0) != RWEDGE_OK)
        exit(1);
    return contact;
}

/* In a straight line, to these parts of it; whether it was done. A refused load changes nothing. */
static bool go(rwedge_contact *contact, loads to, int parts, const double part[], long history)
{
    loads from, now;
    rwedge_contact_loads(contact, &from.P, &from.M, &from.Q, &from.sigma);
    for (int i = 0; i < parts; i++) {
        const double u = part[i];
        const loads at =
            u == 1
                ? to
                : (loads){from.P + u * (to.P - from.P), from.M + u * (to.M - from.M),
                          from.Q + u * (to.Q - from.Q), from.sigma + u * (to.sigma - from.sigma)};
        loads before;
        rwedge_contact_loads(contact, &before.P, &before.M, &before.Q, &before.sigma);
        const clock_t start = clock();
        const int32_t status = rwedge_contact_apply(contact, at.P, at.M, at.Q, at.sigma);
        slowest = fmax(slowest, (double)(clock() - start) / CLOCKS_PER_SEC);
        rwedge_contact_loads(contact, &now.P, &now.M, &now.Q, &now.sigma);
        claim(status == RWEDGE_OK || status == RWEDGE_ENOCONV, history, "another status");
        if (status != RWEDGE_OK) {
            claim(now.Q == before.Q && now.sigma == before.sigma, history, "a changed contact");
            unsolved++;
            return false;
        }
    }
    return true;
}

/* 1/256 ... 1/32, then 1/16 ... 1. */
enum { PARTS = 20 };

static void set_parts(double part[])
{
    for (int i = 0; i < PARTS; i++)
        part[i] = i < 4 ? ldexp(1, i - 8) : (i - 3) / 16.0;
}

/* Where fronts are, or have been: a front that turned within a load has left a kink. */
typedef struct {
    int count;
    double at[2 * LOADS * (RW_MOST_ZONES + RW_MOST_KINKS)];
} fronts;

static void note_fronts(const rwedge_contact *contact, fronts *f)
{
    double left[RW_MOST_ZONES], right[RW_MOST_ZONES], slip[RW_MOST_ZONES];
    const size_t n = rwedge_contact_zone_count(contact);
    if (rwedge_contact_zones(contact, n, left, right, slip) == RWEDGE_OK)
        for (size_t i = 0; i + 1 < n; i++)
            f->at[f->count++] = right[i];
    const rw_shear_state *shear = contact->numerical ? &contact->numerical->now.shear : NULL;
    for (int i = 0; shear && i < shear->kinks; i++)
        f->at[f->count++] = shear->kink[i];
}

typedef struct {
    double left, right, peak;
    double x[POINTS], q[POINTS];
} shear;

static void look(const rwedge_contact *contact, double f, double Q, long history, shear *s)
{
    double sum = 0, p;
    s->peak = 0;
    rwedge_contact_edges(contact, &s->left, &s->right);
    const double middle = (s->left + s->right) / 2, half = (s->right - s->left) / 2;
    for (int i = 0; i < POINTS; i++) {
        const double angle = PI * (i + 0.5) / POINTS;
        s->x[i] = middle - half * cos(angle);
        rwedge_contact_tractions(contact, 1, &s->x[i], &p, &s->q[i]);
        claim(isfinite(s->q[i]), history, "not finite");
        s->peak = fmax(s->peak, -p);
        sum -= s->q[i] * half * sin(angle) * PI / POINTS;
    }
    for (int i = 0; i < POINTS; i++) {
        rwedge_contact_tractions(contact, 1, &s->x[i], &p, &s->q[i]);
        claim(fabs(s->q[i]) <= f * (-p + 2 * TOLERANCE * s->peak), history, "beyond friction");
    }
    claim(fabs(sum - Q) <= 1e-2 * f * s->peak * half, history, "out of balance");
}

static bool is_at_front(const fronts *f, const shear *s, double x)
{
    bool is_near = false;
    for (int i = 0; i < f->count; i++)
        is_near = is_near || fabs(x - f->at[i]) < 0.01 * (s->right - s->left) / 2;
    return is_near;
}

static bool is_honest(const rwedge_contact *contact, const rwedge_contact *better,
                      const fronts *seen, double f, double Q, long history)
{
    shear coarse, fine;
    double error = 0;
    look(contact, f, Q, history, &coarse);
    look(better, f, Q, history, &fine);
    for (int i = 0; i < POINTS; i++)
        if (!is_at_front(seen, &coarse, coarse.x[i]))
            error = fmax(error, fabs(coarse.q[i] - fine.q[i]));
    error /= f * coarse.peak;
    const double told = rwedge_contact_error(contact), own = rwedge_contact_error(better);
    const bool holds =
        told >= error - own - 1e-12 && told <= 30 * fmax(error + own, TOLERANCE / 10);
    if (!holds)
        printf("history %ld: told %.1e, true %.1e to %.1e\n", history, told, error, own);
    return holds;
}

static bool survey(long history, uint64_t seed)
{
    uint64_t state = seed + (uint64_t)history;
    for (int i = 0; i < 4; i++)
        random_fraction(&state);
    const double f = 0.2 + 0.6 * random_fraction(&state), a = 0.3 + 1.5 * random_fraction(&state);
    const double P = 2 + 2 * random_fraction(&state);
    const bool is_still = history % 2 == 0;
    rwedge_contact *contact = new_contact(a, f, TOLERANCE, P);
    rwedge_contact *better = new_contact(a, f, TOLERANCE / 100, P);
    fronts seen = {0};
    const double whole = 1;
    double part[PARTS];
    set_parts(part);
    bool holds = true;
    loads to = {P, 0, 0, 0};
    for (int i = 0; i < LOADS; i++) {
        const double b = rwedge_contact_half_width(contact);
        to.P = is_still ? P : P * (0.9 + 0.2 * random_fraction(&state));
        to.M = is_still ? 0 : 0.1 * to.P * b * signed_fraction(&state);
        to.Q = 0.9 * f * to.P * signed_fraction(&state);
        to.sigma = 4.8 * f * to.P / (PI * b) * signed_fraction(&state);
        if (!go(contact, to, 1, &whole, history) || !go(better, to, PARTS, part, history))
            break;
        note_fronts(contact, &seen);
        note_fronts(better, &seen);
        if (i + 1 == LOADS)
            holds = is_honest(contact, better, &seen, f, to.Q, history);
    }
    rwedge_contact_destroy(contact);
    rwedge_contact_destroy(better);
    return holds;
}

int main(int argc, char **argv)
{
    const long histories = argc > 1 ? atol(argv[1]) : 0;
    const uint64_t seed = argc > 2 ? (uint64_t)atol(argv[2]) : 1;
    long honest = 0;
    if (histories < 1 || argc > 3) {
        fprintf(stderr, "usage: history_survey HISTORIES [SEED]\n");
        return 2;
    }
    for (long i = 0; i < histories; i++)
        honest += survey(i, seed);
    printf("%ld histories: %ld told an honest error, %d loads unsolved, the slowest %.2f s\n",
           histories, honest, unsolved, slowest);
    return faults > 0 || unsolved > histories / 10 || slowest > LONGEST ||
           (double)honest < 0.9 * (double)histories - 1;
}
