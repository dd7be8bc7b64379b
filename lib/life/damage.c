/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damage of a block of loads by Miner's sum, on the plane where it is largest. Damage is not smooth
 * over the planes: cycles pair up anew, and fall below a limit. So planes are taken from a grid,
 * and steps are made from the worst of them, smaller and smaller, to the LAST one.
 * The plane on which the criterion itself is largest is among them: for a block of one cycle it is
 * the plane that is sought. */
#include "base/domain.h"
#include "life/life.h"
#include "life/rainflow.h"
#include "planes/plane_cycle.h"
#include "planes/plane_search.h"
#include "measures/planes.h"

#include <float.h>
#include <stdlib.h>

/* Steps are the tangents of half of the angles: of the grid in psi (10 degrees), beta (5) and
 * across (15); the last one. A worst plane is another one if it is more than 15 degrees away. */
enum { ACROSS_EQUATOR = 36, UP = 19, ACROSS = 12, STARTS = 4 };
static const double PSI_STEP = 0.087488663525924007, BETA_STEP = 0.043660942908512059,
                    ACROSS_STEP = 0.13165249758739585, LAST = 2e-5, APART = 0.9659258262890683;

/* A plane is left out if an upper bound of its damage (as many cycles as possible, each as bad as
 * possible there) is less than this part of the largest damage so far. Starts are left out
 * likewise: steps of half of the grid's do not double the damage of a plane. After these steps, a
 * start that is BEHIND by this factor does not catch up. */
static const double HOPELESS = 0.5, BEHIND = 0.95;

/* A part of the largest range of a component: for the bound, cycles above it are as bad as the
 * worst one, others as bad as a cycle of this range. */
static const double LARGE = 0.7;

/* Cycles this small, relative to the largest, are rounding and are not counted. */
static const double ROUNDING = 1e-9;

/* across: the direction in the plane in which its shear is taken. */
typedef struct {
    rw_direction psi, beta, across;
} plane;

typedef struct {
    plane at;
    double damage, cycles;
} verdict;

typedef struct {
    const rw_criterion *criterion;
    const rw_life_curve *curve;
    rw_life_table *table; /* of the curve */
    bool is_exact;        /* by the curve itself, where the worst plane is known */
    rw_severity severity;
    double unit;
    rw_plane_cycle *cycle;
    rw_vector *path;       /* the strain, or both components of the shear stress */
    double *along, *other; /* one component; the normal stress */
    rw_reversal *stack;
    rw_counted_cycle *counted;
    verdict best[STARTS]; /* falling */
    bool leaves_domain;
} miner;

/* ---- One plane ---- */

/* Upper bounds of the range of the path and of the normal stress. */
typedef struct {
    double low_x, high_x, low_y, high_y, peak;
} extent;

static void extend(extent *e, rw_vector at, double normal)
{
    e->low_x = rw_smaller(e->low_x, at.x), e->high_x = rw_larger(e->high_x, at.x);
    e->low_y = rw_smaller(e->low_y, at.y), e->high_y = rw_larger(e->high_y, at.y);
    e->peak = rw_larger(e->peak, normal);
}

static double half_diagonal(const extent *e)
{
    const double x = e->high_x - e->low_x, y = e->high_y - e->low_y;
    return sqrt(x * x + y * y) / 2;
}

static extent go_through(miner *m, const plane *p)
{
    const double C = p->psi.cosine, S = p->psi.sine, c = p->beta.cosine, s = p->beta.sine;
    extent e = {DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < m->cycle->loads; i++) {
        const rw_item *load = &m->cycle->item[i];
        const double lift = load->lift - (load->d * C + load->t * S);
        m->other[i] = load->z - c * c * lift;
        m->path[i] = m->severity.is_strain
                         ? (rw_vector){load->level - c * c * lift, 0}
                         : (rw_vector){c * (load->t * C - load->d * S), s * c * lift};
        extend(&e, m->path[i], m->other[i]);
    }
    return e;
}

/* The damage of one cycle, given its amplitude and its largest normal stress. */
static double damage_of(miner *m, double amplitude, double peak)
{
    const rw_worst_plane at = {.value = rw_severity_of(&m->severity, amplitude, peak)};
    const double value = m->criterion->value(m->criterion, &at, m->unit);
    if (value < RW_SMALLEST)
        return 0;
    const double life = m->is_exact ? rw_life(m->curve, value) : rw_life_by_table(m->table, value);
    m->leaves_domain = m->leaves_domain || isnan(life);
    return isnan(life) ? 0 : 1 / life;
}

