/* SPDX-License-Identifier: GPL-3.0-or-later */
/* C. L. Lawson and R. J. Hanson, Solving Least Squares Problems, 1974, chapter 23. */
#include "profile/profile.h"

#include "base/least_squares.h"
#include "rwedge.h"

#include <math.h>
#include <string.h>

typedef struct {
    int32_t rows, columns;
    const double *A, *v;
    bool is_in[RW_MOST_COLUMNS]; /* unknowns that are not held at 0 */
} problem;

/* The solution of the unknowns that are in, 0 for the others. */
static int32_t solve(const problem *p, double u[])
{
    double A[RW_MOST_ROWS * RW_MOST_COLUMNS], v[RW_MOST_ROWS];
    int32_t count = 0;
    for (int32_t j = 0; j < p->columns; j++)
        if (p->is_in[j])
            memcpy(A + p->rows * count++, p->A + p->rows * j, (size_t)p->rows * sizeof *A);
    memcpy(v, p->v, (size_t)p->rows * sizeof *v);
    const int32_t status = rw_least_squares(p->rows, count, A, v);
    for (int32_t j = 0, k = 0; status == RWEDGE_OK && j < p->columns; j++)
        u[j] = p->is_in[j] ? v[k++] : 0;
    return status;
}

static double residue(const problem *p, const double u[], double left[])
{
    double square = 0;
    for (int32_t i = 0; i < p->rows; i++) {
        left[i] = p->v[i];
        for (int32_t j = 0; j < p->columns; j++)
            left[i] -= p->A[p->rows * j + i] * u[j];
        square += left[i] * left[i];
    }
    return square;
}

static bool is_allowed(const problem *p, int32_t free_count, const double u[])
{
    for (int32_t j = free_count; j < p->columns; j++)
        if (p->is_in[j] && !(u[j] >= 0))
            return false;
    return true;
}

/* The unknown at 0 that would reduce the residue most; -1 where none would. */
static int32_t best_entry(const problem *p, const double u[], const bool refused[])
{
    double left[RW_MOST_ROWS];
    const double noise = 1e-12;
    int32_t best = -1;
    double most = noise * sqrt(residue(p, u, left));
    for (int32_t j = 0; j < p->columns; j++) {
        double gain = 0;
        for (int32_t i = 0; i < p->rows; i++)
            gain += p->A[p->rows * j + i] * left[i];
        if (!p->is_in[j] && !refused[j] && gain > most) {
            most = gain;
            best = j;
        }
    }
    return best;
}

/* Goes from allowed unknowns towards the solution, as far as none becomes negative; those that
 * reach 0 are held there. */
static void step(problem *p, int32_t free_count, const double solution[], double u[])
{
    double part = 1;
    int32_t first = -1;
    for (int32_t j = free_count; j < p->columns; j++)
        if (p->is_in[j] && solution[j] < 0 && u[j] / (u[j] - solution[j]) < part) {
            part = u[j] / (u[j] - solution[j]);
            first = j;
        }
    for (int32_t j = 0; j < p->columns; j++) {
        u[j] += part * (solution[j] - u[j]);
        if (j >= free_count && p->is_in[j] && (j == first || u[j] <= 0)) {
            u[j] = 0;
            p->is_in[j] = false;
        }
    }
}

static int32_t go_on(problem *p, int32_t free_count, double u[])
{
    double solution[RW_MOST_COLUMNS];
    int32_t status = solve(p, solution);
    while (status == RWEDGE_OK && !is_allowed(p, free_count, solution)) {
        step(p, free_count, solution, u);
        status = solve(p, solution);
    }
    if (status == RWEDGE_OK)
        memcpy(u, solution, sizeof solution);
    return status;
}

int32_t rw_nonnegative(int32_t rows, int32_t columns, int32_t free_count, const double *A,
                       const double *v, double u[], double *square)
{
    problem p = {.rows = rows, .columns = columns, .A = A, .v = v};
    bool refused[RW_MOST_COLUMNS] = {false};
    double left[RW_MOST_ROWS], all[RW_MOST_COLUMNS] = {0};
    for (int32_t j = 0; j < columns; j++)
        p.is_in[j] = true;
    int32_t status = solve(&p, all);
    const bool is_dependent = status == RWEDGE_ERANK;
    if (is_dependent || (status == RWEDGE_OK && !is_allowed(&p, free_count, all))) {
        memset(all, 0, sizeof all);
        for (int32_t j = free_count; j < columns; j++)
            p.is_in[j] = false;
        status = solve(&p, all);
        for (int32_t round = 0, entry = 0; status == RWEDGE_OK && round < 3 * columns; round++) {
            entry = best_entry(&p, all, refused);
            if (entry < 0)
                break;
            p.is_in[entry] = refused[entry] = true; /* each once: rounding may not bring it back */
            status = go_on(&p, free_count, all);
        }
    }
    if (status != RWEDGE_OK)
        return status;
    memcpy(u, all, (size_t)columns * sizeof *u);
    *square = residue(&p, u, left);
    return RWEDGE_OK;
}
