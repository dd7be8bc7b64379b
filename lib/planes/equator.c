/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound, as in worst_plane.c, in one dimension. */
#include "planes/equator.h"

#include "base/always.h"
#include "base/domain.h"

#include <float.h>

enum { ENDS = 2 };

/* No arc is as short: its bound is above the value by less than noise. */
static const double SHORTEST = 1e-9;

typedef struct {
    rw_plane_cycle *cycle;
    const rw_severity *severity;
    double noise;
    rw_worst_plane *best;
    rw_direction *psi;
} search;

/* ---- One load ---- */

/* The quantity that counts by its range, and the normal stress: the value at the middle of the arc,
 * half of the change over the arc, and a bound on the remainder. */
typedef struct {
    double along, change, rest, peak, peak_change, peak_rest;
} wave;

static inline wave wave_of(bool is_strain, const rw_item *load, const rw_psi_arc *arc)
{
    const double C = arc->psi.cosine, S = arc->psi.sine, h = arc->half;
    const double deviation = load->deviation_d * C + load->deviation_t * S,
                 shear = load->deviation_t * C - load->deviation_d * S;
    const double turned = h * (load->t * C - load->d * S), square = h * h / 2;
    return (wave){.along = is_strain ? load->level - load->deviation_lift + deviation : shear,
                  .change = h * (is_strain ? shear : -deviation),
                  .rest = square * load->deviation_size,
                  .peak = load->z - load->lift + (load->d * C + load->t * S),
                  .peak_change = turned,
                  .peak_rest = square * load->size};
}

/* ---- All loads on an arc ---- */

/* Values at the middle; upper bounds at the ends; lower bounds of the largest of all loads. */
typedef struct {
    double high, low, peak;
    double top[ENDS], bottom[ENDS], peaks[ENDS];
    double least_top, most_bottom, least_peak;
} view;

static const view NOTHING = {
    .high = -DBL_MAX,
    .low = DBL_MAX,
    .peak = -DBL_MAX,
    .top = {-DBL_MAX, -DBL_MAX},
    .bottom = {DBL_MAX, DBL_MAX},
    .peaks = {-DBL_MAX, -DBL_MAX},
    .least_top = -DBL_MAX,
    .most_bottom = DBL_MAX,
    .least_peak = -DBL_MAX,
};

static void look(const search *w, const rw_psi_arc *arc, size_t n, view *v)
{
    *v = NOTHING;
    for (size_t i = 0; i < n; i++) {
        const wave l = wave_of(w->severity->is_strain, &w->cycle->item[i], arc);
        const double spread = fabs(l.change) + l.rest;
        v->high = rw_larger(v->high, l.along);
        v->low = rw_smaller(v->low, l.along);
        v->peak = rw_larger(v->peak, l.peak);
        for (int k = 0; k < ENDS; k++) {
            const double sign = 1 - 2 * k;
            v->top[k] = rw_larger(v->top[k], l.along + sign * l.change + l.rest);
            v->bottom[k] = rw_smaller(v->bottom[k], l.along + sign * l.change - l.rest);
            v->peaks[k] = rw_larger(v->peaks[k], l.peak + sign * l.peak_change + l.peak_rest);
        }
        v->least_top = rw_larger(v->least_top, l.along - spread);
        v->most_bottom = rw_smaller(v->most_bottom, l.along + spread);
        v->least_peak = rw_larger(v->least_peak, l.peak - fabs(l.peak_change) - l.peak_rest);
    }
}

/* As bound_of() in worst_plane.c. */
static double bound_of(const rw_severity *v, const view *at, double severity[ENDS])
{
    double amplitude[ENDS], factor[ENDS];
    for (int k = 0; k < ENDS; k++) {
        amplitude[k] = (at->top[k] - at->bottom[k]) / 2;
        severity[k] = rw_severity_of(v, amplitude[k], at->peaks[k]);
        factor[k] = v->is_sum ? 0 : rw_larger(0, v->offset + v->gain * at->peaks[k]);
    }
    return rw_larger(severity[0], severity[1]) +
           fabs((amplitude[0] - amplitude[1]) * (factor[0] - factor[1])) / 4;
}