static bool may_be_worse(miner *m, double most)
{
    return most > HOPELESS * m->best[0].damage;
}

static double most_cycles(const miner *m)
{
    return (double)(m->cycle->loads / 2);
}

/* The half range of the path in a direction. */
static double resolve(miner *m, rw_direction across)
{
    double low = DBL_MAX, high = -DBL_MAX;
    for (size_t i = 0; i < m->cycle->loads; i++) {
        m->along[i] = m->path[i].x * across.cosine + m->path[i].y * across.sine;
        low = rw_smaller(low, m->along[i]);
        high = rw_larger(high, m->along[i]);
    }
    return (high - low) / 2;
}

/* How many cycles of the component have at least this range, or one more: half of the number of
 * ways from turn to turn, smaller ways being passed over. */
static double larger_cycles(const miner *m, double range)
{
    size_t ways = 0;
    double turn = m->along[0], sign = 1;
    for (size_t i = 1; i < m->cycle->loads; i++) {
        const double beyond = sign * (m->along[i] - turn);
        if (beyond > 0 || -beyond >= range)
            turn = m->along[i];
        if (-beyond >= range)
            sign = -sign, ways++;
    }
    return (double)(ways / 2 + 1);
}

static bool may_component_be_worse(miner *m, double amplitude, double peak)
{
    const double many = most_cycles(m), worst = damage_of(m, amplitude, peak);
    if (!may_be_worse(m, many * worst))
        return false;
    const double large = larger_cycles(m, 2 * LARGE * amplitude);
    return may_be_worse(m, large * worst +
                               rw_larger(0, many - large) * damage_of(m, LARGE * amplitude, peak));
}

static verdict count(miner *m, const plane *p)
{
    resolve(m, p->across);
    const size_t cycles =
        rw_rainflow(m->cycle->loads, m->along, m->other, true, m->stack, m->counted);
    verdict v = {*p, 0, 0};
    double largest = 0;
    for (size_t k = 0; k < cycles; k++)
        largest = rw_larger(largest, m->counted[k].range);
    for (size_t k = 0; k < cycles; k++) {
        if (m->counted[k].range <= ROUNDING * largest)
            continue;
        v.cycles += m->counted[k].count;
        v.damage +=
            m->counted[k].count * damage_of(m, m->counted[k].range / 2, m->counted[k].highest);
    }
    return v;
}

/* ---- The worst planes ---- */

static double cosine_between(const plane *a, const plane *b)
{
    /* psi is twice the angle in the plane of x and y */
    const double twice = a->psi.cosine * b->psi.cosine + a->psi.sine * b->psi.sine;
    const double once = sqrt(rw_larger(0, (1 + twice) / 2));
    return fabs(a->beta.cosine * b->beta.cosine) * once + fabs(a->beta.sine * b->beta.sine);
}

/* Puts a plane into the list in place of a near one, or of the least, if it is worse. The list
 * stays in order. */
static void note(miner *m, const verdict *v)
{
    int place = STARTS - 1;
    for (int i = STARTS - 1; i >= 0; i--)
        if (m->best[i].damage > 0 && cosine_between(&m->best[i].at, &v->at) > APART)
            place = i;
    if (v->damage <= m->best[place].damage)
        return;
    for (; place > 0 && m->best[place - 1].damage < v->damage; place--)
        m->best[place] = m->best[place - 1];
    m->best[place] = *v;
}

static void look_at_all_directions(miner *m, plane p, double peak)
{
    const bool is_line = m->severity.is_strain || p.beta.sine == 0;
    p.across = (rw_direction){1, 0};
    for (int k = 0; k < (is_line ? 1 : ACROSS); k++) {
        const double amplitude = resolve(m, p.across);
        if (may_component_be_worse(m, amplitude, peak)) {
            const verdict v = count(m, &p);
            note(m, &v);
        }
        p.across = rw_turned_by(p.across, ACROSS_STEP);
    }
}

static void look_at_grid(miner *m)
{
    plane p = {{1, 0}, {1, 0}, {1, 0}};
    for (int row = 0; row < UP; row++) {
        for (int k = 0; k < ACROSS_EQUATOR; k++) {
            const extent e = go_through(m, &p);
            if (may_be_worse(m, most_cycles(m) * damage_of(m, half_diagonal(&e), e.peak)))
                look_at_all_directions(m, p, e.peak);
            p.psi = rw_turned_by(p.psi, PSI_STEP);
        }
        p.beta = rw_turned_by(p.beta, BETA_STEP);
    }
}

/* ---- Steps from a plane ---- */

