/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over a quarter of the sphere of normals: planes that are mirrored by the plane
 * of x and y are equally bad. A cell is a rectangle of psi, twice the angle in the plane of x and
 * y, and beta. Around its centre each load's components are linear, but for a remainder that is
 * bounded by the second derivatives. The distance of a linear function from a centre that moves
 * linearly, too, is convex, so that its largest value is at a corner of the cell. The centre of the
 * circle moves so that all points on it leave it at the same rate: then the bound exceeds the true
 * values by the second order of the cell's size, and few cells are left at each size. A load is
 * kept in a cell only if it can be the highest, or on the circle, somewhere in it. */
#include "planes/worst_plane.h"

#include "base/domain.h"
#include "planes/equator.h"
#include "planes/moving_circle.h"
#include "planes/plane_cycle.h"
#include "planes/plane_search.h"

#include <float.h>

enum { CORNERS = 4 };

/* Cells never get this small: their bound exceeds the value by less than noise before. */
static const double SMALLEST = 1e-9;

/* Where a curve of planes has the same value no cell of it can be left out. After every CELLS
 * cells the difference that counts as noise grows by a factor; beyond LARGE_NOISE of the value it
 * grows after more cells. So the search ends. */
enum { CELLS = 2048, MORE_CELLS = 8192 };
static const double NOISE_GROWTH = 64, LARGE_NOISE = 1e-5;

typedef struct {
    rw_direction psi, beta;
    double half_psi, half_beta;       /* half of its sides, rad */
    double tangent_psi, tangent_beta; /* of half of these */
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
    bool is_begun; /* above the equator */
    rw_worst_plane best;
    rw_direction psi, beta;
} search;

/* ---- One load on one plane ---- */

static inline void local_of(bool is_strain, const rw_item *load, const cell *a, rw_local *l)
{
    const double C = a->psi.cosine, S = a->psi.sine, c = a->beta.cosine, s = a->beta.sine;
    const double lift = load->lift - (load->d * C + load->t * S);
    l->peak = load->z - c * c * lift;
    l->peak_by_psi = c * c * (load->t * C - load->d * S);
    l->peak_by_beta = 2 * s * c * lift;
    const double deviation = load->deviation_d * C + load->deviation_t * S,
                 shear = load->deviation_t * C - load->deviation_d * S,
                 rise = load->deviation_lift - deviation;
    if (is_strain) {
        l->at = (rw_vector){load->level - c * c * rise, 0};
        l->by_psi = (rw_vector){c * c * shear, 0};
        l->by_beta = (rw_vector){2 * s * c * rise, 0};
    } else {
        l->at = (rw_vector){c * shear, s * c * rise};
        l->by_psi = (rw_vector){-c * deviation, -s * c * shear};
        l->by_beta = (rw_vector){-s * shear, (c - s) * (c + s) * rise};
    }
    const double mixed = a->half_psi * (a->half_psi + 2 * a->half_beta) / 2;
    const double square = a->half_beta * a->half_beta / 2;
    const double turn = rw_smaller(1, 2 * (s + a->half_beta));
    l->rest =
        load->deviation_size * mixed +
        (load->deviation_size + 2 * turn * (load->deviation_size + fabs(load->deviation_lift))) *
            square;
    l->peak_rest = load->size * mixed + 2 * (load->size + fabs(load->lift)) * square;
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

static inline corners linear(double at, double by_psi, double by_beta)
{
    const double sum = by_psi + by_beta, difference = by_psi - by_beta;
    return (corners){{at + sum, at + difference, at - difference, at - sum}};
}

/* The squares of the distances, without the rest. */
static inline corners distances(const rw_local *l, const rw_circle *c, const cell *a)
{
    const double p = a->half_psi, b = a->half_beta;
    const corners x = linear(l->at.x - c->ball.centre.x[0], p * (l->by_psi.x - c->by_psi.x),
                             b * (l->by_beta.x - c->by_beta.x));
    const corners y = linear(l->at.y - c->ball.centre.x[1], p * (l->by_psi.y - c->by_psi.y),
                             b * (l->by_beta.y - c->by_beta.y));
    corners square;
    for (int k = 0; k < CORNERS; k++)
        square.at[k] = x.at[k] * x.at[k] + y.at[k] * y.at[k];
    return square;
}

/* How far a point can move relative to the centre of the circle within the cell. */
static inline double travel(const rw_local *l, const rw_circle *c, const cell *a)
{
    const double x = a->half_psi * fabs(l->by_psi.x - c->by_psi.x) +
                     a->half_beta * fabs(l->by_beta.x - c->by_beta.x);
    const double y = a->half_psi * fabs(l->by_psi.y - c->by_psi.y) +
                     a->half_beta * fabs(l->by_beta.y - c->by_beta.y);
    return x + y + l->rest;
}

static inline corners peaks(const rw_local *l, const cell *a)
{
    return linear(l->peak, a->half_psi * l->peak_by_psi, a->half_beta * l->peak_by_beta);
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
    for (size_t i = 0; i < n; i++)
        local_of(w->severity->is_strain, &w->cycle->item[i], a, &w->cycle->local[i]);
    v->around = rw_circle_of(w->cycle, w->severity->is_strain, n);
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
        w->psi = a->psi;
        w->beta = a->beta;
    }
    return value;
}

