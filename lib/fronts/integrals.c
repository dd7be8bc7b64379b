/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The quadrature over the places where dt is known: panels that shrink towards the fronts. */
#include "base/always.h"
#include "base/domain.h"
#include "base/processor.h"
#include "base/sort.h"
#include "base/tuned.h"
#include "fronts/fronts.h"

#include <stdlib.h>
#include <string.h>

/* The order of a panel is RW_TERMS, or less where few digits are asked for. */
enum { FEW_TERMS = 8 };

/* Distances from a front, over the half-width, are at least AT_FRONT. A panel there is at least as
 * wide as NARROWEST, unless its segment is narrow itself or the next front is nearer: rounding does
 * not move its points. */
static const double AT_FRONT = 1e-15, NARROWEST = 1e-10;

/* The weights of integrals from 0 to the nodes u of Gauss, and to 1. */
static void set_integrals(rw_fronts *f, const double u[])
{
    enum { MOST = RW_TERMS + 1 };
    const int n = f->order;
    double P[MOST][MOST]; /* Legendre's polynomials: [k][node] */
    for (int i = 0; i <= n; i++) {
        const double v = i < n ? 2 * u[i] - 1 : 1;
        P[0][i] = 1;
        P[1][i] = v;
        for (int k = 1; k < n; k++)
            P[k + 1][i] = ((2 * k + 1) * v * P[k][i] - k * P[k - 1][i]) / (k + 1);
    }
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < n; j++) {
            double share = (P[1][i] + 1) / 2;
            for (int k = 1; k < n; k++)
                share += P[k][j] * (P[k + 1][i] - P[k - 1][i]) / 2;
            f->integral[i][j] = share * f->weight[j];
        }
}

/* Gauss's rule in the angle: for functions like square roots at both ends. */
static void set_rule(rw_fronts *f)
{
    double u[RW_TERMS];
    rw_gauss(f->order, u, f->weight);
    for (int i = 0; i < f->order; i++) {
        const double angle = RW_PI * u[i], half = sin(angle / 2);
        f->weight[i] *= RW_HALF_PI * sin(angle);
        f->node[i] = half * half;
    }
    set_integrals(f, u);
}

/* Most loads need a thousand points. */
enum { FIRST_POINTS = 1024 };

/* A larger block; all points are kept, those of segments that may be the same next time too. */
static bool grow(rw_fronts *f, size_t capacity)
{
    double **row[] = {&f->x,        &f->step,     &f->X,        &f->change,  &f->known,
                      &f->layer[0], &f->layer[1], &f->layer[2], &f->layer[3]};
    enum { ROWS = sizeof row / sizeof *row };
    double *block = malloc(ROWS * capacity * sizeof *block), *before = f->x;
    if (!block)
        return false;
    for (size_t i = 0; i < ROWS; i++) {
        if (before)
            memcpy(block + i * capacity, *row[i], f->capacity * sizeof *block);
        *row[i] = block + i * capacity;
    }
    f->capacity = capacity;
    free(before);
    return true;
}

void rw_fronts_init(rw_fronts *f, double tolerance)
{
    const double digits = -log10(tolerance);
    const bool is_fine = digits > 3.5;
    f->problem = NULL;
    f->order = is_fine ? RW_TERMS : FEW_TERMS;
    f->coarse = is_fine ? 1 : 0;
    f->finest = (int)(digits + 2.5);
    f->layers = (rw_layers){.count = 0};
    memset(f->segment, 0, sizeof f->segment);
    f->count = f->capacity = 0;
    f->x = NULL;
    f->is_short = !grow(f, FIRST_POINTS);
    set_rule(f);
}

void rw_fronts_destroy(rw_fronts *f)
{
    free(f->x);
}

rw_stuck rw_stuck_of(const rw_fronts *f, const rw_zones *zones)
{
    rw_stuck s = {.middle = f->problem->middle, .half = f->problem->half};
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label == 0) {
            s.end[2 * s.count] = zones->zone[i].left;
            s.end[2 * s.count + 1] = zones->zone[i].right;
            s.count++;
        }
    for (int i = 0; i < 2 * s.count; i++)
        s.front[i] = (s.end[i] - s.middle) / s.half;
    return s;
}