static bool step(miner *m, verdict *v, double psi, double beta, double across)
{
    const plane p = {rw_turned_by(v->at.psi, psi), rw_turned_by(v->at.beta, beta),
                     rw_turned_by(v->at.across, across)};
    go_through(m, &p);
    const verdict next = count(m, &p);
    if (next.damage <= v->damage)
        return false;
    *v = next;
    return true;
}

/* Steps of t along each coordinate, and along psi and beta together. */
static bool step_around(miner *m, verdict *v, double t)
{
    bool is_worse = false;
    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++)
            is_worse = ((i != 0 || j != 0) && step(m, v, i * t, j * t, 0)) || is_worse;
    for (int i = -1; i <= 1 && !m->severity.is_strain; i += 2)
        is_worse = step(m, v, 0, 0, i * t) || is_worse;
    return is_worse;
}

static void refine(miner *m, verdict *v, double from, double to)
{
    for (double t = from; t > to;)
        if (!step_around(m, v, t))
            t /= 2;
}

/* Planes that are far behind after a few steps are not refined further. */
static verdict worst_of_starts(miner *m)
{
    verdict best = m->best[0];
    for (int i = 0; i < STARTS && m->best[i].damage > HOPELESS * m->best[0].damage; i++) {
        refine(m, &m->best[i], BETA_STEP / 2, BETA_STEP / 8);
        best = m->best[i].damage > best.damage ? m->best[i] : best;
    }
    const double promising = BEHIND * best.damage;
    for (int i = 0; i < STARTS; i++) {
        if (m->best[i].damage > promising)
            refine(m, &m->best[i], BETA_STEP / 8, LAST);
        best = m->best[i].damage > best.damage ? m->best[i] : best;
    }
    return best;
}

/* ---- A point ---- */

static rw_direction direction_of(double x, double y)
{
    const double length = sqrt(x * x + y * y);
    return length > 0 ? (rw_direction){x / length, y / length} : (rw_direction){1, 0};
}

/* The length of the path: from the load farthest from the first one to the load farthest from
 * that. */
static rw_direction longest_way(const miner *m)
{
    size_t end[2] = {0, 0};
    for (int turn = 0; turn < 2; turn++) {
        const rw_vector from = m->path[end[1 - turn]];
        double most = -1;
        for (size_t i = 0; i < m->cycle->loads; i++) {
            const double x = m->path[i].x - from.x, y = m->path[i].y - from.y;
            if (x * x + y * y > most)
                most = x * x + y * y, end[turn] = i;
        }
    }
    return direction_of(m->path[end[1]].x - m->path[end[0]].x,
                        m->path[end[1]].y - m->path[end[0]].y);
}

/* The damage on the plane of the largest value of the criterion. */
static void look_at(miner *m, const rw_worst_plane *worst)
{
    plane p = {{cos(2 * worst->angle), sin(2 * worst->angle)},
               {cos(worst->out_of_plane), sin(worst->out_of_plane)},
               {1, 0}};
    go_through(m, &p);
    if (!m->severity.is_strain)
        p.across = longest_way(m);
    const verdict v = count(m, &p);
    note(m, &v);
}

static verdict exactly(miner *m, const plane *p)
{
    go_through(m, p);
    m->is_exact = true;
    const verdict v = count(m, p);
    m->is_exact = false;
    return v;
}

static verdict worst_of(miner *m, const rw_stress_field *f, size_t point)
{
    for (int i = 0; i < STARTS; i++)
        m->best[i] = (verdict){{{1, 0}, {1, 0}, {1, 0}}, 0, 0};
    m->unit = rw_field_scale(f, point);
    m->severity = rw_severity_in(m->criterion, m->unit);
    rw_set_loads(f, point, m->criterion, m->unit, m->cycle);
    const rw_worst_plane worst = rw_worst_plane_of(m->cycle, &m->severity);
    rw_set_loads(f, point, m->criterion, m->unit, m->cycle); /* their order counts */
    look_at(m, &worst);
    look_at_grid(m);
    const verdict best = worst_of_starts(m);
    return exactly(m, &best.at);
}

/* ---- A field ---- */

typedef struct {
    double *damage, *cycles, *angle, *out_of_plane;
} results;

static void free_miner(miner *m)
{
    rw_plane_cycle_destroy(m->cycle);
    free(m->table);
    free(m->path);
    free(m->along);
    free(m->other);
    free(m->stack);
    free(m->counted);
}

