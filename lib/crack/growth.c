/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Does a crack grow from one length to another, and how long does it take? It is looked at in equal
 * steps of ln l; where it stops or breaks is bisected, dips of the range are searched. The life is
 * an integral over ln l by Gauss's rule, whose panels are halved where it has not settled. */
#include "crack/cycle_ranges.h"
#include "crack/weights.h"

#include "base/root.h"
#include "base/tuned.h"

#include <stdlib.h>
#include <string.h>

/* What the material says. */
typedef struct {
    double dK_th, ds0, C, m, K_c;
} growth_law;

/* A crack of one length: is it beyond the threshold, and below K_c? */
typedef struct {
    double dK, K_max, threshold;
} driving_force;

typedef struct {
    rw_crack *crack;
    const growth_law *law;
    int32_t shear;
    int32_t status;
} question;

static void forces_at(question *q, size_t n, const double length[], driving_force force[])
{
    rw_crack_range range[RW_CRACK_LENGTHS];
    if (q->status == RWEDGE_OK)
        q->status = rw_cycle_ranges(q->crack, q->shear, n, length, range);
    for (size_t j = 0; j < n; j++) {
        force[j] = (driving_force){0};
        if (q->status != RWEDGE_OK)
            continue;
        force[j].dK = hypot(range[j].I, range[j].II);
        force[j].K_max = range[j].K_max;
        force[j].threshold = rwedge_short_crack_threshold(length[j], q->law->dK_th, q->law->ds0);
    }
}

static driving_force force_at(question *q, double length)
{
    driving_force force;
    forces_at(q, 1, &length, &force);
    return force;
}

static bool goes_on(const question *q, const driving_force *force)
{
    return force->dK > force->threshold && force->K_max < q->law->K_c;
}

static double ratio_of(const driving_force *force)
{
    if (force->dK == 0)
        return 0;
    return force->threshold > 0 ? force->dK / force->threshold : HUGE_VAL;
}

/* ---- The way in steps ---- */

enum { MOST_STEPS = 4096 };

typedef struct {
    double length;
    driving_force force;
} station;

typedef struct {
    size_t count;
    station *stations;
} way;

/* Equal steps of ln l, and room for a dip next to each. */
static int32_t walk(question *q, double initial, double final, way *all)
{
    const double octaves = log(final / initial) / log(2);
    const size_t steps = (size_t)fmin(ceil(octaves * RW_CRACK_STEPS), MOST_STEPS);
    all->count = steps + 1;
    all->stations = calloc(2 * all->count, sizeof *all->stations);
    if (!all->stations)
        return RWEDGE_ENOMEM;
    for (size_t i = 0; i < all->count; i += RW_CRACK_LENGTHS) {
        const size_t rest = all->count - i, n = rest < RW_CRACK_LENGTHS ? rest : RW_CRACK_LENGTHS;
        double length[RW_CRACK_LENGTHS];
        driving_force force[RW_CRACK_LENGTHS];
        for (size_t j = 0; j < n; j++) {
            const double share = (double)(i + j) / (double)steps;
            length[j] = i + j == steps ? final : initial * exp(share * log(final / initial));
        }
        forces_at(q, n, length, force);
        for (size_t j = 0; j < n; j++)
            all->stations[i + j] = (station){length[j], force[j]};
    }
    return q->status;
}

/* The smallest ratio between two stations of which it is larger than of one between them, by golden
 * section of ln l. */
static station search_dip(question *q, double low, double high, station best)
{
    static const double SHORTER = 0.381966011250105;
    enum { STEPS = 44 }; /* to 1e-10 of a step */
    for (int i = 0; i < STEPS; i++) {
        const bool above = high / best.length > best.length / low;
        const double end = above ? high : low;
        const double length = best.length * exp(SHORTER * log(end / best.length));
        const station other = {length, force_at(q, length)};
        const bool is_better = ratio_of(&other.force) < ratio_of(&best.force);
        *(above == is_better ? &low : &high) = is_better ? best.length : length;
        best = is_better ? other : best;
    }
    return best;
}

static bool is_dip(const way *all, size_t i)
{
    if (i == 0 || i + 1 == all->count)
        return false;
    const double here = ratio_of(&all->stations[i].force);
    return here > 0 && here < HUGE_VAL && here < ratio_of(&all->stations[i - 1].force) &&
           here < ratio_of(&all->stations[i + 1].force);
}

