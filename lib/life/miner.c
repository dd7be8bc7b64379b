/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "life/miner.h"

#include "base/domain.h"

#include <float.h>
#include <stdlib.h>

/* A part of the largest range of a component: for the bound, cycles above it are as bad as the
 * worst one, others as bad as a cycle of this range. */
static const double LARGE = 0.7;

/* Cycles this small, relative to the largest, are rounding and are not counted. */
static const double ROUNDING = 1e-9;

/* On a plane through z, loads that differ by their mean stress alone have the same shear. A hair
 * beside the plane their shears differ, and other cycles close; on its other side, others again.
 * HAIR is how far they are moved apart, relative to the amplitude. A sum beside the plane counts if
 * it is larger by JUMP: less is the HAIR itself. sin(beta) of a plane THROUGH_Z is not larger. */
static const double HAIR = 1e-11, JUMP = 1e-8, THROUGH_Z = 1e-9;

bool rw_miner_create(rw_miner_sum *m, size_t loads)
{
    m->cycle = rw_plane_cycle_create(loads);
    m->table = malloc(sizeof *m->table);
    m->path = calloc(loads, sizeof *m->path);
    m->along = calloc(loads, sizeof *m->along);
    m->other = calloc(loads, sizeof *m->other);
    m->stack = calloc(loads + 1, sizeof *m->stack);
    m->counted = calloc(loads, sizeof *m->counted);
    if (m->table)
        rw_life_table_begin(m->curve, m->table);
    return m->cycle && m->table && m->path && m->along && m->other && m->stack && m->counted;
}

void rw_miner_destroy(rw_miner_sum *m)
{
    rw_plane_cycle_destroy(m->cycle);
    free(m->table);
    free(m->path);
    free(m->along);
    free(m->other);
    free(m->stack);
    free(m->counted);
}

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

rw_plane_bound rw_miner_go_through(rw_miner_sum *m, const rw_sheared_plane *p)
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
    return (rw_plane_bound){half_diagonal(&e), e.peak};
}

/* The damage of one cycle, given its amplitude and its largest normal stress. */
static double damage_of(rw_miner_sum *m, double amplitude, double peak)
{
    const double value = m->unit * rw_severity_of(&m->severity, amplitude, peak);
    if (value < RW_SMALLEST)
        return 0;
    const double life = m->is_exact ? rw_life(m->curve, value) : rw_life_by_table(m->table, value);
    m->leaves_domain = m->leaves_domain || isnan(life);
    return isnan(life) ? 0 : 1 / life;
}

static double most_cycles(const rw_miner_sum *m)
{
    return (double)(m->cycle->loads / 2);
}

/* The half range of the path in a direction. */
static double resolve(rw_miner_sum *m, rw_direction across)
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
static double larger_cycles(const rw_miner_sum *m, double range)
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

double rw_miner_most(rw_miner_sum *m, rw_plane_bound bound)
{
    return most_cycles(m) * damage_of(m, bound.amplitude, bound.peak);
}

bool rw_miner_may_exceed(rw_miner_sum *m, rw_direction across, double peak, double damage)
{
    const double amplitude = resolve(m, across);
    const double many = most_cycles(m), worst = damage_of(m, amplitude, peak);
    if (!(many * worst > damage))
        return false;
    const double large = larger_cycles(m, 2 * LARGE * amplitude);
    return large * worst + rw_larger(0, many - large) * damage_of(m, LARGE * amplitude, peak) >
           damage;
}

/* The damage of the component that has been resolved. */
static rw_plane_damage sum_of(rw_miner_sum *m, const rw_sheared_plane *p)
{
    const size_t cycles =
        rw_rainflow(m->cycle->loads, m->along, m->other, true, m->stack, m->counted);
    rw_plane_damage v = {*p, 0, 0};
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

/* What a turn of the plane and of its direction towards z adds to the shear, to a factor. */
static double lift_of(const rw_miner_sum *m, size_t i)
{
    return m->cycle->item[i].z - m->other[i];
}

/* The damage a hair beside a plane through z, on this side of it: 1 or -1. */
static rw_plane_damage sum_beside(rw_miner_sum *m, const rw_sheared_plane *p, double side)
{
    const double amplitude = resolve(m, p->across);
    double most = 0;
    for (size_t i = 0; i < m->cycle->loads; i++)
        most = rw_larger(most, fabs(lift_of(m, i)));
    for (size_t i = 0; i < m->cycle->loads && most > 0; i++)
        m->along[i] += side * HAIR * amplitude * (lift_of(m, i) / most);
    return sum_of(m, p);
}

rw_plane_damage rw_miner_count(rw_miner_sum *m, const rw_sheared_plane *p)
{
    resolve(m, p->across);
    rw_plane_damage v = sum_of(m, p);
    if (m->severity.is_strain || fabs(p->beta.sine) > THROUGH_Z)
        return v;
    for (int side = -1; side <= 1; side += 2) {
        const rw_plane_damage beside = sum_beside(m, p, side);
        v = beside.damage > (1 + JUMP) * v.damage ? beside : v;
    }
    return v;
}

static rw_direction direction_of(double x, double y)
{
    const double length = sqrt(x * x + y * y);
    return length > 0 ? (rw_direction){x / length, y / length} : (rw_direction){1, 0};
}

rw_direction rw_miner_longest_way(const rw_miner_sum *m)
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
