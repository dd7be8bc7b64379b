/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over a quarter of the sphere of normals: planes that are mirrored by the plane
 * of x and y are equally bad. A cell is a rectangle of the latitude beta and the longitude chi.
 * Around its centre each load's components are linear, but for a remainder that is bounded by the
 * second derivatives. The distance of a linear function from a centre that moves linearly, too, is
 * convex, so that its largest value is at a corner of the cell. The centre of the circle moves so
 * that all points on it leave it at the same rate: then the bound exceeds the true values by the
 * second order of the cell's size, and few cells are left at each size. A load is kept in a cell
 * only if it can be the highest, or on the circle, somewhere in it. */
#include "planes/worst_plane.h"

#include "base/domain.h"
#include "planes/equator.h"
#include "planes/moving_circle.h"
#include "planes/plane_cycle.h"

#include <float.h>

enum { CORNERS = 4 };

/* Hardly a cell gets this small: its bound exceeds the value by less than noise before. */
static const double SMALLEST = 1e-9;

/* Where a curve of planes has the same value no cell of it can be left out. After every CELLS
 * cells the difference that counts as noise grows by a factor; beyond LARGE_NOISE of the value it
 * grows after more cells. So the search ends. */
enum { CELLS = 2048, MORE_CELLS = 8192 };
static const double NOISE_GROWTH = 64, LARGE_NOISE = 1e-5;

typedef struct {
    rw_direction chi, beta;
    double half_chi, half_beta;       /* half of its sides, rad */
    double tangent_chi, tangent_beta; /* of half of these */
} cell;

typedef struct {
    double at[CORNERS];
} corners;

/* Upper bounds of the loads in the cell, and a lower bound of the largest of them. */
typedef struct {
    rw_circle around;
    corners amplitude, peak;
    double least_amplitude, least_peak;
} view;

typedef struct {
    const rw_severity *severity;
    rw_plane_cycle *cycle;
    double noise;
    int cells;
    rw_worst_plane best;
    rw_direction chi, beta; /* of the best plane */
    rw_pole pole;
} search;

/* ---- One load on one plane ---- */

/* A plane's shear stress along the meridian and along the parallel, its normal stress, and rates of
 * change. */
typedef struct {
    rw_vector shear, by_chi, by_beta;
    double normal, normal_by_chi, normal_by_beta;
} local;

static inline local local_of(const rw_tensor *t, const cell *a)
{
    const double C = a->chi.cosine, S = a->chi.sine, c = a->beta.cosine, s = a->beta.sine;
    const double cosine = (c - s) * (c + s), sine = 2 * s * c; /* of twice beta */
    const double side = S * (S * t->side + 2 * C * t->twist),
                 turn = C * S * t->side + (C - S) * (C + S) * t->twist,
                 turn_by_chi = (C - S) * (C + S) * t->side - 4 * C * S * t->twist;
    const double along = sine * (t->pole - side) / 2 + cosine * S * t->shear,
                 across = s * C * t->shear + c * turn;
    return (local){
        {along, across},
        {cosine * C * t->shear - sine * turn, c * turn_by_chi - s * S * t->shear},
        {cosine * (t->pole - side) - 2 * sine * S * t->shear, c * C * t->shear - s * turn},
        t->base + s * s * t->pole + sine * S * t->shear + c * c * side,
        2 * c * across,
        2 * along};
}

/* Bounds on the second order of both stresses. */
static inline double rest_by_chi(const rw_tensor *t, const cell *a)
{
    return a->half_chi * a->half_chi * (t->ring + fabs(t->shear) / 2);
}

static inline double rest_by_beta(const rw_tensor *t, const cell *a)
{
    return a->half_beta * a->half_beta * (fabs(t->pole) + t->ring + 2 * fabs(t->shear));
}

static inline double rest_of(const rw_tensor *t, const cell *a)
{
    return rest_by_chi(t, a) + rest_by_beta(t, a) +
           a->half_chi * a->half_beta * (t->ring + 2 * fabs(t->shear));
}