static void record(search *w, const rw_psi_arc *arc, const view *v)
{
    const double amplitude = (v->high - v->low) / 2;
    const double value = rw_severity_of(w->severity, amplitude, v->peak);
    if (value <= w->best->value)
        return;
    *w->best = (rw_worst_plane){.value = value, .amplitude = amplitude, .peak = v->peak};
    *w->psi = arc->psi;
}

/* Which loads are the top, the bottom and the peak somewhere on the arc: the last of each, and how
 * many there are. */
enum { TOP, BOTTOM, PEAK, KINDS };

typedef struct {
    const rw_item *last[KINDS];
    int count[KINDS];
} candidates;

static bool note(candidates *r, int kind, bool matters, const rw_item *load)
{
    if (matters) {
        r->last[kind] = load;
        r->count[kind]++;
    }
    return matters;
}

static bool note_all(candidates *r, const wave *l, const view *v, const rw_item *load)
{
    const double spread = fabs(l->change) + l->rest;
    const bool is_top = note(r, TOP, l->along + spread >= v->least_top, load);
    const bool is_bottom = note(r, BOTTOM, l->along - spread <= v->most_bottom, load);
    const double peak = l->peak + fabs(l->peak_change) + l->peak_rest;
    return note(r, PEAK, peak >= v->least_peak, load) || is_top || is_bottom;
}

/* The loads that are kept stand in front, and `candidates` points to them. */
static size_t keep(search *w, const rw_psi_arc *arc, size_t n, const view *v, candidates *r)
{
    size_t kept = 0;
    *r = (candidates){{NULL}, {0}};
    for (size_t i = 0; i < n; i++) {
        const wave l = wave_of(w->severity->is_strain, &w->cycle->item[i], arc);
        if (note_all(r, &l, v, &w->cycle->item[kept]))
            rw_keep_load(w->cycle, i, kept++);
    }
    return kept;
}

/* ---- Arcs with one top, bottom and peak ---- */

/* The direction of the largest top - bottom + gain peak of a shear, each of one load: a wave. */
static rw_direction crest_of(const rw_severity *v, const candidates *r)
{
    const double d = (r->last[TOP]->deviation_d - r->last[BOTTOM]->deviation_d) / 2,
                 t = (r->last[TOP]->deviation_t - r->last[BOTTOM]->deviation_t) / 2;
    const double C = t + v->gain * r->last[PEAK]->d, S = v->gain * r->last[PEAK]->t - d;
    const double length = sqrt(C * C + S * S);
    /* always: what does not vary is not above its value at the middle */
    return ALWAYS(length > 0) ? (rw_direction){C / length, S / length} : (rw_direction){1, 0};
}

/* The crest, or the end of the arc that is nearer to it. One behind is above all of the arc too. */
static rw_direction nearest_on(const rw_psi_arc *arc, rw_direction crest)
{
    const double across = arc->psi.cosine * crest.sine - arc->psi.sine * crest.cosine;
    const double end = 2 * arc->tangent / (1 + arc->tangent * arc->tangent);
    if (fabs(across) <= end)
        return crest;
    return rw_turned_by(arc->psi, across > 0 ? arc->tangent : -arc->tangent);
}

/* A sum of one load each is a wave, whose largest value is known; whether it is so. */
static bool settle(search *w, const rw_psi_arc *arc, size_t n, const candidates *r)
{
    for (int kind = 0; kind < KINDS; kind++)
        if (!w->severity->is_sum || r->count[kind] != 1)
            return false;
    const rw_psi_arc at = {nearest_on(arc, crest_of(w->severity, r)), 0, 0};
    view v;
    look(w, &at, n, &v);
    record(w, &at, &v);
    return true;
}

