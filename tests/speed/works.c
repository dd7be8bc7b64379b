/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "works.h"

#include "rwedge.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 20000, PAPER_LIMITS = 650, CYCLE_LOADS = 40, PLACES = 1000 };

static const double TURN = 2 * 3.14159265358979323846, P = 20000;

double xs[MANY], ys[MANY], out[3][MANY];
static double cycle[3][CYCLE_LOADS * PLACES]; /* stresses of a cycle of Q at the first places */

static void must(int32_t status)
{
    if (status == RWEDGE_OK)
        return;
    fprintf(stderr, "a call whose time was to be taken: %s\n", rwedge_strerror(status));
    exit(1);
}

/* ---- Stresses; `first` is c/b, 0 in full sliding ---- */

static double array_of_points(const work *w)
{
    must(rwedge_stresses(0.3, 0.4, w->first, (size_t)w->n, xs, ys, out[0], out[1], out[2]));
    return out[0][0] + out[2][w->n - 1];
}

static double points_one_by_one(const work *w)
{
    double sum = 0;
    for (long i = 0; i < w->n; i++) {
        double sxx, syy, txy;
        must(rwedge_stress(0.3, 0.4, w->first, xs[i], ys[i], &sxx, &syy, &txy));
        sum += sxx + syy + txy;
    }
    return sum;
}

/* The paper's series, 60 terms that are not 0: what others are compared with. */
static double points_by_the_series(const work *w)
{
    rwedge_series *series;
    double sum = 0;
    must(rwedge_series_create(0.3, 120, &series));
    for (long i = 0; i < w->n; i++) {
        double sxx, syy, txy;
        must(rwedge_series_stress(series, 0.4, xs[i], ys[i], &sxx, &syy, &txy));
        sum += sxx + syy + txy;
    }
    rwedge_series_destroy(series);
    return sum;
}

static double pressures(const work *w)
{
    double sum = 0;
    for (long i = 0; i < w->n; i++)
        sum += rwedge_pressure(0.3, (double)i / (double)w->n);
    return sum;
}

/* ---- Elastic limits, every call cold ---- */

/* The i-th contact of the paper's table, a/b = 0.1 ... 1, f = 0 ... 0.8, in an order in which a few
 * are of all kinds. */
static double case_of(long i, double *f)
{
    enum { FRICTIONS = 65, STEP = 77 }; /* the step has no divisor of 650 */
    const long k = STEP * i % PAPER_LIMITS;
    *f = 0.0125 * (double)(k % FRICTIONS);
    return (double)(k / FRICTIONS + 1) / 10;
}

static double limits_one_by_one(const work *w)
{
    double sum = 0, f;
    for (long i = 0; i < w->n; i++) {
        const double alpha = case_of(i, &f);
        sum += rwedge_elastic_limit(alpha, f, 0.3);
    }
    return sum;
}

static double shakedown_limits(const work *w)
{
    double sum = 0, f, limit, y;
    for (long i = 0; i < w->n; i++) {
        const double alpha = case_of(i, &f);
        must(rwedge_shakedown_limit(alpha, f, 0.3, &limit, &y));
        sum += limit;
    }
    return sum;
}

static double limits_in_array(const work *w)
{
    for (long i = 0; i < w->n; i++)
        out[0][i] = case_of(i, &out[1][i]);
    must(rwedge_elastic_limits((size_t)w->n, out[0], out[1], 0.3, out[2]));
    return out[2][w->n - 1];
}

/* ---- Contacts ---- */

static rwedge_contact *new_contact(void)
{
    rwedge_contact *contact;
    must(rwedge_contact_create(0.05, 1, 1.82e-5, 0.6, &contact));
    return contact;
}

static rwedge_contact *new_flat(void)
{
    rwedge_contact *contact;
    must(rwedge_contact_create_flat(0.5, 20, 1.82e-5, 0.6, &contact));
    return contact;
}

/* 99 arcs in contact. */
static rwedge_contact *new_profile(void)
{
    enum { CORNERS = 100 };
    rwedge_contact *contact;
    double x[CORNERS], slope[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        x[i] = 2.0 * i / (CORNERS - 1) - 1;
        slope[i] = i == 0 ? -0.1 : slope[i - 1] + 0.004 * fmod(i * 0.6180339887498949, 1);
    }
    must(rwedge_contact_create_profile(CORNERS, x, slope, 1.82e-5, 0.6, &contact));
    return contact;
}