/* Of the first n loads, in the cell; a copy of it, which no pointer can change. */
static void set_local(rw_plane_cycle *cycle, bool is_strain, size_t n, const cell a)
{
    for (size_t i = 0; i < n; i++) {
        const rw_tensor *all = &cycle->item[i].all, *deviation = &cycle->item[i].deviation;
        const local every = local_of(all, &a), s = local_of(deviation, &a);
        cycle->local[i] = (rw_local){.at = s.shear,
                                     .by_chi = s.by_chi,
                                     .by_beta = s.by_beta,
                                     .peak = every.normal,
                                     .peak_by_chi = every.normal_by_chi,
                                     .peak_by_beta = every.normal_by_beta,
                                     .rest = rest_of(deviation, &a),
                                     .peak_rest = rest_of(all, &a)};
        if (is_strain) {
            cycle->local[i].at = (rw_vector){s.normal, 0};
            cycle->local[i].by_chi = (rw_vector){s.normal_by_chi, 0};
            cycle->local[i].by_beta = (rw_vector){s.normal_by_beta, 0};
        }
    }
}

/* ---- Bounds at the corners of a cell ---- */

static inline double top_of(const corners *c)
{
    return rw_larger(rw_larger(c->at[0], c->at[1]), rw_larger(c->at[2], c->at[3]));
}

static inline double bottom_of(const corners *c)
{
    return rw_smaller(rw_smaller(c->at[0], c->at[1]), rw_smaller(c->at[2], c->at[3]));
}

static inline corners linear(double at, double by_chi, double by_beta)
{
    const double sum = by_chi + by_beta, difference = by_chi - by_beta;
    return (corners){{at + sum, at + difference, at - difference, at - sum}};
}

/* The squares of the distances, without the rest. */
static inline corners distances(const rw_local *l, const rw_circle *c, const cell *a)
{
    const double p = a->half_chi, b = a->half_beta;
    const corners x = linear(l->at.x - c->ball.centre.x[0], p * (l->by_chi.x - c->by_chi.x),
                             b * (l->by_beta.x - c->by_beta.x));
    const corners y = linear(l->at.y - c->ball.centre.x[1], p * (l->by_chi.y - c->by_chi.y),
                             b * (l->by_beta.y - c->by_beta.y));
    corners square;
    for (int k = 0; k < CORNERS; k++)
        square.at[k] = x.at[k] * x.at[k] + y.at[k] * y.at[k];
    return square;
}

/* How far a point can move relative to the centre of the circle within the cell. */
static inline double travel(const rw_local *l, const rw_circle *c, const cell *a)
{
    const double x = a->half_chi * fabs(l->by_chi.x - c->by_chi.x) +
                     a->half_beta * fabs(l->by_beta.x - c->by_beta.x);
    const double y = a->half_chi * fabs(l->by_chi.y - c->by_chi.y) +
                     a->half_beta * fabs(l->by_beta.y - c->by_beta.y);
    return x + y + l->rest;
}

static inline corners peaks(const rw_local *l, const cell *a)
{
    return linear(l->peak, a->half_chi * l->peak_by_chi, a->half_beta * l->peak_by_beta);
}

static inline void raise(corners *c, const corners *other, double more)
{
    for (int k = 0; k < CORNERS; k++)
        c->at[k] = rw_larger(c->at[k], other->at[k] + more);
}

/* Above the severity everywhere in the cell, and at its corners. Both factors of a product are
 * below mixtures of their values at the corners, with the same weights. The product of two mixtures
 * exceeds that of the products by their covariance at most. */
static double bound_of(const rw_severity *v, const corners *amplitude, const corners *peak,
                       corners *severity)
{
    corners factor;
    for (int k = 0; k < CORNERS; k++) {
        severity->at[k] = rw_severity_of(v, amplitude->at[k], peak->at[k]);
        factor.at[k] = v->is_sum ? 0 : rw_larger(0, v->offset + v->gain * peak->at[k]);
    }
    return top_of(severity) +
           (top_of(amplitude) - bottom_of(amplitude)) * (top_of(&factor) - bottom_of(&factor)) / 4;
}

/* ---- A cell ---- */

