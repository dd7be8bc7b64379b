/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tuned constants of computed loads (lib/base/tuned_register.h): each is halved and doubled,
 * and the loads of random histories are computed with it.
 *
 *     test_tuned HISTORIES [SEED]
 *
 * For each it prints, of all loads: how many have another q, by more than a hundredth of the
 * tolerance; how many do not converge; the told error and the time, on average over those of the
 * register. A constant that moves no bit of q, of a told error, of an energy or of slip in a cycle
 * buys nothing, and fails. */
#define RW_NUMBER(name, value) double name = value;
#define RW_COUNT(name, value) int name = value;
#include "base/tuned_register.h"
#undef RW_NUMBER
#undef RW_COUNT

#include "histories.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    const char *name;
    double *number;
    int *count;
} constant;

#define RW_NUMBER(name, value) {#name, &name, NULL},
#define RW_COUNT(name, value) {#name, NULL, &name},
static const constant REGISTER[] = {
#include "base/tuned_register.h"
};
#undef RW_NUMBER
#undef RW_COUNT

enum { CONSTANTS = sizeof REGISTER / sizeof *REGISTER, LOADS = 3, PLACES = 41, MOST = 200 };

/* Of one load: q over f times the peak pressure, and the energy. */
typedef struct {
    double told, energy, q[PLACES];
    bool is_solved;
} outcome;

/* Of one history; the slip of its loads as a cycle. */
typedef struct {
    outcome load[LOADS];
    double slip[PLACES];
} answer;

typedef struct {
    answer history[MOST];
    double seconds;
} survey;

static uint64_t seed;

static double sign_and_size(void)
{
    return random_between(&seed, -1, 1);
}

static double tolerance_of(int history)
{
    static const double TOLERANCE[] = {1e-2, 1e-3, 1e-4};
    return TOLERANCE[history % 3];
}

static void set_places(const rwedge_contact *contact, double x[])
{
    const rw_patch edges = edges_of(contact);
    for (int i = 0; i < PLACES; i++)
        x[i] = rw_patch_middle(edges) - rw_patch_half_width(edges) * cos(PI * (i + 0.5) / PLACES);
}

static void read_outcome(const rwedge_contact *contact, double f, outcome *o)
{
    double x[PLACES], p[PLACES], peak = 0;
    set_places(contact, x);
    assert_ok(rwedge_contact_tractions(contact, PLACES, x, p, o->q));
    for (int i = 0; i < PLACES; i++)
        peak = fmax(peak, -p[i]);
    for (int i = 0; i < PLACES; i++)
        o->q[i] /= f * peak;
    o->told = rwedge_contact_error(contact);
    o->energy = rwedge_contact_dissipated_energy(contact);
}

/* Every sixth history is a cycle too. */
static void read_slip(const rwedge_contact *contact, const rw_loads load[], double slip[])
{
    double P[LOADS], M[LOADS], Q[LOADS], sigma[LOADS];
    double x[PLACES], f1[PLACES], f2[PLACES], energy[PLACES];
    rwedge_cycle *cycle = NULL;
    for (int i = 0; i < LOADS; i++) {
        P[i] = load[i].P;
        M[i] = load[i].M;
        Q[i] = load[i].Q;
        sigma[i] = load[i].sigma;
    }
    set_places(contact, x);
    if (rwedge_cycle_create(contact, LOADS, P, M, Q, sigma, &cycle) == RWEDGE_OK)
        rwedge_cycle_friction(cycle, PLACES, x, slip, f1, f2, energy);
    rwedge_cycle_destroy(cycle);
}

/* P grows, M swings, or both stay; Q and tension at random. */
static void go(int history, answer *a)
{
    seed = (uint64_t)(history + 1) * UINT64_C(0x9e3779b97f4a7c15) + seed_or(1);
    const double f = 0.1 + 0.4 * (1 + sign_and_size());
    rwedge_contact *contact = history % 2 ? create_wedge(1, 1, 1, f) : create_flat(1, 10, 1, f);
    rw_loads loads[LOADS], to = {.P = 0.2 + 0.9 * (1 + sign_and_size())};
    allowing(contact, tolerance_of(history));
    apply(contact, to.P, 0, 0, 0);
    for (int i = 0; i < LOADS; i++) {
        const double b = rwedge_contact_half_width(contact);
        to.P *= history % 4 < 2 ? 1 + 0.7 * (1 + sign_and_size()) : 1;
        to.M = history % 4 == 2 ? 0.4 * to.P * b * sign_and_size() : 0;
        to.Q = 0.95 * f * to.P * sign_and_size();
        to.sigma = 3.8 * f * to.P / (PI * b) * sign_and_size();
        a->load[i].is_solved = try_load(contact, to) == RWEDGE_OK;
        read_outcome(contact, f, &a->load[i]);
        loads[i] = to;
    }
    if (history % 6 == 0)
        read_slip(contact, loads, a->slip);
}

static void run(int histories, survey *s)
{
    const clock_t begun = clock();
    for (int i = 0; i < histories; i++)
        go(i, &s->history[i]);
    s->seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
}

static double largest_difference(const outcome *a, const outcome *b)
{
    double most = 0;
    for (int i = 0; i < PLACES; i++)
        most = fmax(most, fabs(a->q[i] - b->q[i]));
    return most;
}

/* Prints a line. Whether anything moved. */
static bool moves(const char *name, double times, int histories, const survey *usual,
                  const survey *other)
{
    int moved = 0, unsolved = 0, solved = 0;
    double told = 0;
    bool any = false;
    for (int i = 0; i < histories; i++) {
        any = any || memcmp(&usual->history[i], &other->history[i], sizeof(answer)) != 0;
        for (int k = 0; k < LOADS; k++) {
            const outcome *a = &usual->history[i].load[k], *b = &other->history[i].load[k];
            moved += largest_difference(a, b) > tolerance_of(i) / 100;
            unsolved += !b->is_solved;
            if (a->told > 0 && b->told > 0) {
                told += log(b->told / a->told);
                solved++;
            }
        }
    }
    print_message("    %-24s %4g %5d %5d %7.3f %7.3f%s\n", name, times, moved, unsolved,
                  exp(told / fmax(1, solved)), other->seconds / usual->seconds,
                  any ? "" : "  nothing");
    return any;
}

static void multiply(constant c, double times)
{
    if (c.number)
        *c.number *= times;
    else
        *c.count = (int)(*c.count * times);
}

CLAIM(each_tuned_constant_buys_something)
{
    const int histories = (int)fmin(MOST, (double)cases_or(24));
    survey *usual = calloc(1, sizeof *usual), *other = calloc(1, sizeof *other);
    int idle = 0;
    free_after_claim(usual, free);
    free_after_claim(other, free);
    assert_non_null(usual);
    assert_non_null(other);
    run(histories, usual);
    print_message("    constant                times moved unsolved told    time\n");
    for (int i = 0; i < CONSTANTS; i++) {
        bool any = false;
        for (int way = 0; way < 2; way++) {
            const double times = way ? 2 : 0.5;
            const double number = REGISTER[i].number ? *REGISTER[i].number : 0;
            const int count = REGISTER[i].count ? *REGISTER[i].count : 0;
            multiply(REGISTER[i], times);
            run(histories, other);
            if (REGISTER[i].number)
                *REGISTER[i].number = number;
            else
                *REGISTER[i].count = count;
            any = moves(REGISTER[i].name, times, histories, usual, other) || any;
        }
        idle += !any;
    }
    assert_int_equal(idle, 0);
}
