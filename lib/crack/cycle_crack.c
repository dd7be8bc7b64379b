/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses of a cycle on the line of a crack, weighted: K, and the openings of places. Where
 * faces would overlap, these tell how much; where they press, how hard. */
#include "crack/cycle_crack.h"

#include "base/processor.h"
#include "base/tuned.h"
#include "crack/weights.h"

#include <stdlib.h>

size_t rw_crack_loads(const rw_crack *crack)
{
    return crack->cycle->loads.count;
}

/* ---- The places whose opening is asked ---- */

/* Chooses, to look for an overlap, n parts of the line, from (i/n)^2 to ((i + 1)/n)^2, and the
 * place next to the middle of each. */
static void choose_parts(const rw_crack *crack, size_t at[])
{
    const size_t n = RW_OVERLAP_PARTS;
    size_t k = crack->m - 1;
    for (size_t i = 0; i < n; i++) {
        const double root = ((double)i + 0.5) / (double)n;
        while (k > 1 && crack->place[k] < root * root)
            k--;
        at[i] = k;
        crack->share[i] = (double)(2 * i + 1) / (double)(n * n);
    }
}

/* Faces press at all places but those that are next to the mouth: there places crowd, and what is
 * so near adds less to K than the rule errs by. */
static bool can_press(const rw_crack *crack, size_t k)
{
    return k < crack->m && crack->place[k] > RW_NEXT_TO_MOUTH;
}

/* Each has the line to the middle between it and the next, the outer ones to the tip and mouth. */
static void choose_all(const rw_crack *crack, size_t at[])
{
    double above = 1;
    for (size_t i = 0; i < crack->openings; i++) {
        const size_t k = i + 1;
        const bool is_last = i + 1 == crack->openings;
        const double below = is_last ? 0 : (crack->place[k] + crack->place[k + 1]) / 2;
        at[i] = k;
        crack->share[i] = above - below;
        above = below;
    }
}

/* What a pressure at the places does: it is a tension less. */
static int32_t copy_influence(rw_crack *crack, const size_t at[])
{
    const size_t n = crack->openings;
    for (size_t i = 0; i < 2 + n; i++)
        for (size_t k = 0; k < n; k++)
            crack->faces.influence[i * n + k] = crack->row[i * 2 * crack->m + at[k]];
    return rw_faces_invert(&crack->faces);
}

/* ---- A crack ---- */

/* The rows again, as columns, of which GROUP are added at once: that of the term k at [k stride].
 * Behind `used[k / GROUP]` of its rows the weights of a group are 0: a normal crack has half of
 * them. Columns and states have zeros at their end, to whole vectors. */
enum { GROUP = 8, VECTOR = 4 };

RW_INLINE size_t whole_vectors(size_t numbers)
{
    return (numbers + VECTOR - 1) / VECTOR * VECTOR;
}

RW_INLINE size_t stride_of(const rw_crack *crack)
{
    return whole_vectors(2 + crack->openings);
}

RW_INLINE size_t groups_of(const rw_crack *crack)
{
    return (2 * crack->m + GROUP - 1) / GROUP;
}

static int32_t write_columns(rw_crack *crack)
{
    const size_t terms = 2 * crack->m, rows = 2 + crack->openings, groups = groups_of(crack);
    const size_t stride = stride_of(crack);
    crack->column = calloc(groups * GROUP * stride, sizeof *crack->column);
    crack->used = calloc(groups, sizeof *crack->used);
    if (!crack->column || !crack->used)
        return RWEDGE_ENOMEM;
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < terms; k++) {
            const double weight = crack->row[i * terms + k];
            crack->column[k * stride + i] = weight;
            if (weight != 0)
                crack->used[k / GROUP] = whole_vectors(i + 1);
        }
    return RWEDGE_OK;
}

