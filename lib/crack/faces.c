/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A linear complementarity problem: openings d = free + O q >= 0, pressures q >= 0, q d = 0. The
 * closed places are guessed from the free openings; then all places that are wrong change at once
 * until none is. Where that does not end, the first wrong place changes alone: the energy makes O
 * a matrix of which every part is positive, for which that always ends. */
#include "crack/faces.h"

#include "base/domain.h"
#include "base/linear.h"

#include <rwedge.h>
#include <stdlib.h>

int32_t rw_faces_create(size_t n, rw_faces *faces)
{
    const size_t numbers = (2 + n) * n + 2 * n * n + 6 * n;
    *faces = (rw_faces){.n = n};
    faces->influence = malloc(numbers * sizeof *faces->influence);
    faces->at = malloc(n * sizeof *faces->at);
    faces->is_closed = calloc(n, sizeof *faces->is_closed);
    if (!faces->influence || !faces->at || !faces->is_closed)
        return RWEDGE_ENOMEM;
    faces->inverse = faces->influence + (2 + n) * n;
    faces->A = faces->inverse + n * n;
    faces->b = faces->A + n * n;
    faces->pressure = faces->b + 2 * n;
    faces->opening = faces->pressure + n;
    faces->all_shut = faces->opening + n;
    return RWEDGE_OK;
}

void rw_faces_destroy(rw_faces *faces)
{
    free(faces->influence);
    free(faces->at);
    free(faces->is_closed);
    *faces = (rw_faces){0};
}

static const double *row_of_opening(const rw_faces *faces, size_t k)
{
    return faces->influence + (2 + k) * faces->n;
}

int32_t rw_faces_invert(rw_faces *faces)
{
    const size_t n = faces->n;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            faces->A[i * n + k] = row_of_opening(faces, i)[k];
            faces->inverse[i * n + k] = i == k;
        }
    return rw_solve(n, n, faces->A, faces->inverse) ? RWEDGE_OK : RWEDGE_ENOCONV;
}

/* ---- Given which places are closed ---- */

static size_t list(const rw_faces *faces, bool closed)
{
    size_t count = 0;
    for (size_t k = 0; k < faces->n; k++)
        if (faces->is_closed[k] == closed)
            faces->at[count++] = k;
    return count;
}

/* The unknowns of the places `at` from their rows of a matrix; b is the right-hand side. */
static bool solve(rw_faces *faces, size_t count, const double matrix[])
{
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < count; j++)
            faces->A[i * count + j] = matrix[faces->at[i] * faces->n + faces->at[j]];
    return count == 0 || rw_solve(count, 1, faces->A, faces->b);
}

static void spread(const rw_faces *faces, size_t count, double to[])
{
    for (size_t k = 0; k < faces->n; k++)
        to[k] = 0;
    for (size_t i = 0; i < count; i++)
        to[faces->at[i]] = faces->b[i];
}

/* Few closed places: their pressures are the unknowns, openings follow. */
static bool shut_closed(rw_faces *faces, const double free[])
{
    const size_t count = list(faces, true);
    for (size_t i = 0; i < count; i++)
        faces->b[i] = -free[2 + faces->at[i]];
    if (!solve(faces, count, faces->influence + 2 * faces->n))
        return false;
    spread(faces, count, faces->pressure);
    for (size_t k = 0; k < faces->n; k++)
        faces->opening[k] =
            faces->is_closed[k]
                ? 0
                : free[2 + k] + rw_dot(faces->n, row_of_opening(faces, k), faces->pressure);
    return true;
}

/* Few open places: their openings are the unknowns, against the pressures that shut all. */
static bool release_open(rw_faces *faces, const double free[])
{
    const size_t n = faces->n, count = list(faces, false);
    for (size_t k = 0; k < n; k++)
        faces->all_shut[k] = -rw_dot(n, faces->inverse + k * n, free + 2);
    for (size_t i = 0; i < count; i++)
        faces->b[i] = -faces->all_shut[faces->at[i]];
    if (!solve(faces, count, faces->inverse))
        return false;
    spread(faces, count, faces->opening);
    for (size_t k = 0; k < n; k++)
        faces->pressure[k] =
            faces->is_closed[k]
                ? faces->all_shut[k] + rw_dot(n, faces->inverse + k * n, faces->opening)
                : 0;
    return true;
}