static void look(search *w, const cell *a, size_t n, view *v)
{
    set_local(w->cycle, w->severity->is_strain, n, *a);
    v->around = rw_circle_of(w->cycle, n);
    static const corners LOWEST = {{-DBL_MAX, -DBL_MAX, -DBL_MAX, -DBL_MAX}};
    v->amplitude = v->peak = LOWEST;
    v->least_peak = -DBL_MAX;
    double most = 0, rest = 0;
    for (size_t i = 0; i < n; i++) {
        rw_local *l = &w->cycle->local[i];
        const corners distance = distances(l, &v->around, a), peak = peaks(l, a);
        l->farthest = top_of(&distance);
        l->highest = top_of(&peak) + l->peak_rest;
        raise(&v->amplitude, &distance, 0);
        raise(&v->peak, &peak, l->peak_rest);
        v->least_peak = rw_larger(v->least_peak, bottom_of(&peak) - l->peak_rest);
        most = rw_larger(most, travel(l, &v->around, a));
        rest = rw_larger(rest, l->rest);
    }
    for (int k = 0; k < CORNERS; k++)
        v->amplitude.at[k] = sqrt(v->amplitude.at[k]) + rest;
    v->least_amplitude = v->around.ball.radius - most;
}

static double record(search *w, const cell *a, size_t n, double amplitude)
{
    double peak = -DBL_MAX;
    for (size_t i = 0; i < n; i++)
        peak = rw_larger(peak, w->cycle->local[i].peak);
    const double value = rw_severity_of(w->severity, amplitude, peak);
    if (value > w->best.value) {
        w->best = (rw_worst_plane){.value = value, .amplitude = amplitude, .peak = peak};
        w->chi = a->chi;
        w->beta = a->beta;
    }
    return value;
}

/* Moves the loads that can matter in the cell to the front; how many. */
static size_t keep(search *w, size_t n, const view *v)
{
    rw_item *load = w->cycle->item;
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        const rw_local *l = &w->cycle->local[i];
        const double least = rw_larger(0, v->least_amplitude - l->rest);
        if (l->farthest >= least * least || l->highest >= v->least_peak) {
            const rw_item kept_load = load[i];
            load[i] = load[kept];
            load[kept++] = kept_load;
        }
    }
    return kept;
}

/* Whether the second order is larger along chi than along beta, as the severity counts it. */
static bool is_wide(const search *w, const cell *a, size_t n, const view *v)
{
    const rw_severity *y = w->severity;
    const double per = y->is_sum ? 1 : rw_larger(0, y->offset + y->gain * v->least_peak);
    const double per_peak = y->gain * (y->is_sum ? 1 : v->around.ball.radius);
    double excess = 0;
    for (size_t i = 0; i < n; i++) {
        const rw_tensor *all = &w->cycle->item[i].all, *deviation = &w->cycle->item[i].deviation;
        excess += per * (rest_by_chi(deviation, a) - rest_by_beta(deviation, a)) +
                  per_peak * (rest_by_chi(all, a) - rest_by_beta(all, a));
    }
    return excess > 0;
}

/* The halves of a cell: first the one that may be worse. */
static void divide(const cell *a, bool along_chi, const corners *severity, cell half[2])
{
    half[0] = half[1] = *a;
    const double *at = severity->at;
    const double forward =
        along_chi ? at[0] + at[1] - at[2] - at[3] : at[0] - at[1] + at[2] - at[3];
    for (int i = 0; i < 2; i++) {
        cell *h = &half[i];
        double *tangent = along_chi ? &h->tangent_chi : &h->tangent_beta;
        *tangent = rw_half_tangent(*tangent);
        *(along_chi ? &h->half_chi : &h->half_beta) /= 2;
        rw_direction *u = along_chi ? &h->chi : &h->beta;
        *u = rw_turned_by(*u, (i == 0) == (forward > 0) ? *tangent : -*tangent);
    }
}

/* ---- Search ---- */

static void allow_more_noise(search *w)
{
    const bool is_large = w->noise > LARGE_NOISE * fabs(w->best.value);
    if (++w->cells < (is_large ? MORE_CELLS : CELLS))
        return;
    w->cells = 0;
    w->noise *= NOISE_GROWTH;
}

/* The arc of the equator below the cell; false where it is long. Away from z, a normal in the cell
 * turns by less than `turn` of the `share` that it has in the plane of x and y. */
