/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damage of a block of loads by Miner's sum, on the plane where it is largest. Damage is not smooth
 * over the planes: cycles pair up anew, and fall below a limit. So planes are taken from a grid,
 * and steps are made from the worst of them, smaller and smaller, to the LAST one.
 * The plane on which the criterion itself is largest is among them: for a block of one cycle it is
 * the plane that is sought. */
#include "life/miner.h"

#include "base/domain.h"
#include "measures/catalogue.h"

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

/* The worst planes so far. */
typedef struct {
    rw_miner_sum miner;
    rw_plane_damage best[STARTS]; /* falling */
} search;

/* ---- The worst planes ---- */

static double cosine_between(const rw_sheared_plane *a, const rw_sheared_plane *b)
{
    /* psi is twice the angle in the plane of x and y */
    const double twice = a->psi.cosine * b->psi.cosine + a->psi.sine * b->psi.sine;
    const double once = sqrt(rw_larger(0, (1 + twice) / 2));
    return fabs(a->beta.cosine * b->beta.cosine) * once + fabs(a->beta.sine * b->beta.sine);
}

/* Puts a plane into the list in place of a near one, or of the least, if it is worse. The list
 * stays in order. */
static void note(search *s, const rw_plane_damage *v)
{
    int place = STARTS - 1;
    for (int i = STARTS - 1; i >= 0; i--)
        if (s->best[i].damage > 0 && cosine_between(&s->best[i].at, &v->at) > APART)
            place = i;
    if (v->damage <= s->best[place].damage)
        return;
    for (; place > 0 && s->best[place - 1].damage < v->damage; place--)
        s->best[place] = s->best[place - 1];
    s->best[place] = *v;
}

static double hopeless(const search *s)
{
    return HOPELESS * s->best[0].damage;
}

static void look_at_all_directions(search *s, rw_sheared_plane p, double peak)
{
    const bool is_line = s->miner.severity.is_strain || p.beta.sine == 0;
    p.across = (rw_direction){1, 0};
    for (int k = 0; k < (is_line ? 1 : ACROSS); k++) {
        if (rw_miner_may_exceed(&s->miner, p.across, peak, hopeless(s))) {
            const rw_plane_damage v = rw_miner_count(&s->miner, &p);
            note(s, &v);
        }
        p.across = rw_turned_by(p.across, ACROSS_STEP);
    }
}

static void look_at_grid(search *s)
{
    rw_sheared_plane p = {{1, 0}, {1, 0}, {1, 0}};
    for (int row = 0; row < UP; row++) {
        for (int k = 0; k < ACROSS_EQUATOR; k++) {
            const rw_plane_bound bound = rw_miner_go_through(&s->miner, &p);
            if (rw_miner_most(&s->miner, bound) > hopeless(s))
                look_at_all_directions(s, p, bound.peak);
            p.psi = rw_turned_by(p.psi, PSI_STEP);
        }
        p.beta = rw_turned_by(p.beta, BETA_STEP);
    }
}

/* ---- Steps from a plane ---- */

/* The damage of a plane of which nothing is known. */
static rw_plane_damage damage_on(rw_miner_sum *m, const rw_sheared_plane *p)
{
    rw_miner_go_through(m, p);
    return rw_miner_count(m, p);
}

static bool step(rw_miner_sum *m, rw_plane_damage *v, double psi, double beta, double across)
{
    const rw_sheared_plane p = {rw_turned_by(v->at.psi, psi), rw_turned_by(v->at.beta, beta),
                                rw_turned_by(v->at.across, across)};
    const rw_plane_damage next = damage_on(m, &p);
    if (next.damage <= v->damage)
        return false;
    *v = next;
    return true;
}

/* Steps of t along each coordinate, and along psi and beta together. */
static bool step_around(rw_miner_sum *m, rw_plane_damage *v, double t)
{
    bool is_worse = false;
    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++)
            is_worse = ((i != 0 || j != 0) && step(m, v, i * t, j * t, 0)) || is_worse;
    for (int i = -1; i <= 1 && !m->severity.is_strain; i += 2)
        is_worse = step(m, v, 0, 0, i * t) || is_worse;
    return is_worse;
}

static void refine(rw_miner_sum *m, rw_plane_damage *v, double from, double to)
{
    for (double t = from; t > to;)
        if (!step_around(m, v, t))
            t /= 2;
}

/* Planes that are far behind after a few steps are not refined further. */
static rw_plane_damage worst_of_starts(search *s)
{
    rw_plane_damage best = s->best[0];
    for (int i = 0; i < STARTS && s->best[i].damage > hopeless(s); i++) {
        refine(&s->miner, &s->best[i], BETA_STEP / 2, BETA_STEP / 8);
        best = s->best[i].damage > best.damage ? s->best[i] : best;
    }
    const double promising = BEHIND * best.damage;
    for (int i = 0; i < STARTS; i++) {
        if (s->best[i].damage > promising)
            refine(&s->miner, &s->best[i], BETA_STEP / 8, LAST);
        best = s->best[i].damage > best.damage ? s->best[i] : best;
    }
    return best;
}