RW_INLINE void products(const rw_stuck *s, size_t n, const double x[], double X[])
{
    const double least = AT_FRONT * s->half, per_half = 1 / s->half;
    for (size_t i = 0; i < n; i++)
        X[i] = 1;
    for (int k = 0; k < s->count; k++)
        for (size_t i = 0; i < n; i++) {
            const double before = x[i] - s->end[2 * k], after = x[i] - s->end[2 * k + 1];
            const double square = rw_larger(fabs(before), least) * per_half *
                                  rw_larger(fabs(after), least) * per_half;
            X[i] *= before < 0 ? -square : square;
        }
    for (size_t i = 0; i < n; i++)
        X[i] = copysign(sqrt(fabs(X[i])), X[i]);
}

RW_DISPATCH(set_X, products, (const rw_stuck *s, size_t n, const double x[], double X[]),
            (s, n, x, X))

/* Inside, too, each zone beyond a place changes the sign. */
void rw_X_values(const rw_stuck *s, size_t n, const double x[], double X[])
{
    set_X(s, n, x, X);
}

double rw_X_at(const rw_stuck *s, double x)
{
    double X;
    products(s, 1, &x, &X);
    return X;
}

static double nearest_end(const rw_stuck *s, double x)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < 2 * s->count; i++)
        nearest = rw_smaller(nearest, fabs(x - s->end[i]));
    return nearest;
}

static void add_layers(rw_fronts *f)
{
    memcpy(f->change, f->known, f->count * sizeof *f->change);
    for (int k = 0; k < f->layers.count; k++)
        for (size_t i = 0; i < f->count; i++)
            f->change[i] -= f->layers.weight[k] * f->layer[k][i];
}

/* A panel at the distances from `near` to `far` of an end, which is left or right: points with
 * their weights. */
static void put_panel(rw_fronts *f, const rw_segment *s, int side, double near, double far)
{
    const size_t n = (size_t)f->order;
    for (size_t i = 0; i < n; i++) {
        const double distance = near + (far - near) * f->node[i];
        f->x[f->count + i] = side == 0 ? s->from + distance : s->to - distance;
        f->step[f->count + i] = (far - near) * f->weight[i];
    }
    f->count += n;
}

/* Sets the change dt without the layers, and by each layer, at the points of a segment. */
static void put_changes(rw_fronts *f, const rw_segment *s)
{
    const rw_problem *p = f->problem;
    const double *x = f->x + s->first;
    double *known = f->known + s->first, *old = f->X + s->first; /* X is set later */
    if (s->label != 0 || f->layers.count > 0)
        rw_friction_after(p, s->count, x, known);
    rw_layer_values(p, f->layers.count, s->count, x, known, f->capacity, f->layer[0] + s->first);
    rw_traction_values(&p->old->traction, s->count, x, old);
    for (size_t i = 0; i < s->count; i++)
        known[i] = s->label == 0 ? -old[i] : s->label * known[i] - old[i];
}

/* The width of the panel at an end. */
static double last_panel(const rw_segment *s, int side)
{
    double width = (s->to - s->from) / 2;
    for (int i = 0; i < s->panels[side]; i++)
        width *= RW_PANEL_RATIO;
    return width;
}

static void put_half(rw_fronts *f, const rw_segment *s, int side)
{
    const double half = (s->to - s->from) / 2;
    double near = 0, far = last_panel(s, side);
    for (int i = 0; i <= s->panels[side]; i++) {
        put_panel(f, s, side, near, far);
        near = far;
        far = i + 1 == s->panels[side] ? half : far / RW_PANEL_RATIO;
    }
}

static void put_segment(rw_fronts *f, rw_segment *s)
{
    const size_t all = f->count + (size_t)((s->panels[0] + s->panels[1] + 2) * f->order);
    s->first = f->count;
    if (all > f->capacity && !grow(f, all > 2 * f->capacity ? all : 2 * f->capacity)) {
        f->is_short = true;
        return;
    }
    put_half(f, s, 0);
    put_half(f, s, 1);
    s->count = f->count - s->first;
    put_changes(f, s);
}

/* Where no front is near: dt is like a root at edges of the contact, old and new, and at kinks
 * beyond. */
enum { AWAY = 2 };

/* How far beyond an end of a segment the next of n places is. */
static double next_beyond(double end, int way, int n, const double at[])
{
    double next = HUGE_VAL;
    for (int i = 0; i < n; i++)
        if (way * (at[i] - end) > 0)
            next = rw_smaller(next, fabs(at[i] - end));
    return next;
}

