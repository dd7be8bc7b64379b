/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Branch and bound over the circle of phi. On an arc a wave is a quotient of quadratic polynomials
 * of tan(phi/2). Its Bernstein coefficients are its values at the two ends and at the point where
 * the tangents of the ends meet. The largest coefficients of all loads bound the largest of their
 * waves, and the coefficients of a product or a sum bound it, to the second order in the arc's
 * length. An arc is left out when no plane in it can have more than the best plane so far. An arc
 * that is halved keeps only the waves that can matter in it. Where one wave of each kind is left,
 * the derivative is a polynomial with one root. So no plane exceeds the result by more than
 * rounding. */
#include "planes/plane_search.h"

#include "base/always.h"
#include "base/root.h"
#include "base/select.h"

#include <float.h>

/* An arc without room has no more than FEW members of a kind. More are not compared with each
 * other. */
enum { ARCS = 16, FEW = 64 };

/* Arcs never get this short: at 1e-7 the bound exceeds the products at the ends by less than
 * noise. */
static const double SHORTEST = 1e-9;

/* A product this small has too few digits to be compared. */
static const double NOTHING = 1e-200;

typedef struct {
    rw_direction from, to;
    double tangent; /* of half of its angle */
} arc;

/* The kinds of waves: the highest peak; the top of the range; its bottom, as the top of the waves
 * with opposite sign. */
enum { PEAK, TOP, BOTTOM, KINDS = RW_WAVE_KINDS };

/* Values at the ends and, in the middle, where the tangents of the ends meet. */
typedef struct {
    double at[3];
} control;

typedef struct {
    const rw_stress_cycle *cycle;
    double best, noise; /* the largest product or sum so far; what counts as none */
    rw_direction where;
    size_t capacity;
    rw_wave *member[KINDS];
} search;

/* ---- Waves ---- */

static inline void waves_of(const rw_stress_cycle *cycle, size_t load, rw_wave wave[KINDS])
{
    const size_t i = load * cycle->stride;
    const double xx = cycle->sxx[i], yy = cycle->syy[i], t = cycle->txy[i];
    const double s = (xx + yy) / 2, d = (yy - xx) / 2;
    wave[PEAK] = (rw_wave){cycle->offset + cycle->gain * s, cycle->gain * d, cycle->gain * t};
    wave[TOP] = (rw_wave){cycle->mean * s, cycle->normal * d + cycle->shear * t,
                          cycle->normal * t - cycle->shear * d};
    wave[BOTTOM] = (rw_wave){-wave[TOP].mean, -wave[TOP].cosine, -wave[TOP].sine};
}

static inline double value_at(const rw_wave *w, rw_direction u)
{
    return w->mean + w->cosine * u.cosine + w->sine * u.sine;
}

static inline double magnitude(const rw_wave *w)
{
    return fabs(w->mean) + fabs(w->cosine) + fabs(w->sine);
}

static inline control control_of(const rw_wave *w, const arc *a)
{
    const double from = value_at(w, a->from), to = value_at(w, a->to);
    const double square = a->tangent * a->tangent;
    return (control){{from, (from + to) * (1 + square) / 2 - w->mean * square, to}};
}

static inline void raise(control *c, const control *other)
{
    for (int i = 0; i < 3; i++)
        c->at[i] = rw_larger(c->at[i], other->at[i]);
}

static inline double top_of(const control *c)
{
    return rw_larger(rw_larger(c->at[0], c->at[1]), c->at[2]);
}

static inline double bottom_of(const control *c)
{
    return -rw_larger(rw_larger(-c->at[0], -c->at[1]), -c->at[2]);
}

/* Below all; the sum of three is a number. */
static const control LOWEST = {{-DBL_MAX / 4, -DBL_MAX / 4, -DBL_MAX / 4}};

/* ---- Bounds ---- */