/* Pressures and openings. */
static bool settle(rw_faces *faces, const double free[])
{
    size_t closed = 0;
    for (size_t k = 0; k < faces->n; k++)
        closed += faces->is_closed[k];
    return 2 * closed <= faces->n ? shut_closed(faces, free) : release_open(faces, free);
}

static void read_K(const rw_faces *faces, const double free[], double K[2])
{
    for (size_t i = 0; i < 2; i++)
        K[i] = free[i] + rw_dot(faces->n, faces->influence + i * faces->n, faces->pressure);
}

/* ---- Which places are closed ---- */

/* Changes the places that are pulled or overlap, all or the first; how many are wrong. */
static size_t mend(rw_faces *faces, double within, bool all)
{
    size_t wrong = 0;
    for (size_t k = 0; k < faces->n; k++) {
        const bool is_wrong =
            faces->is_closed[k] ? !(faces->pressure[k] > 0) : faces->opening[k] < -within;
        if (is_wrong && (all || wrong == 0))
            faces->is_closed[k] = !faces->is_closed[k];
        wrong += is_wrong;
    }
    return wrong;
}

static double largest_opening(const rw_faces *faces, const double free[])
{
    double largest = 0;
    for (size_t k = 0; k < faces->n; k++)
        largest = fmax(largest, fabs(free[2 + k]));
    return largest;
}

int32_t rw_faces_press(rw_faces *faces, const double free[], double K[2])
{
    static const double ROUNDING = 1e-12; /* of the largest opening */
    enum { AT_ONCE = 20 };
    const double within = ROUNDING * largest_opening(faces, free);
    const size_t tries = AT_ONCE + 20 * faces->n;
    for (size_t k = 0; k < faces->n; k++)
        faces->is_closed[k] = free[2 + k] < -within;
    for (size_t i = 0; i < tries; i++) {
        if (!settle(faces, free))
            return RWEDGE_ENOCONV;
        if (mend(faces, within, i < AT_ONCE) == 0) {
            read_K(faces, free, K);
            return RWEDGE_OK;
        }
    }
    return RWEDGE_ENOCONV;
}

/* While the same places are closed, K is straight along the way: Newton's step from one set of
 * closed places to the next is exact. A step that leaves the bracket is halved. */
int32_t rw_faces_pass(rw_faces *faces, const double open[], const double closed[], double *K_II)
{
    static const double SETTLED = 1e-13;
    enum { STEPS = 60 };
    double *between = malloc((2 + faces->n) * sizeof *between);
    double low = 0, high = 1, share = 0, K[2] = {0}, at_start[2], at_end[2];
    int32_t status = between ? RWEDGE_OK : RWEDGE_ENOMEM;
    for (int i = 0; i < STEPS && status == RWEDGE_OK && high - low > SETTLED; i++) {
        for (size_t k = 0; k < 2 + faces->n; k++)
            between[k] = (1 - share) * open[k] + share * closed[k];
        status = rw_faces_press(faces, between, K);
        if (status != RWEDGE_OK)
            break;
        *(K[0] > 0 ? &low : &high) = share;
        if (!settle(faces, open)) {
            status = RWEDGE_ENOCONV;
            break;
        }
        read_K(faces, open, at_start);
        if (!settle(faces, closed)) {
            status = RWEDGE_ENOCONV;
            break;
        }
        read_K(faces, closed, at_end);
        const double next = at_start[0] / (at_start[0] - at_end[0]);
        if (fabs(next - share) <= SETTLED)
            break;
        share = next > low && next < high ? next : low + (high - low) / 2;
    }
    free(between);
    if (status == RWEDGE_OK)
        *K_II = K[1];
    return status;
}