static bool find_arc(const search *w, const cell *a, rw_psi_arc *arc)
{
    double C = a->chi.cosine, S = a->chi.sine;
    *arc = (rw_psi_arc){.half = 2 * a->half_chi};
    if (!w->pole.is_z) {
        const double side = a->beta.cosine * S,
                     share = sqrt(a->beta.sine * a->beta.sine + side * side);
        const double turn = a->half_beta + a->half_chi * (a->beta.cosine + a->half_beta);
        if (turn > share / 2)
            return false;
        C = a->beta.sine / share, S = side / share;
        arc->half = 2.2 * turn / share; /* twice, and at most 5 % more */
    }
    arc->psi = (rw_direction){(C - S) * (C + S), 2 * C * S};
    return true;
}

/* Whether no plane in the cell is worse than the one of the equator below it. */
static bool is_worst_at_equator(const search *w, const cell *a, size_t n)
{
    rw_psi_arc arc;
    return find_arc(w, a, &arc) &&
           rw_equator_is_worst(w->cycle, w->severity, &arc, n, w->best.value + w->noise);
}

/* How many of the first n loads can matter in the cell, and the halves of the cell; 0 where the
 * cell is settled. */
static size_t narrow(search *w, const cell *a, size_t n, cell half[2])
{
    view v;
    corners severity;
    look(w, a, n, &v);
    record(w, a, n, v.around.ball.radius);
    allow_more_noise(w);
    const double bound = bound_of(w->severity, &v.amplitude, &v.peak, &severity);
    if (bound <= w->best.value + w->noise || rw_smaller(a->half_beta, a->half_chi) < SMALLEST)
        return 0;
    const size_t kept = keep(w, n, &v);
    if (is_worst_at_equator(w, a, kept))
        return 0;
    divide(a, is_wide(w, a, kept, &v), &severity, half);
    return kept;
}

/* A cell to be looked at, with the loads that are left in it. */
typedef struct {
    cell area;
    size_t loads;
} task;

/* Halvings from the first cells to the smallest ones are fewer. */
enum { TASKS = 64 };

/* Cells wait in a list of their own: recursion would take much of a small stack. */
static void explore(search *w, const cell *a, size_t n)
{
    task waiting[TASKS] = {{*a, n}};
    for (int count = 1; count > 0;) {
        const task now = waiting[--count];
        cell half[2];
        const size_t kept = narrow(w, &now.area, now.loads, half);
        for (int i = 1; kept > 0 && i >= 0; i--)
            waiting[count++] = (task){half[i], kept};
    }
}

/* ---- A climb from the worst plane so far ---- */

/* Powell's method: the largest value along a line by golden sections, and the way of a round as the
 * next line. Steps are tangents of half the angles. */
typedef struct {
    double chi, beta;
} step;

enum { FIRST_ROUNDS = 3, FIRST_SECTIONS = 5, ROUNDS = 16, SECTIONS = 24 };
static const double FIRST_REACH = 0.3, SHRINK = 0.4, GOLDEN = 0.6180339887498949;

static double value_at(search *w, const cell *from, const step *s, double t)
{
    cell a = {.chi = rw_turned_by(from->chi, t * s->chi),
              .beta = rw_turned_by(from->beta, t * s->beta)};
    const size_t n = w->cycle->loads;
    set_local(w->cycle, w->severity->is_strain, n, a);
    return record(w, &a, n, rw_circle_of(w->cycle, n).ball.radius);
}

static cell best_plane(const search *w)
{
    return (cell){.chi = w->chi, .beta = w->beta};
}

static void climb_along(search *w, const step *s, int sections)
{
    const cell from = best_plane(w);
    double low = -1, high = 1, left = high - GOLDEN * (high - low),
           right = low + GOLDEN * (high - low);
    double at_left = value_at(w, &from, s, left), at_right = value_at(w, &from, s, right);
    for (int i = 0; i < sections; i++) {
        const bool is_left = at_left > at_right;
        *(is_left ? &high : &low) = is_left ? right : left;
        *(is_left ? &right : &left) = is_left ? left : right;
        *(is_left ? &at_right : &at_left) = is_left ? at_left : at_right;
        const double t = is_left ? high - GOLDEN * (high - low) : low + GOLDEN * (high - low);
        *(is_left ? &at_left : &at_right) =
            value_at(w, &from, s, is_left ? (left = t) : (right = t));
    }
}