static rw_psi_arc half_of(const rw_psi_arc *arc, bool is_forward)
{
    const double tangent = rw_half_tangent(arc->tangent);
    return (rw_psi_arc){rw_turned_by(arc->psi, is_forward ? tangent : -tangent), arc->half / 2,
                        tangent};
}

static void explore(search *w, const rw_psi_arc *arc, size_t n)
{
    view v;
    double severity[ENDS];
    look(w, arc, n, &v);
    record(w, arc, &v);
    if (bound_of(w->severity, &v, severity) <= w->best->value + w->noise || arc->half < SHORTEST)
        return;
    candidates some;
    const size_t kept = keep(w, arc, n, &v, &some);
    if (settle(w, arc, kept, &some))
        return;
    const bool is_forward = severity[0] > severity[1];
    const rw_psi_arc first = half_of(arc, is_forward), second = half_of(arc, !is_forward);
    explore(w, &first, kept);
    explore(w, &second, kept);
}

/* ---- The equator ---- */

enum { ARCS = 8 };

#define DIAGONAL 0.70710678118654752
static const rw_direction CENTRES[ARCS] = {
    {1, 0},  {DIAGONAL, DIAGONAL},   {0, 1},  {-DIAGONAL, DIAGONAL},
    {-1, 0}, {-DIAGONAL, -DIAGONAL}, {0, -1}, {DIAGONAL, -DIAGONAL}};
static const double TANGENT = 0.19891236737965801; /* of pi/16 */

static rw_psi_arc eighth(int k)
{
    return (rw_psi_arc){CENTRES[k], RW_PI / ARCS, TANGENT};
}

/* A product of strain and stress has a search of its own. */
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
    rw_psi_arc at = {{1, 0}, 0, 0};
    view v;
    rw_plane_search(&waves, &at.psi);
    look(w, &at, cycle->loads, &v);
    record(w, &at, &v);
}

static void search_others(search *w)
{
    double bound[ARCS], unused[ENDS];
    for (int k = 0; k < ARCS; k++) {
        const rw_psi_arc arc = eighth(k);
        view v;
        look(w, &arc, w->cycle->loads, &v);
        record(w, &arc, &v);
        bound[k] = bound_of(w->severity, &v, unused);
    }
    for (int turn = 0; turn < ARCS; turn++) {
        int worst = 0;
        for (int k = 1; k < ARCS; k++)
            if (bound[k] > bound[worst])
                worst = k;
        bound[worst] = -DBL_MAX;
        const rw_psi_arc arc = eighth(worst);
        explore(w, &arc, w->cycle->loads);
    }
}

void rw_equator_search(rw_plane_cycle *cycle, const rw_severity *severity, double noise,
                       rw_worst_plane *best, rw_direction *psi)
{
    search w = {cycle, severity, noise, best, psi};
    if (severity->is_strain)
        search_products(&w);
    else
        search_others(&w);
}

/* ---- Away from the equator ---- */

/* Bounds on an arc: least and most of half the range of the amplitude's quantity; half the range of
 * its limit away from the equator; least and most of the peak; the largest lift. */
typedef struct {
    double least, most, beyond, least_peak, most_peak, lift, z;
} reach;

static reach reach_of(const rw_plane_cycle *cycle, const rw_severity *v, const rw_psi_arc *arc,
                      size_t n)
{
    double high = -DBL_MAX, low = DBL_MAX, top = -DBL_MAX, bottom = DBL_MAX, travel = 0, turn = 0;
    reach r = {.least_peak = -DBL_MAX, .lift = -DBL_MAX, .z = -DBL_MAX};
    for (size_t i = 0; i < n; i++) {
        const rw_item *load = &cycle->item[i];
        const wave l = wave_of(v->is_strain, load, arc);
        const double other = v->is_strain
                                 ? load->level
                                 : load->deviation_lift - (load->deviation_d * arc->psi.cosine +
                                                           load->deviation_t * arc->psi.sine);
        high = rw_larger(high, l.along), low = rw_smaller(low, l.along);
        top = rw_larger(top, other), bottom = rw_smaller(bottom, other);
        r.least_peak = rw_larger(r.least_peak, l.peak);
        r.lift = rw_larger(r.lift, load->z - l.peak);
        r.z = rw_larger(r.z, load->z);
        travel = rw_larger(travel, arc->half * load->deviation_size);
        turn = rw_larger(turn, arc->half * load->size);
    }
    r.least = rw_larger(0, (high - low) / 2 - travel);
    r.most = (high - low) / 2 + travel;
    r.beyond = (top - bottom) / 2 + (v->is_strain ? 0 : travel);
    r.most_peak = r.least_peak + turn;
    r.least_peak -= turn;
    r.lift += turn;
    return r;
}

