/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tuned constants of computed loads and cracks (lib/base/tuned_register.h): each is halved
 * and doubled, and the loads of random histories are computed with it.
 *
 *     test_tuned HISTORIES [SEED]
 *
 * Each constant goes through the first FEW histories, and through the others only until one of them
 * moves. For each it prints how many histories that were; how many of their loads have another q,
 * by more than a hundredth of the tolerance; how many do not converge; the told error and the time,
 * on average over those of the register. A constant that moves no bit of q, of a told error, of an
 * energy, of slip in a cycle or of a crack buys nothing, and fails. */
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

enum { CONSTANTS = sizeof REGISTER / sizeof *REGISTER, LOADS = 4, PLACES = 41 };
enum { FEW = 6, MOST = 200 };

/* Of one load: q over f times the peak pressure, and the energy. */
typedef struct {
    double told, energy, q[PLACES];
    bool is_solved;
} outcome;

/* Of one history; the slip of its first loads as a cycle, the energy per area, and what becomes of
 * cracks. */
typedef struct {
    outcome load[LOADS];
    double slip[PLACES], energy[PLACES], growth[2][4], overlap[LOADS];
} answer;

typedef struct {
    answer history[MOST];
    double seconds[MOST];
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
    o->energy = rwedge_contact_dissipated_energy(contact);
    if (contact->phase == RW_APART)
        return;
    set_places(contact, x);
    assert_ok(rwedge_contact_tractions(contact, PLACES, x, p, o->q));
    for (int i = 0; i < PLACES; i++)
        peak = fmax(peak, -p[i]);
    for (int i = 0; i < PLACES; i++)
        o->q[i] /= f * peak;
    o->told = rwedge_contact_error(contact);
}

/* Of cracks at the edge, whose faces pass through each other or press. */
static void read_cracks(const rwedge_cycle *cycle, const rw_patch edges, answer *a)
{
    static const double LAW[] = {0.1, 2, 1e-3, 3, HUGE_VAL}, LENGTH = 0.05, LONG = 0.5;
    double K_I[LOADS], K_II[LOADS], (*g)[4] = a->growth;
    const double x = edges.left, angle = 0.3;
    rwedge_cycle_crack(cycle, x, angle, LOADS - 1, 1, &LENGTH, K_I, K_II, a->overlap);
    rwedge_cycle_growth(cycle, x, angle, RWEDGE_FACES_LOCKED, 5, LAW, LENGTH, LONG, &g[0][0],
                        &g[0][1], &g[0][2], &g[0][3]);
    rwedge_cycle_closing_growth(cycle, x, angle, RWEDGE_FACES_LOCKED, 5, LAW, LENGTH, LONG,
                                &g[1][0], &g[1][1], &g[1][2], &g[1][3]);
}

/* Every sixth history is a cycle too, and of another sixth its P and Q alone, in closed form. */
static void read_cycle(int history, const rwedge_contact *contact, const rw_loads load[], answer *a)
{
    double P[LOADS], M[LOADS] = {0}, Q[LOADS], sigma[LOADS] = {0};
    double x[PLACES], f1[PLACES], f2[PLACES];
    rwedge_cycle *cycle = NULL;
    for (int i = 0; i < LOADS - 1; i++) {
        P[i] = load[i].P;
        Q[i] = load[i].Q;
        M[i] = history % 6 == 0 ? load[i].M : 0;
        sigma[i] = history % 6 == 0 ? load[i].sigma : 0;
    }
    set_places(contact, x);
    if (rwedge_cycle_create(contact, LOADS - 1, P, M, Q, sigma, &cycle) == RWEDGE_OK)
        rwedge_cycle_friction(cycle, PLACES, x, a->slip, f1, f2, a->energy);
    if (cycle && history % 6 == 1)
        read_cracks(cycle, edges_of(contact), a);
    rwedge_cycle_destroy(cycle);
}

/* The last load: the bodies separate, or meet anew under all loads at once, or the line of the load
 * before goes on, in small and nearly straight steps. */