static inline double bound_of_sum(const control *x, const control *y, const control *z)
{
    double most = -DBL_MAX;
    for (int i = 0; i < 3; i++)
        most = rw_larger(most, x->at[i] + y->at[i] + z->at[i]);
    return most;
}

/* An upper bound of the products of a positive wave below x and a wave below the sum of y and z. */
static inline double bound_of_product(const arc *a, const control *x, const control *y,
                                      const control *z)
{
    const double weight = 4 / (1 + a->tangent * a->tangent);
    double p[3], q[3];
    for (int i = 0; i < 3; i++) {
        p[i] = rw_larger(0, x->at[i]);
        q[i] = rw_larger(0, y->at[i] + z->at[i]);
    }
    const double first = (p[0] * q[1] + p[1] * q[0]) / 2, last = (p[1] * q[2] + p[2] * q[1]) / 2;
    const double middle = (p[0] * q[2] + weight * p[1] * q[1] + p[2] * q[0]) / (2 + weight);
    return rw_larger(rw_larger(first, last), middle);
}

static inline double bound(const search *s, const arc *a, const control *x, const control *y,
                           const control *z)
{
    return s->cycle->is_sum ? bound_of_sum(x, y, z) : bound_of_product(a, x, y, z);
}

static bool may_exceed(const search *s, const arc *a, const control c[KINDS])
{
    return ALWAYS(a->tangent > SHORTEST) &&
           bound(s, a, &c[PEAK], &c[TOP], &c[BOTTOM]) > s->best + s->noise;
}

static void record(search *s, rw_direction u, double peak, double range)
{
    const double value = s->cycle->is_sum ? peak + range : rw_larger(0, peak) * range;
    if (value > s->best) {
        s->best = value;
        s->where = u;
    }
}

static arc half_of(const arc *a, rw_direction from, rw_direction to)
{
    return (arc){from, to, rw_half_tangent(a->tangent)};
}

static rw_direction middle_of(const arc *a)
{
    const double factor = sqrt(1 + a->tangent * a->tangent) / 2;
    return (rw_direction){factor * (a->from.cosine + a->to.cosine),
                          factor * (a->from.sine + a->to.sine)};
}

/* ---- One wave of each kind ---- */

/* The derivative of the product, times (1+x^2)^2, x the tangent of half the angle from the middle
 * of the arc. */
typedef struct {
    double coefficient[5];
} quartic;