/* Moves the loads that can matter in the cell to the front; how many. */
static size_t keep(search *w, size_t n, const view *v)
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        const rw_local *l = &w->cycle->local[i];
        const double least = rw_larger(0, v->least_amplitude - l->rest);
        if (l->farthest >= least * least || l->highest >= v->least_peak)
            rw_keep_load(w->cycle, i, kept++);
    }
    return kept;
}

/* The halves of a cell, along its longer side: first the one that may be worse. */
static void divide(const cell *a, const corners *severity, cell half[2])
{
    half[0] = half[1] = *a;
    const bool is_wide = a->half_psi > 2 * a->half_beta;
    const double *at = severity->at;
    const double forward = is_wide ? at[0] + at[1] - at[2] - at[3] : at[0] - at[1] + at[2] - at[3];
    for (int i = 0; i < 2; i++) {
        cell *h = &half[i];
        double *tangent = is_wide ? &h->tangent_psi : &h->tangent_beta;
        *tangent = rw_half_tangent(*tangent);
        *(is_wide ? &h->half_psi : &h->half_beta) /= 2;
        rw_direction *u = is_wide ? &h->psi : &h->beta;
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

static bool is_worst_at_equator(const search *w, const cell *a, size_t n)
{
    const rw_psi_arc arc = {a->psi, a->half_psi, a->tangent_psi};
    return rw_equator_is_worst(w->cycle, w->severity, &arc, n, w->best.value + w->noise);
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
    if (bound <= w->best.value + w->noise || a->half_beta < SMALLEST)
        return 0;
    const size_t kept = keep(w, n, &v);
    if (is_worst_at_equator(w, a, kept))
        return 0;
    divide(a, &severity, half);
    return kept;
}

/* A cell to be looked at, with the loads that are left in it. */
typedef struct {
    cell area;
    size_t loads;
} task;

/* More than the halvings from the first cells to the smallest ones. */
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
    double psi, beta;
} step;

enum { FIRST_ROUNDS = 4, ROUNDS = 16, SECTIONS = 24 };
static const double FIRST_REACH = 0.3, SHRINK = 0.4, GOLDEN = 0.6180339887498949;

static double value_at(search *w, const cell *from, const step *s, double t)
{
    cell a = {.psi = rw_turned_by(from->psi, t * s->psi),
              .beta = rw_turned_by(from->beta, t * s->beta)};
    const size_t n = w->cycle->loads;
    for (size_t i = 0; i < n; i++)
        local_of(w->severity->is_strain, &w->cycle->item[i], &a, &w->cycle->local[i]);
    return record(w, &a, n, rw_circle_of(w->cycle, w->severity->is_strain, n).ball.radius);
}

static cell best_plane(const search *w)
{
    return (cell){.psi = w->psi, .beta = w->beta};
}

static void climb_along(search *w, const step *s)
{
    const cell from = best_plane(w);
    double low = -1, high = 1, left = high - GOLDEN * (high - low),
           right = low + GOLDEN * (high - low);
    double at_left = value_at(w, &from, s, left), at_right = value_at(w, &from, s, right);
    for (int i = 0; i < SECTIONS; i++) {
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
    return (step){(from->psi.cosine * to->psi.sine - from->psi.sine * to->psi.cosine) / 2,
                  (from->beta.cosine * to->beta.sine - from->beta.sine * to->beta.cosine) / 2};
}

static void climb(search *w, int rounds)
{
    double reach = FIRST_REACH;
    for (int i = 0; i < rounds; i++, reach *= SHRINK) {
        const cell from = best_plane(w);
        const step across = {reach, 0}, up = {0, reach};
        climb_along(w, &across);
        climb_along(w, &up);
        const cell to = best_plane(w);
        step way = way_of(&from, &to);
        const double length = rw_larger(fabs(way.psi), fabs(way.beta));
        if (length == 0)
            continue;
        way = (step){way.psi * reach / length, way.beta * reach / length};
        climb_along(w, &way);
    }
}

/* ---- The quarter of the sphere ---- */

/* The first cells are an eighth of the equator wide and a quarter of a right angle high. Of beta
 * the cosine and sine of their centres, pi/16 and so on; the tangent of a quarter of their
 * height. */
enum { ROWS = 4 };
static const rw_direction ROW[ROWS] = {{0.98078528040323044, 0.19509032201612827},
                                       {0.83146961230254524, 0.55557023301960222},
                                       {0.55557023301960222, 0.83146961230254524},
                                       {0.19509032201612827, 0.98078528040323044}};
static const double HALF_HEIGHT = RW_PI / 16, TANGENT = 0.098491403357164255;

/* A high value to begin with: a cell whose highest plane is at its side, beside a cell with higher
 * ones, would otherwise be divided along this side to the end. */
static void begin_exploring(search *w)
{
    for (int k = 0; k < RW_ARCS * ROWS; k++) {
        const cell a = {.psi = rw_equator_arc(k / ROWS).psi, .beta = ROW[k % ROWS]};
        value_at(w, &a, &(step){0, 0}, 0);
    }
    climb(w, FIRST_ROUNDS);
    w->is_begun = true;
}

/* Planes above an arc of the equator that may be worse. */
static void explore_above(search *w, const rw_psi_arc *arc)
{
    if (!w->is_begun)
        begin_exploring(w);
    for (int row = 0; row < ROWS; row++) {
        const cell a = {.psi = arc->psi,
                        .beta = ROW[row],
                        .half_psi = arc->half,
                        .half_beta = HALF_HEIGHT,
                        .tangent_psi = arc->tangent,
                        .tangent_beta = TANGENT};
        explore(w, &a, w->cycle->loads);
    }
}

/* How often an arc is halved to show that no plane above it is worse. */
enum { DEPTH = 3 };

static void explore_arc(search *w, const rw_psi_arc *arc, int depth)
{
    if (rw_equator_is_worst(w->cycle, w->severity, arc, w->cycle->loads, w->best.value + w->noise))
        return;
    if (depth == 0) {
        explore_above(w, arc);
        return;
    }
    const rw_psi_arc first = rw_half_of_arc(arc, false), second = rw_half_of_arc(arc, true);
    explore_arc(w, &first, depth - 1);
    explore_arc(w, &second, depth - 1);
}

/* ---- All ---- */

/* A product of strain and stress has a search of its own over the planes that contain z. */
static void search_products(search *w)
{
    const rw_plane_cycle *cycle = w->cycle;
    const rw_stress_cycle waves = {.loads = cycle->loads,
                                   .stride = 1,
                                   .sxx = cycle->sxx,
                                   .syy = cycle->syy,
                                   .txy = cycle->txy,
                                   .gain = w->severity->gain,
                                   .mean = 1 + w->severity->shift,
                                   .normal = 1};
    cell at = {.beta = {1, 0}};
    rw_plane_search(&waves, &at.psi);
    value_at(w, &at, &(step){0, 0}, 0);
}

/* Whether the worst plane that contains z is the worst of all. */
static bool search_equator(search *w)
{
    if (!w->severity->is_strain) {
        rw_equator_search(w->cycle, w->severity, w->noise, &w->best, &w->psi);
        return false;
    }
    search_products(w);
    return rw_equator_has_worst_product(w->cycle, w->best.value);
}

rw_worst_plane rw_worst_plane_of(rw_plane_cycle *cycle, const rw_severity *severity)
{
    rw_plane_cycle_centre(cycle);
    const double noise = rw_plane_cycle_noise(cycle, severity);
    search w = {.severity = severity,
                .cycle = cycle,
                .noise = noise,
                .best = {.value = severity->is_sum ? -DBL_MAX : 0},
                .psi = {1, 0},
                .beta = {1, 0}};
    const bool is_done = search_equator(&w);
    for (int k = 0; k < RW_ARCS && !is_done; k++) {
        const rw_psi_arc arc = rw_equator_arc(k);
        explore_arc(&w, &arc, DEPTH);
    }
    if (w.noise > noise)
        climb(&w, ROUNDS);
    w.best.angle = rw_plane_angle(w.psi.cosine, w.psi.sine);
    /* 0 to pi/2: planes that are mirrored are equally bad */
    w.best.out_of_plane = rw_angle(fabs(w.beta.cosine), fabs(w.beta.sine));
    return w.best;
}