/* With u the square of sin(beta), the half range r of a strain becomes at most (1-u) r + u beyond,
 * that of a shear stress at most sqrt((1-u) (r^2 + u beyond^2)); a peak rises by at most u lift. */
static bool falls_away(const rw_severity *v, const reach *r)
{
    const double factor = v->is_sum ? r->least : v->offset + v->gain * r->least_peak;
    if (r->least <= 0 || factor <= 0)
        return false;
    const double ratio = r->beyond / r->least;
    const double fall = v->is_strain ? 1 - ratio : (1 - ratio * ratio) / 2;
    return v->gain * rw_larger(0, r->lift) <= fall * factor;
}

/* Above the amplitude for every beta. */
static double most_amplitude(const rw_severity *v, const reach *r)
{
    if (r->beyond <= r->most)
        return r->most;
    return v->is_strain ? r->beyond : (r->most / r->beyond * r->most + r->beyond) / 2;
}

bool rw_equator_is_worst(const rw_plane_cycle *cycle, const rw_severity *severity,
                         const rw_psi_arc *arc, size_t n, double value)
{
    const reach r = reach_of(cycle, severity, arc, n);
    return falls_away(severity, &r) || rw_severity_of(severity, most_amplitude(severity, &r),
                                                      rw_larger(r.most_peak, r.z)) <= value;
}

/* With u the square of sin(beta), the amplitude is at most (1-u) r + u beyond, the peak at most
 * (1-u) p + u z, and r p at most the value. Plane stress has no stress z across the plane, plane
 * strain no strain `beyond`. So what is left of the product is u (1-u) (r z + p beyond). */
static bool has_worst_product(const rw_plane_cycle *cycle, double value)
{
    double r = 0, p = 0, z = 0, top = -DBL_MAX, bottom = DBL_MAX;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        r = rw_larger(r, fabs(load->level - load->deviation_lift) + load->deviation_size);
        p = rw_larger(p, load->z - load->lift + load->size);
        z = rw_larger(z, load->z);
        top = rw_larger(top, load->level), bottom = rw_smaller(bottom, load->level);
    }
    const double beyond = (top - bottom) / 2;
    return r * z + p * beyond <= 2 * value;
}

/* How often an arc is halved to show that no plane away from it is worse. */
enum { DEPTH = 7 };

static bool is_worst(const rw_plane_cycle *cycle, const rw_severity *v, const rw_psi_arc *arc,
                     int depth, double value)
{
    if (rw_equator_is_worst(cycle, v, arc, cycle->loads, value))
        return true;
    const rw_psi_arc first = half_of(arc, false), second = half_of(arc, true);
    return depth > 0 && is_worst(cycle, v, &first, depth - 1, value) &&
           is_worst(cycle, v, &second, depth - 1, value);
}

bool rw_equator_has_worst(const rw_plane_cycle *cycle, const rw_severity *severity, double value,
                          double noise)
{
    if (severity->is_strain && has_worst_product(cycle, value))
        return true;
    for (int k = 0; k < ARCS; k++) {
        const rw_psi_arc arc = eighth(k);
        if (!is_worst(cycle, severity, &arc, DEPTH, value + noise))
            return false;
    }
    return true;
}