static int32_t write_rows(rw_crack *crack)
{
    const size_t n = crack->openings;
    size_t *at = malloc(n * sizeof *at);
    int32_t status = at ? RWEDGE_OK : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK && crack->presses)
        status = rw_faces_create(n, &crack->faces);
    if (status == RWEDGE_OK) {
        (crack->presses ? choose_all : choose_parts)(crack, at);
        status = rw_crack_rows(crack->angle, crack->m, n, at, crack->row);
    }
    if (status == RWEDGE_OK)
        status = write_columns(crack);
    if (status == RWEDGE_OK && crack->presses)
        status = copy_influence(crack, at);
    free(at);
    return status;
}

int32_t rw_crack_create(const rwedge_cycle *cycle, double x, double angle, bool presses,
                        rw_crack *crack)
{
    const size_t m = rwedge_crack_points(angle);
    *crack = (rw_crack){.cycle = cycle, .x = x, .angle = angle, .m = m, .presses = presses};
    crack->place = malloc(m * sizeof *crack->place);
    if (!crack->place)
        return RWEDGE_ENOMEM;
    rw_crack_places(m, crack->place);
    crack->openings = RW_OVERLAP_PARTS;
    if (presses)
        for (crack->openings = 0; can_press(crack, crack->openings + 1);)
            crack->openings++;
    crack->row = malloc(((2 + crack->openings) * 2 * m + crack->openings) * sizeof *crack->row);
    if (!crack->row)
        return RWEDGE_ENOMEM;
    crack->share = crack->row + (2 + crack->openings) * 2 * m;
    return write_rows(crack);
}

void rw_crack_destroy(rw_crack *crack)
{
    free(crack->place);
    free(crack->row);
    free(crack->column);
    free(crack->used);
    rw_faces_destroy(&crack->faces);
    *crack = (rw_crack){0};
}

/* ---- Stresses on the line ---- */

/* The lines of n lengths, one after the other: x and y of m places each, and the stresses that
 * follow, sxx of all loads first, then syy and txy. */
typedef struct {
    size_t n;
    double *x, *y, *stress;
} line_stresses;

static int32_t take_stresses(const rw_crack *crack, size_t n, const double length[],
                             line_stresses *line)
{
    const size_t m = crack->m, points = n * m;
    *line = (line_stresses){.n = n};
    line->x = malloc((2 + 3 * rw_crack_loads(crack)) * points * sizeof *line->x);
    if (!line->x)
        return RWEDGE_ENOMEM;
    line->y = line->x + points;
    line->stress = line->y + points;
    const double along_x = sin(crack->angle), along_y = cos(crack->angle);
    for (size_t i = 0; i < points; i++) {
        const double r = length[i / m] * crack->place[i % m];
        line->x[i] = crack->x + r * along_x;
        line->y[i] = fmax(r * along_y, RW_SMALLEST); /* a depth has that size */
    }
    return rw_cycle_stresses(crack->cycle, points, line->x, line->y, line->stress);
}

/* The stresses at m places: those across the line first, then those along it. */
RW_INLINE void resolve_all(size_t m, double c, double s, const double *restrict sxx,
                           const double *restrict syy, const double *restrict txy,
                           double *restrict resolved)
{
    for (size_t k = 0; k < m; k++) {
        resolved[k] = c * c * sxx[k] - 2 * c * s * txy[k] + s * s * syy[k];
        resolved[m + k] = c * s * (sxx[k] - syy[k]) + (c * c - s * s) * txy[k];
    }
}

RW_DISPATCH(resolve, resolve_all,
            (size_t m, double c, double s, const double sxx[], const double syy[],
             const double txy[], double resolved[]),
            (m, c, s, sxx, syy, txy, resolved))

/* Adds GROUP columns, each times its stress, to n sums, whole vectors. */
RW_INLINE void add_group(size_t n, size_t stride, const double *restrict column,
                         const double *restrict x, double *restrict sum)
{
    for (size_t i = 0; i < n; i += VECTOR)
        for (size_t l = i; l < i + VECTOR; l++) {
            double so_far = sum[l];
            for (size_t k = 0; k < GROUP; k++)
                so_far += column[k * stride + l] * x[k];
            sum[l] = so_far;
        }
}