/* The next place where dt is not smooth. */
static double next_break(const rw_problem *p, double end, int way)
{
    const double edge[] = {p->to.left, p->to.right, p->from.left, p->from.right};
    return rw_smaller(next_beyond(end, way, 4, edge),
                      next_beyond(end, way, p->old->kinks, p->old->kink));
}

/* Panels that shrink to a distance. */
static double shrinking(double distance, double length)
{
    return ceil(log(distance / length) / log(RW_PANEL_RATIO));
}

/* Towards an end of a segment, by how far from there the next front is, or another break. */
static int panels_towards(const rw_problem *p, const rw_stuck *s, double end, int way,
                          double length, int finest)
{
    const double front = nearest_end(s, end), other = next_break(p, end, way);
    if (front == 0) {
        /* friction has an infinite slope at a kink of the profile; the next front is at the other
         * end of the zone that sticks here */
        const double bend = next_beyond(end, way, p->frame->bends, p->frame->bend),
                     next = next_beyond(end, way, 2 * s->count, s->end);
        const double by_bend = bend < length ? fmin(AWAY, shrinking(bend, length) - 1) : 0,
                     by_front = next < length ? shrinking(next, length) - 1 : 0;
        const double least = fmin(RW_MOST_PANELS, fmax(by_bend, by_front));
        return (int)fmax(least, fmin(finest, shrinking(NARROWEST * p->half, length) - 1));
    }
    if (front < length)
        return (int)fmin(RW_MOST_PANELS, fmax(2, 1 + shrinking(front, length)));
    return other < length ? (int)fmin(AWAY, shrinking(other, length)) : 0;
}

static bool is_as_before(const rw_segment *s, const rw_segment *before, size_t first)
{
    return before->first == first && before->from == s->from && before->to == s->to &&
           before->label == s->label && before->panels[0] == s->panels[0] &&
           before->panels[1] == s->panels[1] && before->count > 0;
}

/* Adds a segment; if it is the one that was computed at this place last time, it is kept. */
static void add_segment(rw_fronts *f, const rw_stuck *sticks, double from, double to, int label,
                        int finest)
{
    if (NEVER(f->segments == RW_MOST_SEGMENTS)) /* zones share no break */
        return;
    rw_segment *s = &f->segment[f->segments++];
    const rw_segment before = *s;
    *s = (rw_segment){.from = from,
                      .to = to,
                      .label = label,
                      .panels = {panels_towards(f->problem, sticks, from, -1, to - from, finest),
                                 panels_towards(f->problem, sticks, to, 1, to - from, finest)}};
    if (is_as_before(s, &before, f->count)) {
        *s = before;
        f->count += s->count;
        return;
    }
    put_segment(f, s);
    if (s->first != before.first || s->count != before.count) /* it has taken the place of others */
        for (int i = f->segments; i < RW_MOST_SEGMENTS; i++)
            f->segment[i].count = 0;
}

/* Whether dt is 0 there: the places slipped this way before, and friction has not changed; or the
 * layer is all of the change. */
static bool is_spent(const rw_fronts *f, int label, double from, double to)
{
    const rw_zones *old = &f->problem->old->zones;
    if (f->problem->is_rate && label == f->layers.weight[0])
        return true;
    for (int i = 0; f->problem->is_still && i < old->count; i++)
        if (old->zone[i].label == label && from >= old->zone[i].left && to <= old->zone[i].right)
            return true;
    return false;
}

int rw_breaks_between(const rw_problem *p, double from, double to, double at[])
{
    const double other[] = {p->to.left, p->to.right, p->from.left, p->from.right};
    int n = 1 + rw_bends_between(p->frame, from, to, at + 1);
    at[0] = from;
    for (int i = 0; i < 4; i++)
        if (other[i] > from && other[i] < to)
            at[n++] = other[i];
    for (int i = 0; i < p->old->kinks; i++)
        if (p->old->kink[i] > from && p->old->kink[i] < to)
            at[n++] = p->old->kink[i];
    at[n++] = to;
    rw_sort(at, (size_t)n);
    return n;
}

static void add_zone(rw_fronts *f, const rw_stuck *sticks, rw_zone zone, int finest)
{
    double at[RW_MOST_BREAKS];
    const int n = rw_breaks_between(f->problem, zone.left, zone.right, at);
    for (int i = 0; i + 1 < n; i++)
        if (at[i + 1] > at[i] && !is_spent(f, zone.label, at[i], at[i + 1]))
            add_segment(f, sticks, at[i], at[i + 1], zone.label, finest);
}