/* What lies between two stations too. Stations are moved from the last on, because there is twice
 * the room. */
static void add_dips(question *q, way *all)
{
    const size_t count = all->count;
    station *to = all->stations + 2 * count, *last = to;
    for (size_t i = count; i-- > 0;) {
        const station here = all->stations[i];
        if (!is_dip(all, i)) {
            *--to = here;
            continue;
        }
        const station dip =
            search_dip(q, all->stations[i - 1].length, all->stations[i + 1].length, here);
        *--to = dip.length > here.length ? dip : here;
        if (dip.length != here.length)
            *--to = dip.length > here.length ? here : dip;
    }
    all->count = (size_t)(last - to);
    memmove(all->stations, to, all->count * sizeof *to);
}

/* ---- Where it ends ---- */

typedef struct {
    double length; /* HUGE_VAL where it reaches the last station */
    bool stops;    /* there; else it breaks */
} ending;

static ending ending_between(question *q, station before, station after)
{
    enum { HALVINGS = 44 }; /* to 1e-14 */
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = sqrt(before.length) * sqrt(after.length);
        const station between = {middle, force_at(q, middle)};
        *(goes_on(q, &between.force) ? &before : &after) = between;
    }
    return (ending){after.length, after.force.K_max < q->law->K_c};
}

static ending ending_of(question *q, const way *all)
{
    for (size_t i = 0; i < all->count; i++)
        if (!goes_on(q, &all->stations[i].force))
            return i > 0 ? ending_between(q, all->stations[i - 1], all->stations[i])
                         : (ending){all->stations[0].length,
                                    all->stations[0].force.K_max < q->law->K_c};
    return (ending){HUGE_VAL, false};
}

static station smallest_of(const way *all)
{
    station smallest = all->stations[0];
    for (size_t i = 1; i < all->count; i++)
        if (ratio_of(&all->stations[i].force) < ratio_of(&smallest.force))
            smallest = all->stations[i];
    return smallest;
}

/* ---- The life ---- */

/* The cycles that a length takes, over it: 1/(C (dK^m - dK_th^m)). */
static double slowness(const question *q, const driving_force *force)
{
    const growth_law *law = q->law;
    const double share = force->threshold > 0 ? force->threshold / force->dK : 0;
    const double rest = share > 0 ? -expm1(law->m * log(share)) : 1;
    const double rate = law->C * pow(force->dK, law->m) * rest;
    return rate > 0 ? 1 / rate : HUGE_VAL;
}

/* The cycles from one ln l to another. */
static double panel(question *q, double low, double high)
{
    double node[RW_CRACK_LENGTHS], weight[RW_CRACK_LENGTHS], sum = 0;
    driving_force force[RW_CRACK_LENGTHS];
    rw_gauss(RW_CRACK_LENGTHS, node, weight);
    for (size_t i = 0; i < RW_CRACK_LENGTHS; i++)
        node[i] = exp(low + (high - low) * node[i]);
    forces_at(q, RW_CRACK_LENGTHS, node, force);
    for (size_t i = 0; i < RW_CRACK_LENGTHS && q->status == RWEDGE_OK; i++)
        sum += weight[i] * node[i] * slowness(q, &force[i]);
    return (high - low) * sum;
}

/* The panel that was found, or both halves, until they differ by less than `within`. */
static double settled(question *q, double low, double high, double whole, double within, int depth)
{
    enum { DEEPEST = 30 };
    const double middle = low + (high - low) / 2;
    const double first = panel(q, low, middle), second = panel(q, middle, high);
    if (!(fabs(first + second - whole) > within) || depth == DEEPEST || q->status != RWEDGE_OK)
        return first + second;
    return settled(q, low, middle, first, within, depth + 1) +
           settled(q, middle, high, second, within, depth + 1);
}