static double quartic_at(double x, const void *context)
{
    const double *c = ((const quartic *)context)->coefficient;
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

static rw_wave turned(const rw_wave *w, rw_direction u)
{
    return (rw_wave){w->mean, w->cosine * u.cosine + w->sine * u.sine,
                     w->sine * u.cosine - w->cosine * u.sine};
}

/* A wave times 1+x^2, (mean+cosine) + 2 sine x + (mean-cosine) x^2, and its derivative by phi, sine
 * - 2 cosine x - sine x^2. */
static quartic derivative(const rw_wave *v, const rw_wave *w)
{
    const double sines = 4 * v->sine * w->sine;
    return (quartic){
        {v->sine * (w->mean + w->cosine) + w->sine * (v->mean + v->cosine),
         sines - 2 * (v->cosine * (w->mean + w->cosine) + w->cosine * (v->mean + v->cosine)),
         -6 * (v->sine * w->cosine + w->sine * v->cosine),
         -sines - 2 * (v->cosine * (w->mean - w->cosine) + w->cosine * (v->mean - v->cosine)),
         -v->sine * (w->mean - w->cosine) - w->sine * (v->mean - v->cosine)}};
}

static rw_wave sum_of(const rw_wave *v, const rw_wave *w)
{
    return (rw_wave){v->mean + w->mean, v->cosine + w->cosine, v->sine + w->sine};
}

/* The largest value on an arc where its derivative has at most one root; false where it may have
 * more. Without a root, or where the root is a minimum, the largest value is at an end, where it is
 * known already. A sum is a product with 1. */
static bool settle(search *s, const arc *a)
{
    const rw_direction u = middle_of(a);
    const rw_wave peak = s->member[PEAK][0],
                  range = sum_of(&s->member[TOP][0], &s->member[BOTTOM][0]);
    const rw_wave sum = sum_of(&peak, &range), unit = {1, 0, 0};
    const rw_wave v = s->cycle->is_sum ? unit : turned(&peak, u),
                  w = turned(s->cycle->is_sum ? &sum : &range, u);
    const quartic slope = derivative(&v, &w);
    const double *c = slope.coefficient;
    const double reach = half_of(a, u, u).tangent; /* x at the end of the arc */
    if (fabs(c[1]) <= reach * (2 * fabs(c[2]) + reach * (3 * fabs(c[3]) + reach * 4 * fabs(c[4]))))
        return false;
    const double x = rw_root(quartic_at, &slope, -reach, reach, DBL_EPSILON / 8);
    if (!isnan(x)) { /* rounding of the bound keeps arcs too that are not above their ends */
        const rw_direction there = rw_turned_by(u, x);
        record(s, there, value_at(&peak, there), value_at(&range, there));
    }
    return true;
}

/* ---- A few waves ---- */

/* Whether a member of that kind can have a part in a value larger than the best. */
static inline bool matters(const search *s, const arc *a, const control c[KINDS], int kind,
                           const control *own)
{
    const control *p[KINDS] = {&c[PEAK], &c[TOP], &c[BOTTOM]};
    p[kind] = own;
    return bound(s, a, p[PEAK], p[TOP], p[BOTTOM]) > s->best + s->noise;
}

/* A load of a cycle often comes again, exactly or to rounding. */
static bool is_new(const search *s, int kind, size_t count, const rw_wave *w)
{
    const rw_wave *member = s->member[kind];
    const double rounding = DBL_EPSILON * magnitude(w);
    for (size_t i = 0; i < count; i++)
        if (fabs(member[i].mean - w->mean) + fabs(member[i].cosine - w->cosine) +
                fabs(member[i].sine - w->sine) <=
            rounding)
            return false;
    return true;
}

/* Moves the members that matter to the front, and returns how many they are. */
static size_t keep(search *s, const arc *a, const control c[KINDS], int kind, size_t count,
                   double least)
{
    rw_wave *member = s->member[kind];
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        const rw_wave w = member[i];
        const control own = control_of(&w, a);
        if (top_of(&own) >= least && matters(s, a, c, kind, &own) &&
            (count > FEW || is_new(s, kind, kept, &w))) {
            member[i] = member[kept];
            member[kept++] = w;
        }
    }
    return kept;
}

static double highest_at(const search *s, int kind, size_t count, rw_direction u)
{
    double highest = -DBL_MAX;
    for (size_t i = 0; i < count; i++)
        highest = rw_larger(highest, value_at(&s->member[kind][i], u));
    return highest;
}

/* Searches the arc with the first count[] members of each kind. The calls for its halves change
 * their order, but not which members are among the first. */
static void refine(search *s, const arc *a, const size_t count[KINDS])
{
    control c[KINDS] = {LOWEST, LOWEST, LOWEST};
    double least[KINDS] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
    for (int kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < count[kind]; i++) {
            const control own = control_of(&s->member[kind][i], a);
            raise(&c[kind], &own);
            least[kind] = rw_larger(least[kind], bottom_of(&own));
        }
    if (!may_exceed(s, a, c))
        return;
    size_t kept[KINDS];
    for (int kind = 0; kind < KINDS; kind++)
        kept[kind] = keep(s, a, c, kind, count[kind], least[kind]);
    if (kept[PEAK] == 0 || kept[TOP] == 0 || kept[BOTTOM] == 0)
        return;
    if (kept[PEAK] == 1 && kept[TOP] == 1 && kept[BOTTOM] == 1 && settle(s, a))
        return;
    const rw_direction u = middle_of(a);
    record(s, u, highest_at(s, PEAK, kept[PEAK], u),
           highest_at(s, TOP, kept[TOP], u) + highest_at(s, BOTTOM, kept[BOTTOM], u));
    const arc left = half_of(a, a->from, u), right = half_of(a, u, a->to);
    refine(s, &left, kept);
    refine(s, &right, kept);
}