/* ---- A point ---- */

/* The damage on the plane of the largest value of the criterion. */
static void look_at(search *s, const rw_worst_plane *worst)
{
    rw_sheared_plane p = {{cos(2 * worst->angle), sin(2 * worst->angle)},
                          {cos(worst->out_of_plane), sin(worst->out_of_plane)},
                          {1, 0}};
    rw_miner_go_through(&s->miner, &p);
    if (!s->miner.severity.is_strain)
        p.across = rw_miner_longest_way(&s->miner);
    const rw_plane_damage v = rw_miner_count(&s->miner, &p);
    note(s, &v);
}

static rw_plane_damage exactly(rw_miner_sum *m, const rw_sheared_plane *p)
{
    m->is_exact = true;
    const rw_plane_damage v = damage_on(m, p);
    m->is_exact = false;
    return v;
}

static rw_plane_damage worst_of(rw_miner_sum *m, const rw_stress_field *f, size_t point)
{
    search s = {.miner = *m};
    for (int i = 0; i < STARTS; i++)
        s.best[i] = (rw_plane_damage){{{1, 0}, {1, 0}, {1, 0}}, 0, 0};
    const double unit = rw_field_scale(f, point);
    s.miner.unit = rw_value_in(m->criterion, unit);
    s.miner.severity = rw_severity_in(m->criterion, unit);
    rw_set_loads(f, point, m->criterion, unit, m->cycle);
    const rw_worst_plane worst = rw_worst_plane_of(m->cycle, &s.miner.severity);
    look_at(&s, &worst);
    look_at_grid(&s);
    const rw_plane_damage best = worst_of_starts(&s);
    const rw_plane_damage exact = exactly(&s.miner, &best.at);
    m->leaves_domain = s.miner.leaves_domain;
    return exact;
}

/* ---- A field ---- */

/* plane: the angle at each point, then out_of_plane at each. */
typedef struct {
    double *damage, *cycles, *plane;
} results;

static void give(const rw_plane_damage *v, size_t n, const results *r)
{
    for (size_t j = 0; j < n; j++) {
        r->damage[j] = v[j].damage;
        r->cycles[j] = v[j].cycles;
        r->plane[j] = rw_plane_angle(v[j].at.psi.cosine, v[j].at.psi.sine);
        r->plane[n + j] = rw_angle(fabs(v[j].at.beta.cosine), fabs(v[j].at.beta.sine));
    }
}

static int32_t sum_up(const rw_stress_field *f, rw_miner_sum *m, const results *r)
{
    rw_plane_damage *all = calloc(f->points + 1, sizeof *all);
    int32_t status = rw_miner_create(m, f->loads) && all ? RWEDGE_OK : RWEDGE_ENOMEM;
    for (size_t j = 0; j < f->points && status == RWEDGE_OK; j++) {
        all[j] = worst_of(m, f, j);
        status = m->leaves_domain ? RWEDGE_EDOMAIN : RWEDGE_OK;
    }
    if (status == RWEDGE_OK)
        give(all, f->points, r);
    rw_miner_destroy(m);
    free(all);
    return status;
}

int32_t rwedge_damage_field(int32_t criterion, const double constants[], size_t loads, size_t n,
                            const double sxx[], const double syy[], const double txy[], double nu,
                            int32_t plane_stress, double value[], double cycles[], double plane[])
{
    const rw_stress_field f = rw_stress_field_of(loads, n, sxx, syy, txy, nu, plane_stress);
    const int32_t status = rw_field_status(&f, constants && value && cycles && plane);
    rw_life_curve curve;
    if (status != RWEDGE_OK)
        return status;
    if (!rw_is_switch(plane_stress) || !rw_life_curve_of(criterion, constants, &curve))
        return RWEDGE_EDOMAIN;
    const rw_criterion of_planes = rw_measure_of(criterion)->of_planes(&f, constants);
    rw_miner_sum m = {.criterion = &of_planes, .curve = &curve};
    return sum_up(&f, &m, &(results){value, cycles, plane});
}

int32_t rwedge_damage(int32_t criterion, const double constants[], size_t n, const double sxx[],
                      const double syy[], const double txy[], double nu, int32_t plane_stress,
                      double *value, double *cycles, double plane[2])
{
    return rwedge_damage_field(criterion, constants, n, 1, sxx, syy, txy, nu, plane_stress, value,
                               cycles, plane);
}