static double life(question *q, double initial, double final)
{
    static const double SETTLED = 1e-8;
    const double within = q->crack->presses ? RW_CLOSING_LIFE_ERROR : SETTLED;
    enum { MOST_PANELS = 64 }; /* to begin with: two an octave, as far as that goes */
    const double octaves = log(final / initial) / log(2);
    const int panels = (int)fmin(fmax(ceil(2 * octaves), 1), MOST_PANELS);
    double whole[MOST_PANELS], all = 0, sum = 0;
    const double low = log(initial), step = (log(final) - low) / panels;
    for (int i = 0; i < panels; i++)
        all += whole[i] = panel(q, low + i * step, low + (i + 1) * step);
    for (int i = 0; i < panels && isfinite(all); i++)
        sum += settled(q, low + i * step, low + (i + 1) * step, whole[i], within * all, 0);
    return isfinite(all) && sum <= RW_LARGEST ? sum : HUGE_VAL;
}

/* ---- The public call ---- */

typedef struct {
    double arrest, cycles, least, least_at;
} growth;

static growth follow(question *q, way *all, double initial, double final)
{
    add_dips(q, all);
    const station smallest = smallest_of(all);
    const ending end = ending_of(q, all);
    return (growth){
        end.length,
        end.stops ? HUGE_VAL : life(q, initial, fmin(end.length, final)),
        ratio_of(&smallest.force),
        smallest.length,
    };
}

static int32_t find(question *q, double initial, double final, growth *found)
{
    way all = {0};
    int32_t status = walk(q, initial, final, &all);
    if (status == RWEDGE_OK) {
        *found = follow(q, &all, initial, final);
        status = q->status;
    }
    free(all.stations);
    return status;
}

enum { CONSTANTS = 5 };

static bool is_law(const double law[])
{
    const growth_law l = {law[0], law[1], law[2], law[3], law[4]};
    return rw_is_magnitude(l.dK_th) && (l.ds0 == HUGE_VAL || rw_is_positive(l.ds0)) &&
           rw_is_positive(l.C) && isgreaterequal(l.m, 0.1) && islessequal(l.m, 100) &&
           (l.K_c == HUGE_VAL || rw_is_positive(l.K_c));
}

/* What the call asks of a crack. */
typedef struct {
    const rwedge_cycle *cycle;
    double x, angle;
    bool presses;
    int32_t shear;
    const double *law;
    double initial, final;
} asked;

static int32_t check(const asked *a, size_t constants, double *const to[4])
{
    if (!a->cycle || !a->law || !to[0] || !to[1] || !to[2] || !to[3])
        return RWEDGE_ENULL;
    if (constants != CONSTANTS)
        return RWEDGE_ERANGE;
    if (!rw_is_signed(a->x) || !rw_is_crack_angle(a->angle) || !rw_is_crack_shear(a->shear) ||
        !is_law(a->law) || !rw_is_positive(a->initial) || !rw_is_positive(a->final) ||
        a->initial >= a->final)
        return RWEDGE_EDOMAIN;
    return RWEDGE_OK;
}

static int32_t answer(const asked *a, double *const to[4])
{
    const growth_law law = {a->law[0], a->law[1], a->law[2], a->law[3], a->law[4]};
    rw_crack crack;
    growth found;
    int32_t status = rw_crack_create(a->cycle, a->x, a->angle, a->presses, &crack);
    question q = {.crack = &crack, .law = &law, .shear = a->shear};
    if (status == RWEDGE_OK)
        status = find(&q, a->initial, a->final, &found);
    rw_crack_destroy(&crack);
    if (status == RWEDGE_OK) {
        *to[0] = found.arrest;
        *to[1] = found.cycles;
        *to[2] = found.least;
        *to[3] = found.least_at;
    }
    return status;
}

int32_t rwedge_cycle_growth(const rwedge_cycle *cycle, double x, double angle, int32_t shear,
                            size_t constants, const double law[], double initial, double final,
                            double *arrest, double *cycles, double *least, double *least_at)
{
    const asked a = {cycle, x, angle, false, shear, law, initial, final};
    double *const to[] = {arrest, cycles, least, least_at};
    const int32_t status = check(&a, constants, to);
    return status == RWEDGE_OK ? answer(&a, to) : status;
}

int32_t rwedge_cycle_closing_growth(const rwedge_cycle *cycle, double x, double angle,
                                    int32_t shear, size_t constants, const double law[],
                                    double initial, double final, double *arrest, double *cycles,
                                    double *least, double *least_at)
{
    const asked a = {cycle, x, angle, true, shear, law, initial, final};
    double *const to[] = {arrest, cycles, least, least_at};
    const int32_t status = check(&a, constants, to);
    return status == RWEDGE_OK ? answer(&a, to) : status;
}