static bool end_line(int history, rwedge_contact *contact, rw_loads from, rw_loads to)
{
    static const rw_loads APART = {0, 0, 0, 0};
    const int kind = history / 3 % 3;
    bool is_solved = kind == 2 || try_load(contact, APART) == RWEDGE_OK;
    for (int i = 1; i <= 4 && kind == 2; i++) {
        rw_loads next = rw_loads_between(from, to, 1 - 0.02 * i);
        next.Q *= 1 + 0.1 * tolerance_of(history) * sign_and_size();
        is_solved = is_solved && try_load(contact, next) == RWEDGE_OK;
    }
    return is_solved && (kind != 1 || try_load(contact, to) == RWEDGE_OK);
}

/* P grows, M swings, or both stay; Q and tension at random. In every sixth history the bodies are
 * unlike. */
static void go(int history, answer *a)
{
    seed = (uint64_t)(history + 1) * UINT64_C(0x9e3779b97f4a7c15) + seed_or(1);
    const double f = 0.1 + 0.4 * (1 + sign_and_size());
    rwedge_contact *contact = history % 2 ? create_wedge(1, 1, 1, f) : create_flat(1, 10, 1, f);
    rw_loads loads[LOADS], to = {.P = 0.2 + 0.9 * (1 + sign_and_size())};
    allowing(contact, tolerance_of(history));
    if (history % 6 == 5)
        assert_ok(rwedge_contact_set_beta(contact, 0.25 * sign_and_size()));
    apply(contact, to.P, 0, 0, 0);
    const rwedge_contact *pressed = copy_of(contact);
    for (int i = 0; i < LOADS - 1; i++) {
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
        read_cycle(history, contact, loads, a);
    if (history % 6 == 1)
        read_cycle(history, pressed, loads, a);
    a->load[LOADS - 1].is_solved = end_line(history, contact, loads[LOADS - 3], to);
    read_outcome(contact, f, &a->load[LOADS - 1]);
}

static void run(int history, survey *s)
{
    const clock_t begun = clock();
    memset(&s->history[history], 0, sizeof *s->history);
    go(history, &s->history[history]);
    s->seconds[history] = (double)(clock() - begun) / CLOCKS_PER_SEC;
}

static double largest_difference(const outcome *a, const outcome *b)
{
    double most = 0;
    for (int i = 0; i < PLACES; i++)
        most = fmax(most, fabs(a->q[i] - b->q[i]));
    return most;
}

/* Prints a line. */
static void compare(const char *name, double times, int histories, const survey *usual,
                    const survey *other)
{
    int moved = 0, unsolved = 0, solved = 0;
    double told = 0, seconds = 0, usual_seconds = 0;
    for (int i = 0; i < histories; i++) {
        seconds += other->seconds[i];
        usual_seconds += usual->seconds[i];
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
    print_message("    %-24s %4g %9d %5d %8d %7.3f %7.3f\n", name, times, histories, moved,
                  unsolved, exp(told / fmax(1, solved)), seconds / usual_seconds);
}

static void multiply(constant c, double times)
{
    if (c.number)
        *c.number *= times;
    else
        *c.count = (int)(*c.count * times);
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* Whether any answer is another with so many times the constant. */
static bool moves(constant c, double times, int histories, const survey *usual, survey *other)
{
    const double number = c.number ? *c.number : 0;
    const int count = c.count ? *c.count : 0, few = least(FEW, histories);
    bool any = false;
    int done = 0;
    multiply(c, times);
    while (done < few || (done < histories && !any)) {
        run(done, other);
        any = any || memcmp(&usual->history[done], &other->history[done], sizeof(answer)) != 0;
        done++;
    }
    if (c.number)
        *c.number = number;
    else
        *c.count = count;
    compare(c.name, times, done, usual, other);
    return any;
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
    for (int i = 0; i < histories; i++)
        run(i, usual);
    print_message("    constant                times histories moved unsolved told    time\n");
    for (int i = 0; i < CONSTANTS; i++) {
        const bool is_less = moves(REGISTER[i], 0.5, histories, usual, other),
                   is_more = moves(REGISTER[i], 2, is_less ? least(FEW, histories) : histories,
                                   usual, other);
        if (!is_less && !is_more)
            print_message("    %s moves nothing\n", REGISTER[i].name);
        idle += !is_less && !is_more;
    }
    assert_int_equal(idle, 0);
}
