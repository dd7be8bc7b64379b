/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses of a cycle on the line of a crack, weighted. The openings of places that are denser
 * towards the mouth tell where faces would overlap. */
#include "crack/cycle_crack.h"

#include "base/linear.h"
#include "crack/weights.h"

#include <stdlib.h>

enum { OPENINGS = 16 };

size_t rw_crack_loads(const rw_crack *crack)
{
    return crack->cycle->loads.count;
}

/* The line has parts from (i/16)^2 to ((i + 1)/16)^2; the place next to the middle of each. */
static void choose_openings(const rw_crack *crack, size_t at[])
{
    size_t k = crack->m - 1;
    for (size_t i = 0; i < OPENINGS; i++) {
        const double root = ((double)i + 0.5) / OPENINGS;
        while (k > 1 && crack->place[k] < root * root)
            k--;
        at[i] = k;
    }
}

int32_t rw_crack_create(const rwedge_cycle *cycle, double x, double angle, rw_crack *crack)
{
    *crack = (rw_crack){.cycle = cycle, .x = x, .angle = angle, .m = rwedge_crack_points(angle)};
    crack->place = malloc((1 + 2 * (2 + OPENINGS)) * crack->m * sizeof *crack->place);
    if (!crack->place)
        return RWEDGE_ENOMEM;
    crack->row = crack->place + crack->m;
    rw_crack_places(crack->m, crack->place);
    size_t at[OPENINGS];
    choose_openings(crack, at);
    return rw_crack_rows(angle, crack->m, OPENINGS, at, crack->row);
}

void rw_crack_destroy(rw_crack *crack)
{
    free(crack->place);
    crack->place = NULL;
}

/* ---- Stresses on the line ---- */

/* Of n lengths, one after the other: x and y of m places each, and the stresses that follow,
 * sxx of all loads first, then syy and txy. */
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
    for (size_t i = 0; i < points; i++) {
        const double r = length[i / m] * crack->place[i % m];
        line->x[i] = crack->x + r * sin(crack->angle);
        line->y[i] = fmax(r * cos(crack->angle), RW_SMALLEST); /* a depth has that size */
    }
    return rw_cycle_stresses(crack->cycle, points, line->x, line->y, line->stress);
}

/* Of the length j, at m places: those across the line first, then those along it. */
static void resolve(const rw_crack *crack, const line_stresses *line, size_t load, size_t j,
                    double resolved[])
{
    const size_t points = line->n * crack->m, all = rw_crack_loads(crack) * points;
    const double *sxx = line->stress + load * points + j * crack->m, *syy = sxx + all,
                 *txy = syy + all;
    const double c = cos(crack->angle), s = sin(crack->angle);
    for (size_t k = 0; k < crack->m; k++) {
        resolved[k] = c * c * sxx[k] - 2 * c * s * txy[k] + s * s * syy[k];
        resolved[crack->m + k] = c * s * (sxx[k] - syy[k]) + (c * c - s * s) * txy[k];
    }
}

static double weighted(const rw_crack *crack, size_t row, const double resolved[])
{
    return rw_dot(2 * crack->m, crack->row + 2 * row * crack->m, resolved);
}

static double overlap_of(const rw_crack *crack, const double resolved[])
{
    double share = 0;
    for (size_t i = 0; i < OPENINGS; i++)
        if (weighted(crack, 2 + i, resolved) < 0)
            share += (double)(2 * i + 1) / (OPENINGS * OPENINGS);
    return share;
}

int32_t rw_crack_intensities(const rw_crack *crack, size_t n, const double length[], size_t stride,
                             double K_I[], double K_II[], double overlap[])
{
    line_stresses line;
    double *resolved = malloc(2 * crack->m * sizeof *resolved);
    int32_t status = take_stresses(crack, n, length, &line);
    status = resolved ? status : RWEDGE_ENOMEM;
    for (size_t i = 0; i < rw_crack_loads(crack) && status == RWEDGE_OK; i++)
        for (size_t j = 0; j < n; j++) {
            resolve(crack, &line, i, j, resolved);
            const size_t at = i * stride + j;
            K_I[at] = sqrt(length[j]) * weighted(crack, 0, resolved);
            K_II[at] = sqrt(length[j]) * weighted(crack, 1, resolved);
            if (overlap)
                overlap[at] = overlap_of(crack, resolved);
        }
    free(line.x);
    free(resolved);
    return status;
}

/* ---- The public call ---- */

static bool are_lengths(size_t n, const double length[])
{
    for (size_t j = 0; j < n; j++)
        if (!rw_is_positive(length[j]))
            return false;
    return true;
}

/* The lengths in groups, so that the stresses of a group fit in memory; 3 loads n results. */
static int32_t ask(const rw_crack *crack, size_t n, const double length[], double result[])
{
    const size_t all = rw_crack_loads(crack) * n;
    int32_t status = RWEDGE_OK;
    for (size_t j = 0; j < n && status == RWEDGE_OK; j += RW_CRACK_LENGTHS) {
        const size_t group = n - j < RW_CRACK_LENGTHS ? n - j : RW_CRACK_LENGTHS;
        status = rw_crack_intensities(crack, group, length + j, n, result + j, result + all + j,
                                      result + 2 * all + j);
    }
    return status;
}

static int32_t answer(const rw_crack *crack, size_t n, const double length[], double K_I[],
                      double K_II[], double overlap[])
{
    const size_t all = rw_crack_loads(crack) * n;
    double *result = malloc((3 * all + 1) * sizeof *result), *const to[] = {K_I, K_II, overlap};
    const int32_t status = result ? ask(crack, n, length, result) : RWEDGE_ENOMEM;
    for (size_t i = 0; i < 3 && status == RWEDGE_OK; i++)
        for (size_t j = 0; j < all; j++)
            to[i][j] = result[i * all + j];
    free(result);
    return status;
}

int32_t rwedge_cycle_crack(const rwedge_cycle *cycle, double x, double angle, size_t loads,
                           size_t n, const double length[], double K_I[], double K_II[],
                           double overlap[])
{
    if (!cycle || !length || !K_I || !K_II || !overlap)
        return RWEDGE_ENULL;
    if (!rw_is_signed(x) || !rw_is_crack_angle(angle) || !are_lengths(n, length))
        return RWEDGE_EDOMAIN;
    if (loads != cycle->loads.count || n > SIZE_MAX / 4 / sizeof(double) / loads)
        return RWEDGE_ERANGE;
    rw_crack crack;
    int32_t status = rw_crack_create(cycle, x, angle, &crack);
    if (status == RWEDGE_OK)
        status = answer(&crack, n, length, K_I, K_II, overlap);
    rw_crack_destroy(&crack);
    return status;
}