/* After one step of Q to 0.3 P, at so many points; the contact is destroyed. */
static double points_of(rwedge_contact *contact, double load, long n)
{
    must(rwedge_contact_load(contact, load, 0));
    must(rwedge_contact_load(contact, load, 0.3 * load));
    must(rwedge_contact_stresses(contact, (size_t)n, xs, ys, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][n - 1];
}

static double points_of_a_flat_pad(const work *w)
{
    return points_of(new_flat(), w->first, w->n);
}

static double points_of_a_profile(const work *w)
{
    return points_of(new_profile(), w->first, w->n);
}

/* It remembers as many corners: reversals of Q, each smaller than all before. */
static rwedge_contact *worn_contact(double corners, double M)
{
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_apply(contact, P, M, 0, 0));
    for (int i = 1; i < corners; i++)
        must(rwedge_contact_load(contact, P,
                                 (i % 2 ? 0.9 : -0.9) * 12000 * (1 - i / (corners + 1))));
    return contact;
}

static double points_of_corners(const work *w)
{
    rwedge_contact *contact = worn_contact(w->first, w->second);
    must(rwedge_contact_stresses(contact, (size_t)w->n, xs, ys, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0];
}

static double yield_factors_of(rwedge_contact *contact, long n)
{
    double sum = 0, factor;
    for (long i = 0; i < n; i++) {
        must(rwedge_contact_yield_factor(contact, 0.3, 100, &factor, NULL, NULL));
        sum += factor;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

static double yield_factors(const work *w)
{
    return yield_factors_of(worn_contact(w->first, w->second), w->n);
}

/* Loads that grow, each remembered because Q/f bends. */
static double growing_loads(const work *w)
{
    rwedge_contact *contact = new_contact();
    for (long i = 1; i <= w->n; i++)
        must(rwedge_contact_load(contact, (double)i, 0.1 * (double)(i + i % 2)));
    const double memory = (double)rwedge_contact_memory(contact);
    rwedge_contact_destroy(contact);
    return memory;
}

/* ---- Loads without a closed form ---- */

/* The tension lags behind Q by an eighth of a cycle; to the tolerance `first`. P, Q and tension
 * scatter by `second`. */
static double lagging(const work *w)
{
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_allow_error(contact, w->first));
    must(rwedge_contact_load(contact, P, 0));
    for (long i = 1; i <= w->n; i++) {
        const double phase = TURN * (double)i / 48;
        const double noise = w->second * (fmod((double)i * 0.6180339887498949, 1) - 0.5);
        const double Q = 9000 * (sin(phase) - noise);
        must(rwedge_contact_apply(contact, P * (1 + noise), 0, Q,
                                  2000 * (sin(phase - TURN / 8) + noise)));
    }
    const double error = rwedge_contact_error(contact);
    rwedge_contact_destroy(contact);
    return error;
}

/* The tension has lagged for a quarter of a cycle. Along the surface where `first` is 0. */
static double computed_points(const work *w)
{
    static double line[POINTS];
    static const double surface[POINTS] = {0};
    const bool is_along = w->first == 0;
    rwedge_contact *contact = new_contact();
    for (int i = 0; i < POINTS; i++)
        line[i] = 4.0 * i / POINTS - 2;
    must(rwedge_contact_allow_error(contact, 1e-4));
    must(rwedge_contact_load(contact, P, 0));
    for (int i = 1; i <= 12; i++)
        must(rwedge_contact_apply(contact, P, 0, 9000 * sin(TURN * i / 48),
                                  2000 * sin(TURN * (i - 6) / 48)));
    for (long i = 0; i < w->n; i += POINTS)
        must(rwedge_contact_stresses(contact, POINTS, is_along ? line : xs + i,
                                     is_along ? surface : ys + i, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0];
}

/* ---- Stresses through a history ---- */

enum { MOST_LOADS = 2000 };
static double loads[4][MOST_LOADS]; /* P, M, Q, sigma */

/* Of Q alone; under a moment, with tension in phase; with tension that lags; or reversals, each
 * smaller than all before, so that all are remembered. */
enum { OF_Q, IN_PHASE, LAGGING, REVERSALS };

static void set_loads(double kind, long count)
{
    for (long i = 0; i < count; i++) {
        const double turn = TURN * (double)i / (double)count;
        const double left = 1 - (double)i / ((double)count + 1);
        loads[0][i] = P;
        loads[1][i] = kind == IN_PHASE ? 3000 : 0;
        loads[2][i] = kind == REVERSALS ? (i % 2 ? 10800 : -10800) * left : 9000 * sin(turn);
        loads[3][i] = kind == IN_PHASE  ? 100 * sin(turn)
                      : kind == LAGGING ? 2000 * sin(turn - TURN / 8)
                                        : 0;
    }
}

static rwedge_contact *before_history(double kind, long count)
{
    rwedge_contact *contact = new_contact();
    set_loads(kind, count);
    must(rwedge_contact_allow_error(contact, kind == LAGGING ? 1e-4 : 0));
    must(rwedge_contact_apply(contact, P, loads[1][0], 0, 0));
    return contact;
}

/* Twice, because the first cycle is not a closed one; at so many points the second time. */
static double history_by_calls(const work *w)
{
    const long count = w->n / (long)w->second;
    rwedge_contact *contact = before_history(w->first, count);
    for (long i = 0; i < 2 * count; i++) {
        const long k = i % count;
        must(rwedge_contact_apply(contact, loads[0][k], loads[1][k], loads[2][k], loads[3][k]));
        if (i >= count)
            must(rwedge_contact_stresses(contact, (size_t)w->second, xs, ys, out[0], out[1],
                                         out[2]));
    }
    rwedge_contact_destroy(contact);
    return out[0][0];
}

static double history(const work *w)
{
    const long count = w->n / (long)w->second;
    rwedge_contact *contact = before_history(w->first, count);
    for (int i = 0; i < 2; i++)
        must(rwedge_contact_stress_history(contact, (size_t)count, loads[0], loads[1], loads[2],
                                           loads[3], (size_t)i * (size_t)w->second, xs, ys, out[0],
                                           out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0];
}

/* ---- Cracks in a cycle of P and Q: 48 loads, 50 lengths, 97 places ---- */

enum { CRACK_LOADS = 48, LENGTHS = 50, LINE = 97, ON_CRACKS = LENGTHS * LINE };

static rwedge_cycle *cycle_of_cracks(double *edge, double length[])
{
    double right;
    rwedge_cycle *steady;
    rwedge_contact *contact = before_history(OF_Q, CRACK_LOADS);
    for (size_t i = 0; i < CRACK_LOADS; i++)
        must(rwedge_contact_apply(contact, P, 0, loads[2][i], 0));
    must(rwedge_contact_edges(contact, edge, &right));
    must(
        rwedge_cycle_create(contact, CRACK_LOADS, loads[0], loads[1], loads[2], loads[3], &steady));
    rwedge_contact_destroy(contact);
    for (int j = 0; j < LENGTHS; j++)
        length[j] = 0.01 * pow(1.1, j);
    return steady;
}

static double stresses_on_cracks(const work *w)
{
    static double x[ON_CRACKS], y[ON_CRACKS];
    double edge, length[LENGTHS];
    rwedge_cycle *steady = cycle_of_cracks(&edge, length);
    for (int i = 0; i < ON_CRACKS; i++) {
        x[i] = edge;
        y[i] = length[i / LINE] * pow(cos(TURN / 4 * (i % LINE) / (LINE - 0.5)), 14);
    }
    must(rwedge_cycle_stresses(steady, CRACK_LOADS, (size_t)w->n / CRACK_LOADS, x, y, out[0],
                               out[1], out[2]));
    rwedge_cycle_destroy(steady);
    return out[0][0];
}

static double cracks(const work *w)
{
    double edge, length[LENGTHS];
    rwedge_cycle *steady = cycle_of_cracks(&edge, length);
    must(rwedge_cycle_crack(steady, edge, 0, CRACK_LOADS, (size_t)w->n / CRACK_LOADS / LINE, length,
                            out[0], out[1], out[2]));
    rwedge_cycle_destroy(steady);
    return out[0][0];
}

static double closing_cracks(const work *w)
{
    double edge, length[LENGTHS];
    rwedge_cycle *steady = cycle_of_cracks(&edge, length);
    must(rwedge_cycle_closing_crack(steady, edge, 0, CRACK_LOADS, (size_t)w->n / CRACK_LOADS / LINE,
                                    length, out[0], out[1], out[2]));
    rwedge_cycle_destroy(steady);
    return out[0][0];
}

/* ---- A cycle that stays in place: its bounds of shakedown, and where its wear ends ---- */

static double bounds_of_cycles(const work *w)
{
    double edge, length[LENGTHS], lower, upper, x, y, sum = 0;
    rwedge_cycle *steady = cycle_of_cracks(&edge, length);
    for (long i = 0; i < w->n; i++) {
        must(rwedge_cycle_shakedown(steady, 0.3, 300, &lower, &upper, &x, &y));
        sum += lower + upper;
    }
    rwedge_cycle_destroy(steady);
    return sum;
}

static double ends_of_wear(const work *w)
{
    double left, right, worn_left, worn_right, area, sum = 0;
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_load(contact, P, 0));
    for (long i = 0; i < w->n; i++) {
        const double Q_a = 0.6 * P * (0.1 + 0.8 * (double)i / (double)w->n);
        must(rwedge_contact_worn_zone(contact, Q_a, &left, &right, &worn_left, &worn_right, &area));
        sum += area;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

/* ---- Criteria of that cycle ---- */

static double value[PLACES], angle[PLACES], azimuth[PLACES];

static double criterion(const work *w)
{
    const int32_t number = (int32_t)w->first;
    const int is_of_strain = number == RWEDGE_MEASURE_SWT || number == RWEDGE_MEASURE_SWT_IN_PLANE;
    const double constants[] = {is_of_strain ? 110000 : 0.3};
    must(rwedge_criterion_field(number, constants, CYCLE_LOADS, (size_t)w->n, cycle[0], cycle[1],
                                cycle[2], 0.33, 0, value, angle, azimuth));
    return value[0];
}

/* ---- Full sliding of bodies with the Dundurs' beta `first` ---- */

static rwedge_contact *sliding(double beta)
{
    rwedge_contact *contact = new_contact();
    must(rwedge_contact_set_beta(contact, beta));
    must(rwedge_contact_load(contact, P, 0.6 * P));
    return contact;
}

static double points_that_slide(const work *w)
{
    rwedge_contact *contact = sliding(w->first);
    must(rwedge_contact_stresses(contact, (size_t)w->n, xs, ys, out[0], out[1], out[2]));
    rwedge_contact_destroy(contact);
    return out[0][0] + out[2][w->n - 1];
}

static double single_points_that_slide(const work *w)
{
    rwedge_contact *contact = sliding(w->first);
    double sum = 0;
    for (long i = 0; i < w->n; i++) {
        double sxx, syy, txy;
        must(rwedge_contact_stresses(contact, 1, xs + i, ys + i, &sxx, &syy, &txy));
        sum += sxx + syy + txy;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

static double yield_factors_that_slide(const work *w)
{
    return yield_factors_of(sliding(w->first), w->n);
}

static double shakedown_factors_that_slide(const work *w)
{
    rwedge_contact *contact = sliding(w->first);
    double sum = 0, factor, y;
    for (long i = 0; i < w->n; i++) {
        must(rwedge_contact_shakedown_factor(contact, 0.3, 100, &factor, &y));
        sum += factor;
    }
    rwedge_contact_destroy(contact);
    return sum;
}

/* The paper's contacts, held. */
static double sliding_limits(const work *w)
{
    double sum = 0, f, limit, x, y;
    for (long i = 0; i < w->n; i++) {
        const double alpha = case_of(i, &f);
        must(rwedge_sliding_limit(alpha, w->first * f, f, 0.3, 1, &limit, &x, &y));
        sum += limit;
    }
    return sum;
}

/* With the largest tension. */
static double sliding_laws(const work *w)
{
    double sum = 0, f, load, middle, tilt, tension;
    for (long i = 0; i < w->n; i++) {
        const double alpha = case_of(i, &f);
        must(rwedge_sliding_law(alpha, w->first * f, 1, &load, &middle, &tilt, &tension));
        sum += tension;
    }
    return sum;
}

const work works[] = {
    {"stress by the series of 60 terms", points_by_the_series, 0, 0, POINTS},
    {"stress at a point, full sliding", points_one_by_one, 0, 0, POINTS},
    {"stress at a point, partial slip", points_one_by_one, 0.4, 0, POINTS},
    {"stress in an array, full sliding", array_of_points, 0, 0, POINTS},
    {"stress in an array, partial slip", array_of_points, 0.4, 0, POINTS},
    {"stress in an array of 10^6", array_of_points, 0, 0, MANY},
    {"stress in an array, of a contact", points_that_slide, 0, 0, POINTS},
    {"stress in an array, unlike bodies", points_that_slide, -0.11, 0, POINTS},
    {"stress at a point, of a contact", single_points_that_slide, 0, 0, POINTS / 4},
    {"stress at a point, unlike bodies", single_points_that_slide, -0.11, 0, POINTS / 4},
    {"stress in an array, of a flat pad", points_of_a_flat_pad, 2000, 0, POINTS},
    {"stress in an array, 99 arcs", points_of_a_profile, 20000, 0, POINTS / 4},
    {"elastic limit, cold", limits_one_by_one, 0, 0, PAPER_LIMITS / 5},
    {"elastic limit, 2600 of them", limits_one_by_one, 0, 0, 4 * PAPER_LIMITS},
    {"elastic limit, in an array", limits_in_array, 0, 0, PAPER_LIMITS},
    {"shakedown limit", shakedown_limits, 0, 0, PAPER_LIMITS / 5},
    {"pressure", pressures, 0, 0, POINTS},
    {"stress after P and then Q", points_of_corners, 2, 0, POINTS},
    {"stress, 250 corners", points_of_corners, 250, 0, POINTS / 2},
    {"stress, 250 corners off the centre", points_of_corners, 250, 8000, POINTS / 2},
    {"yield factor, one load", yield_factors, 1, 0, 100},
    {"yield factor, P and then Q", yield_factors, 2, 0, 20},
    {"yield factor, 250 corners", yield_factors, 250, 0, 1},
    {"yield factor, off the centre", yield_factors, 250, 8000, 1},
    {"yield factor, sliding", yield_factors_that_slide, 0, 0, 40},
    {"yield factor, unlike bodies", yield_factors_that_slide, -0.11, 0, 20},
    {"shakedown factor, sliding", shakedown_factors_that_slide, 0, 0, 40},
    {"shakedown factor, unlike bodies", shakedown_factors_that_slide, -0.11, 0, 20},
    {"elastic limit, unlike bodies", sliding_limits, -0.11, 0, PAPER_LIMITS / 10},
    {"largest tension, unlike bodies", sliding_laws, -0.11, 0, PAPER_LIMITS},
    {"load that grows, of 2000", growing_loads, 0, 0, MOST_LOADS},
    {"load that grows, of 40000", growing_loads, 0, 0, 20 * MOST_LOADS},
    {"load, tension lags, to 1e-3", lagging, 1e-3, 0, 48},
    {"load, tension lags, to 1e-6", lagging, 1e-6, 0, 48},
    {"load of a noisy log, to 1e-3", lagging, 1e-3, 0.03, 48},
    {"load of a noisy log of 1000 loads", lagging, 1e-3, 0.03, 1000},
    {"stresses of a computed state", computed_points, 1, 0, 20 * POINTS},
    {"the same, along the surface", computed_points, 0, 0, 20 * POINTS},
    {"stresses through a cycle, by calls", history_by_calls, OF_Q, PLACES, CYCLE_LOADS *PLACES},
    {"stresses through a cycle of Q", history, OF_Q, PLACES, CYCLE_LOADS *PLACES},
    {"stresses through one with tension", history, IN_PHASE, PLACES, CYCLE_LOADS *PLACES},
    {"stresses through one that lags", history, LAGGING, 300, 48 * 300},
    {"2 points, 2000 corners, by calls", history_by_calls, REVERSALS, 2, 2 * MOST_LOADS},
    {"2 points, 2000 corners, in one call", history, REVERSALS, 2, 2 * MOST_LOADS},
    {"stresses on the lines of cracks", stresses_on_cracks, 0, 0, CRACK_LOADS *ON_CRACKS},
    {"K of those cracks", cracks, 0, 0, CRACK_LOADS *ON_CRACKS},
    {"K of those cracks, faces press", closing_cracks, 0, 0, CRACK_LOADS *ON_CRACKS},
    {"bounds of a cycle's shakedown", bounds_of_cycles, 0, 0, 1},
    {"end of wear", ends_of_wear, 0, 0, 100},
    {"Smith-Watson-Topper of 40 loads", criterion, RWEDGE_MEASURE_SWT_IN_PLANE, 0, PLACES},
    {"Smith-Watson-Topper, all planes", criterion, RWEDGE_MEASURE_SWT, 0, PLACES},
    {"Findley of 40 loads", criterion, RWEDGE_MEASURE_FINDLEY, 0, PLACES},
    {"Crossland of 40 loads", criterion, RWEDGE_MEASURE_CROSSLAND, 0, PLACES},
};

const size_t works_count = sizeof works / sizeof works[0];

/* ---- Places ---- */

void set_places(void)
{
    for (int i = 0; i < MANY; i++) {
        xs[i] = 4 * fmod((double)i * 0.6180339887498949, 1) - 2;
        ys[i] = 2 * fmod((double)i * 0.7548776662466927, 1) + 1e-3;
    }
    history(&(work){"", history, OF_Q, PLACES, CYCLE_LOADS * PLACES});
    for (int k = 0; k < 3; k++)
        memcpy(cycle[k], out[k], sizeof cycle[k]);
}