/* ---- All loads ---- */

static void controls_of(const rw_stress_cycle *cycle, const arc *a, control c[KINDS])
{
    for (int kind = 0; kind < KINDS; kind++)
        c[kind] = LOWEST;
    for (size_t i = 0; i < cycle->loads; i++) {
        rw_wave wave[KINDS];
        waves_of(cycle, i, wave);
        for (int kind = 0; kind < KINDS; kind++) {
            const control own = control_of(&wave[kind], a);
            raise(&c[kind], &own);
        }
    }
}

static double value_of(const search *s, double peak, double range)
{
    return s->cycle->is_sum ? peak + range : peak * range;
}

/* The members that may matter in the arc, by a bound of the first order, which is quick; false
 * where there are too many. */
static bool gather(search *s, const arc *a, const control c[KINDS], size_t count[KINDS])
{
    const double peak = top_of(&c[PEAK]), top = top_of(&c[TOP]), bottom = top_of(&c[BOTTOM]);
    const double least = s->best + s->noise;
    const bool are_many = s->cycle->loads > FEW; /* among few, keep() finds those that come again */
    for (int kind = 0; kind < KINDS; kind++)
        count[kind] = 0;
    for (size_t i = 0; i < s->cycle->loads; i++) {
        rw_wave wave[KINDS];
        waves_of(s->cycle, i, wave);
        const control peak_of = control_of(&wave[PEAK], a), range_of = control_of(&wave[TOP], a);
        const double most[KINDS] = {value_of(s, top_of(&peak_of), top + bottom),
                                    value_of(s, peak, top_of(&range_of) + bottom),
                                    value_of(s, peak, top - bottom_of(&range_of))};
        for (int kind = 0; kind < KINDS; kind++) {
            if (most[kind] <= least ||
                (are_many && count[kind] <= FEW && !is_new(s, kind, count[kind], &wave[kind])))
                continue;
            if (count[kind] == s->capacity)
                return false;
            s->member[kind][count[kind]++] = wave[kind];
        }
    }
    return true;
}

static void explore(search *s, const arc *a, const control c[KINDS])
{
    if (!may_exceed(s, a, c))
        return;
    size_t count[KINDS];
    if (gather(s, a, c, count)) {
        refine(s, a, count);
        return;
    }
    const rw_direction u = middle_of(a);
    const arc half[2] = {half_of(a, a->from, u), half_of(a, u, a->to)};
    control within[2][KINDS];
    for (int i = 0; i < 2; i++)
        controls_of(s->cycle, &half[i], within[i]);
    record(s, u, within[0][PEAK].at[2], within[0][TOP].at[2] + within[0][BOTTOM].at[2]);
    for (int i = 0; i < 2; i++)
        explore(s, &half[i], within[i]);
}

/* ---- The circle ---- */

#define C1 0.92387953251128676
#define C2 0.70710678118654752
#define C3 0.38268343236508977

/* ARCS equal arcs begin at these. */
static const double COSINES[ARCS] = {1,  C1,  C2,  C3,  0, -C3, -C2, -C1,
                                     -1, -C1, -C2, -C3, 0, C3,  C2,  C1};
static const double SINES[ARCS] = {0, C3,  C2,  C1,  1,  C1,  C2,  C3,
                                   0, -C3, -C2, -C1, -1, -C1, -C2, -C3};
static const double TANGENT = 0.19891236737965801; /* of pi/ARCS */

/* The largest wave of each kind at the ends of the arcs; the smallest mean and the largest
 * magnitude of all loads. */
typedef struct {
    double highest[KINDS][ARCS], least_mean[KINDS], magnitude[KINDS];
} survey;