RW_INLINE void add_all(const rw_crack *crack, size_t numbers, const double resolved[],
                       double state[])
{
    const size_t stride = stride_of(crack), groups = groups_of(crack);
    for (size_t i = 0; i < numbers; i++)
        state[i] = 0;
    for (size_t k = 0; k < groups; k++)
        add_group(numbers < crack->used[k] ? numbers : crack->used[k], stride,
                  crack->column + k * GROUP * stride, resolved + k * GROUP, state);
}

/* The first `numbers` of a free state, whole vectors. Behind the stresses there are GROUP zeros. */
RW_DISPATCH(write_state, add_all,
            (const rw_crack *crack, size_t numbers, const double resolved[], double state[]),
            (crack, numbers, resolved, state))

/* ---- K where faces pass through each other ---- */

static double overlap_of(const rw_crack *crack, const double state[])
{
    double share = 0;
    for (size_t i = 0; i < crack->openings; i++)
        if (state[2 + i] < 0)
            share += crack->share[i];
    return share;
}

static void pass_through(const rw_crack *crack, double root, const double states[], size_t j,
                         const rw_crack_K *K)
{
    for (size_t i = 0; i < rw_crack_loads(crack); i++) {
        const double *state = states + i * stride_of(crack);
        K->I[i * K->stride + j] = root * state[0];
        K->II[i * K->stride + j] = root * state[1];
        if (K->share)
            K->share[i * K->stride + j] = overlap_of(crack, state);
    }
}

/* ---- K where faces press ---- */

static double closed_share(const rw_crack *crack)
{
    double share = 0;
    for (size_t i = 0; i < crack->openings; i++)
        if (crack->faces.is_closed[i])
            share += crack->share[i];
    return fmin(share, 1);
}

static int32_t write_passings(rw_crack *crack, double root, const double states[], size_t j,
                              const rw_crack_K *K)
{
    const size_t loads = rw_crack_loads(crack), stride = stride_of(crack);
    for (size_t i = 0; i < loads; i++) {
        const size_t next = (i + 1) % loads;
        const bool is_open = K->I[i * K->stride + j] > 0, will_be = K->I[next * K->stride + j] > 0;
        double K_II = NAN;
        if (is_open != will_be) {
            const int32_t status =
                rw_faces_pass(&crack->faces, states + (is_open ? i : next) * stride,
                              states + (is_open ? next : i) * stride, &K_II);
            if (status != RWEDGE_OK)
                return status;
        }
        K->passing[i * K->stride + j] = root * K_II;
    }
    return RWEDGE_OK;
}

static int32_t press(rw_crack *crack, double root, const double states[], size_t j,
                     const rw_crack_K *K)
{
    for (size_t i = 0; i < rw_crack_loads(crack); i++) {
        double of_state[2];
        const int32_t status =
            rw_faces_press(&crack->faces, states + i * stride_of(crack), of_state);
        if (status != RWEDGE_OK)
            return status;
        K->I[i * K->stride + j] = root * fmax(of_state[0], 0);
        K->II[i * K->stride + j] = root * of_state[1];
        if (K->share)
            K->share[i * K->stride + j] = closed_share(crack);
    }
    return K->passing ? write_passings(crack, root, states, j, K) : RWEDGE_OK;
}

/* ---- K of lengths ---- */