void rw_fronts_forget(rw_fronts *f)
{
    for (int i = 0; i < RW_MOST_SEGMENTS; i++)
        f->segment[i].count = 0;
}

void rw_fronts_collect(rw_fronts *f, const rw_zones *zones, const rw_layers *layers, int finest)
{
    const rw_problem *p = f->problem;
    const rw_stuck sticks = rw_stuck_of(f, zones);
    if (layers->count > f->layers.count)
        rw_fronts_forget(f);
    f->layers = *layers;
    f->segments = 0;
    f->count = 0;
    if (p->both.left < p->to.left)
        add_zone(f, &sticks, (rw_zone){0, p->both.left, p->to.left}, finest);
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label != 0)
            add_zone(f, &sticks, zones->zone[i], finest);
    if (p->both.right > p->to.right)
        add_zone(f, &sticks, (rw_zone){0, p->to.right, p->both.right}, finest);
    add_layers(f);
    set_X(&sticks, f->count, f->x, f->X);
}

/* ---- Next to a front ---- */

/* The sum over j of share_j/(distance_j + away) at n places. */
RW_INLINE void sum_shares(int n, const double share[], const double distance[],
                          const double away[RW_TERMS], double sum[RW_TERMS])
{
    double all[RW_TERMS] = {0};
    for (int j = 0; j < n; j++)
        RW_EACH (i, RW_TERMS)
            all[i] += share[j] / (distance[j] + away[i]);
    memcpy(sum, all, sizeof all);
}

RW_DISPATCH(set_shares, sum_shares,
            (int n, const double share[], const double distance[], const double away[RW_TERMS],
             double sum[RW_TERMS]),
            (n, share, distance, away, sum))

/* dt/X is level/sqrt(distance) at the end of a segment. Of such a function the integral over the
 * last panel is known. */
static void lack_at_end(const rw_fronts *f, const rw_segment *s, int side, size_t n,
                        const double x[], double lack[RW_TERMS])
{
    const size_t first = s->first + (size_t)(side ? (s->panels[0] + 1) * f->order : 0);
    const double end = side ? s->to : s->from, least = AT_FRONT * f->problem->half;
    const double width = last_panel(s, side);
    double distance[RW_TERMS], share[RW_TERMS], away[RW_TERMS];
    for (int j = 0; j < f->order; j++) {
        distance[j] = fmax(fabs(f->x[first + (size_t)j] - end), least);
        share[j] = f->step[first + (size_t)j] / sqrt(distance[j]);
    }
    for (size_t i = 0; i < RW_TERMS; i++)
        away[i] = i < n ? fmax(fabs(x[i] - end), least) : 1;
    set_shares(f->order, share, distance, away, lack);
    const double level = f->change[first] / f->step[first] * sqrt(distance[0]);
    for (size_t i = 0; i < n; i++)
        lack[i] = level * (2 / sqrt(away[i]) * atan(sqrt(width / away[i])) - lack[i]);
}

/* The zone that sticks at x, or the next one. */
static int zone_at(const rw_stuck *s, double x)
{
    int zone = 0;
    while (zone + 1 < s->count && x > s->end[2 * zone + 1])
        zone++;
    return zone;
}

/* Adds it at the places of the zone of which the end is one. */
static void add_lack(const rw_fronts *f, const rw_segment *segment, int side, int zone, size_t n,
                     const double x[], const int zone_of[], double lack[])
{
    double there[RW_TERMS];
    bool is_near = false;
    for (size_t i = 0; i < n; i++)
        is_near = is_near || zone_of[i] == zone;
    if (!is_near)
        return;
    lack_at_end(f, segment, side, n, x, there);
    for (size_t i = 0; i < n; i++)
        if (zone_of[i] == zone)
            lack[i] += side ? -there[i] : there[i];
}

void rw_fronts_lack(const rw_fronts *f, const rw_stuck *s, size_t n, const double x[],
                    double lack[])
{
    int zone_of[RW_TERMS];
    for (size_t i = 0; i < n; i++) {
        zone_of[i] = zone_at(s, x[i]);
        lack[i] = 0;
    }
    for (int i = 0; i < f->segments; i++)
        for (int zone = 0; zone < s->count; zone++) {
            if (f->segment[i].to == s->end[2 * zone])
                add_lack(f, &f->segment[i], 1, zone, n, x, zone_of, lack);
            if (f->segment[i].from == s->end[2 * zone + 1])
                add_lack(f, &f->segment[i], 0, zone, n, x, zone_of, lack);
        }
}