/* The waves in two opposite directions at once. */
static inline void raise_all(double highest[ARCS], const rw_wave *w)
{
#pragma GCC unroll 1 /* unrolled it would not become vector instructions */
    for (int k = 0; k < ARCS / 2; k++) {
        const double deviation = w->cosine * COSINES[k] + w->sine * SINES[k];
        const double ahead = w->mean + deviation, behind = w->mean - deviation;
        highest[k] = rw_larger(highest[k], ahead);
        highest[k + ARCS / 2] = rw_larger(highest[k + ARCS / 2], behind);
    }
}

static void survey_of(const rw_stress_cycle *cycle, survey *v)
{
    for (int kind = 0; kind < KINDS; kind++) {
        for (int k = 0; k < ARCS; k++)
            v->highest[kind][k] = -DBL_MAX;
        v->least_mean[kind] = DBL_MAX;
        v->magnitude[kind] = 0;
    }
    for (size_t i = 0; i < cycle->loads; i++) {
        rw_wave wave[KINDS];
        waves_of(cycle, i, wave);
        for (int kind = 0; kind < KINDS; kind++) {
            raise_all(v->highest[kind], &wave[kind]);
            v->least_mean[kind] = -rw_larger(-v->least_mean[kind], -wave[kind].mean);
            v->magnitude[kind] = rw_larger(v->magnitude[kind], magnitude(&wave[kind]));
        }
    }
}

static rw_direction start_of(int k)
{
    return (rw_direction){COSINES[k % ARCS], SINES[k % ARCS]};
}

/* The control points of the largest of all waves, as control_of() has those of one: with the mean
 * the tangents' point falls. */
static control control_between(const survey *v, int kind, int k)
{
    const double from = v->highest[kind][k % ARCS], to = v->highest[kind][(k + 1) % ARCS];
    const double square = TANGENT * TANGENT;
    return (control){{from, (from + to) * (1 + square) / 2 - v->least_mean[kind] * square, to}};
}

/* The arc with the largest bound comes first: most others are then left out at once. */
static void explore_all(search *s, const survey *v)
{
    arc a[ARCS];
    control c[ARCS][KINDS];
    int first = 0;
    double most = -DBL_MAX;
    for (int k = 0; k < ARCS; k++) {
        a[k] = (arc){start_of(k), start_of(k + 1), TANGENT};
        for (int kind = 0; kind < KINDS; kind++)
            c[k][kind] = control_between(v, kind, k);
        const double limit = bound(s, &a[k], &c[k][PEAK], &c[k][TOP], &c[k][BOTTOM]);
        if (limit > most) {
            most = limit;
            first = k;
        }
    }
    for (int k = first; k < first + ARCS; k++)
        explore(s, &a[k % ARCS], c[k % ARCS]);
}

static double noise_of(const rw_stress_cycle *cycle, const survey *v)
{
    const double range = v->magnitude[TOP] + v->magnitude[BOTTOM], peak = v->magnitude[PEAK];
    return rw_larger(NOTHING, 8 * DBL_EPSILON * (cycle->is_sum ? peak + range : peak * range));
}

double rw_plane_search(const rw_stress_cycle *cycle, rw_direction *phi)
{
    rw_wave few[KINDS * FEW];
    survey v;
    survey_of(cycle, &v);
    search s = {.cycle = cycle,
                .best = cycle->is_sum ? -DBL_MAX : 0,
                .noise = noise_of(cycle, &v),
                .where = start_of(0),
                .capacity = cycle->room ? cycle->loads : FEW};
    for (int kind = 0; kind < KINDS; kind++)
        s.member[kind] = (cycle->room ? cycle->room : few) + (size_t)kind * s.capacity;
    for (int k = 0; k < ARCS; k++)
        record(&s, start_of(k), v.highest[PEAK][k], v.highest[TOP][k] + v.highest[BOTTOM][k]);
    explore_all(&s, &v);
    *phi = s.where;
    return s.best;
}