static int32_t write_K(rw_crack *crack, const line_stresses *line, size_t n, const double length[],
                       const rw_crack_K *K)
{
    const size_t loads = rw_crack_loads(crack), stride = stride_of(crack), m = crack->m;
    const size_t asked = crack->presses || K->share ? stride : whole_vectors(2);
    const size_t all = loads * line->n * m;
    const double along_x = sin(crack->angle), along_y = cos(crack->angle);
    double *states = calloc(loads * stride + 2 * m + GROUP, sizeof *states);
    if (!states)
        return RWEDGE_ENOMEM;
    double *resolved = states + loads * stride;
    int32_t status = RWEDGE_OK;
    for (size_t j = 0; j < n && status == RWEDGE_OK; j++) {
        for (size_t i = 0; i < loads; i++) {
            const double *sxx = line->stress + (i * line->n + j) * m;
            resolve(m, along_y, along_x, sxx, sxx + all, sxx + 2 * all, resolved);
            write_state(crack, asked, resolved, states + i * stride);
        }
        if (crack->presses)
            status = press(crack, sqrt(length[j]), states, j, K);
        else
            pass_through(crack, sqrt(length[j]), states, j, K);
    }
    free(states);
    return status;
}

int32_t rw_crack_intensities(rw_crack *crack, size_t n, const double length[], const rw_crack_K *K)
{
    line_stresses line;
    int32_t status = take_stresses(crack, n, length, &line);
    if (status == RWEDGE_OK)
        status = write_K(crack, &line, n, length, K);
    free(line.x);
    return status;
}

/* ---- The public call ---- */

bool rw_are_crack_lengths(size_t n, const double length[])
{
    for (size_t j = 0; j < n; j++)
        if (!rw_is_positive(length[j]))
            return false;
    return true;
}

/* The lengths in groups, so that the stresses of a group fit in memory; 3 loads n results. */
static int32_t ask(rw_crack *crack, size_t n, const double length[], double result[])
{
    const size_t all = rw_crack_loads(crack) * n;
    int32_t status = RWEDGE_OK;
    for (size_t j = 0; j < n && status == RWEDGE_OK; j += RW_CRACK_LENGTHS) {
        const size_t group = n - j < RW_CRACK_LENGTHS ? n - j : RW_CRACK_LENGTHS;
        const rw_crack_K K = {n, result + j, result + all + j, result + 2 * all + j, NULL};
        status = rw_crack_intensities(crack, group, length + j, &K);
    }
    return status;
}

static int32_t answer(rw_crack *crack, size_t n, const double length[], double *const to[3])
{
    const size_t all = rw_crack_loads(crack) * n;
    double *result = malloc((3 * all + 1) * sizeof *result);
    const int32_t status = result ? ask(crack, n, length, result) : RWEDGE_ENOMEM;
    for (size_t i = 0; i < 3 && status == RWEDGE_OK; i++)
        for (size_t j = 0; j < all; j++)
            to[i][j] = result[i * all + j];
    free(result);
    return status;
}

static int32_t intensities(const rwedge_cycle *cycle, double x, double angle, size_t loads,
                           size_t n, const double length[], bool presses, double *const to[3])
{
    if (!cycle || (n > 0 && (!length || !to[0] || !to[1] || !to[2])))
        return RWEDGE_ENULL;
    if (loads != cycle->loads.count || n > SIZE_MAX / 4 / sizeof(double) / loads)
        return RWEDGE_ERANGE;
    if (!rw_is_signed(x) || !rw_is_crack_angle(angle) || !rw_are_crack_lengths(n, length))
        return RWEDGE_EDOMAIN;
    rw_crack crack;
    int32_t status = rw_crack_create(cycle, x, angle, presses, &crack);
    if (status == RWEDGE_OK)
        status = answer(&crack, n, length, to);
    rw_crack_destroy(&crack);
    return status;
}

int32_t rwedge_cycle_crack(const rwedge_cycle *cycle, double x, double angle, size_t loads,
                           size_t n, const double length[], double K_I[], double K_II[],
                           double overlap[])
{
    double *const to[] = {K_I, K_II, overlap};
    return intensities(cycle, x, angle, loads, n, length, false, to);
}

int32_t rwedge_cycle_closing_crack(const rwedge_cycle *cycle, double x, double angle, size_t loads,
                                   size_t n, const double length[], double K_I[], double K_II[],
                                   double closed[])
{
    double *const to[] = {K_I, K_II, closed};
    return intensities(cycle, x, angle, loads, n, length, true, to);
}