/* The step from one plane to another, if they are near. */
static step way_of(const cell *from, const cell *to)
{
    return (step){(from->chi.cosine * to->chi.sine - from->chi.sine * to->chi.cosine) / 2,
                  (from->beta.cosine * to->beta.sine - from->beta.sine * to->beta.cosine) / 2};
}

static void climb(search *w, int rounds, int sections)
{
    double reach = FIRST_REACH;
    for (int i = 0; i < rounds; i++, reach *= SHRINK) {
        const cell from = best_plane(w);
        const step across = {reach, 0}, up = {0, reach};
        climb_along(w, &across, sections);
        climb_along(w, &up, sections);
        const cell to = best_plane(w);
        step way = way_of(&from, &to);
        const double length = rw_larger(fabs(way.chi), fabs(way.beta));
        if (length == 0)
            continue;
        way = (step){way.chi * reach / length, way.beta * reach / length};
        climb_along(w, &way, sections);
    }
}

/* ---- The quarter of the sphere ---- */

/* A high value to begin with: a cell whose highest plane is at its side, beside a cell with higher
 * ones, would otherwise be divided along this side to the end. Planes a quarter of the sides
 * apart. */
static void begin(search *w)
{
    enum { STEPS = 4 };
    static const cell FIRST = {.chi = {0.38268343236508977, -0.92387953251128676},
                               .beta = {0.98078528040323045, 0.19509032201612827},
                               .tangent_chi = 0.41421356237309505,
                               .tangent_beta = 0.19891236737965801};
    cell a = FIRST;
    for (int i = 0; i < STEPS * STEPS; i++) {
        value_at(w, &a, &(step){0, 0}, 0);
        a.beta = rw_turned_by(a.beta, a.tangent_beta);
        if (i % STEPS < STEPS - 1)
            continue;
        a.beta = FIRST.beta;
        a.chi = rw_turned_by(a.chi, a.tangent_chi);
    }
    climb(w, FIRST_ROUNDS, FIRST_SECTIONS);
}

static void name_plane(search *w)
{
    const double pole = w->beta.sine, base = w->beta.cosine * w->chi.cosine,
                 side = w->beta.cosine * w->chi.sine;
    const double first = w->pole.is_z ? base : pole, out = w->pole.is_z ? pole : base;
    const rw_direction psi = rw_turned_with(
        (rw_direction){(first - side) * (first + side), 2 * first * side}, w->pole.psi);
    w->best.angle = rw_plane_angle(psi.cosine, psi.sine);
    /* 0 to pi/2: planes that are mirrored are equally bad */
    w->best.out_of_plane = rw_angle(sqrt(first * first + side * side), fabs(out));
}

/* Planes that may be worse than the worst of the equator. */
static void search_sphere(search *w)
{
    static const cell SPHERE = {.chi = {1, 0},
                                .beta = {0.70710678118654752, 0.70710678118654752},
                                .half_chi = RW_HALF_PI,
                                .half_beta = RW_PI / 4,
                                .tangent_chi = 1,
                                .tangent_beta = 0.41421356237309505};
    const double noise = w->noise;
    const rw_worst_plane equator = w->best;
    w->pole = rw_plane_cycle_turn(w->cycle);
    begin(w);
    explore(w, &SPHERE, w->cycle->loads);
    if (w->noise > noise)
        climb(w, ROUNDS, SECTIONS);
    if (w->best.value > equator.value + noise)
        name_plane(w);
    else
        w->best = equator;
}

/* ---- All ---- */

rw_worst_plane rw_worst_plane_of(rw_plane_cycle *cycle, const rw_severity *severity)
{
    rw_plane_cycle_centre(cycle);
    search w = {.severity = severity,
                .cycle = cycle,
                .noise = rw_plane_cycle_noise(cycle, severity),
                .chi = {1, 0},
                .beta = {1, 0}};
    rw_direction psi;
    rw_equator_search(cycle, severity, &w.best, &psi);
    w.best.angle = rw_plane_angle(psi.cosine, psi.sine);
    if (!rw_equator_has_worst(cycle, severity, w.best.value, w.noise))
        search_sphere(&w);
    return w.best;
}