static bool take_room(miner *m, size_t loads)
{
    m->cycle = rw_plane_cycle_create(loads);
    m->table = malloc(sizeof *m->table);
    m->path = calloc(loads, sizeof *m->path);
    m->along = calloc(loads, sizeof *m->along);
    m->other = calloc(loads, sizeof *m->other);
    m->stack = calloc(loads + 1, sizeof *m->stack);
    m->counted = calloc(loads, sizeof *m->counted);
    return m->cycle && m->table && m->path && m->along && m->other && m->stack && m->counted;
}

static void give(const verdict *v, size_t n, const results *r)
{
    for (size_t j = 0; j < n; j++) {
        r->damage[j] = v[j].damage;
        r->cycles[j] = v[j].cycles;
        r->angle[j] = rw_plane_angle(v[j].at.psi.cosine, v[j].at.psi.sine);
        r->out_of_plane[j] = rw_angle(fabs(v[j].at.beta.cosine), fabs(v[j].at.beta.sine));
    }
}

static int32_t sum_up(const rw_stress_field *f, miner *m, const results *r)
{
    verdict *all = calloc(f->points + 1, sizeof *all);
    int32_t status = all && take_room(m, f->loads) ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        rw_life_table_begin(m->curve, m->table);
    for (size_t j = 0; j < f->points && status == RWEDGE_OK; j++) {
        all[j] = worst_of(m, f, j);
        status = m->leaves_domain ? RWEDGE_EDOMAIN : RWEDGE_OK;
    }
    if (status == RWEDGE_OK)
        give(all, f->points, r);
    free_miner(m);
    free(all);
    return status;
}

static int32_t damage(const rw_stress_field *f, bool in_domain, const rw_criterion *c,
                      const rw_life_curve *curve, const results *r)
{
    const int32_t status =
        rw_field_status(f, r->damage && r->cycles && r->angle && r->out_of_plane);
    miner m = {.criterion = c, .curve = curve};
    if (status != RWEDGE_OK)
        return status;
    return in_domain ? sum_up(f, &m, r) : RWEDGE_EDOMAIN;
}

int32_t rwedge_smith_watson_topper_damage_field(size_t loads, size_t n, const double sxx[],
                                                const double syy[], const double txy[], double E,
                                                double nu, int32_t plane_stress, double sf,
                                                double b, double ef, double c, double limit,
                                                double value[], double cycles[], double angle[],
                                                double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    rw_criterion criterion;
    rw_life_curve curve;
    const bool in_domain = rw_smith_watson_topper(E, nu, plane_stress, &criterion) &&
                           rw_smith_watson_topper_curve(E, sf, b, ef, c, limit, &curve);
    return damage(&f, in_domain, &criterion, &curve,
                  &(results){value, cycles, angle, out_of_plane});
}

int32_t rwedge_fatemi_socie_damage_field(size_t loads, size_t n, const double sxx[],
                                         const double syy[], const double txy[], double E,
                                         double nu, int32_t plane_stress, double k_over_sy,
                                         double G, double tf, double b, double gf, double c,
                                         double limit, double value[], double cycles[],
                                         double angle[], double out_of_plane[])
{
    const rw_stress_field f = {loads, n, sxx, syy, txy, nu};
    rw_criterion criterion;
    rw_life_curve curve;
    const bool in_domain = rw_fatemi_socie(E, nu, plane_stress, k_over_sy, &criterion) &&
                           rw_fatemi_socie_curve(G, tf, b, gf, c, limit, &curve);
    return damage(&f, in_domain, &criterion, &curve,
                  &(results){value, cycles, angle, out_of_plane});
}

int32_t rwedge_smith_watson_topper_damage(size_t n, const double sxx[], const double syy[],
                                          const double txy[], double E, double nu,
                                          int32_t plane_stress, double sf, double b, double ef,
                                          double c, double limit, double *value, double *cycles,
                                          double *angle, double *out_of_plane)
{
    return rwedge_smith_watson_topper_damage_field(n, 1, sxx, syy, txy, E, nu, plane_stress, sf, b,
                                                   ef, c, limit, value, cycles, angle,
                                                   out_of_plane);
}

int32_t rwedge_fatemi_socie_damage(size_t n, const double sxx[], const double syy[],
                                   const double txy[], double E, double nu, int32_t plane_stress,
                                   double k_over_sy, double G, double tf, double b, double gf,
                                   double c, double limit, double *value, double *cycles,
                                   double *angle, double *out_of_plane)
{
    return rwedge_fatemi_socie_damage_field(n, 1, sxx, syy, txy, E, nu, plane_stress, k_over_sy, G,
                                            tf, b, gf, c, limit, value, cycles, angle,
                                            out_of_plane);
}
