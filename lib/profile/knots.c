/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the arcs of a fit begin and end. A knot is added where it reduces the squares most, then
 * all are moved, in ever smaller steps, as long as that helps; until Schwarz's criterion (BIC) does
 * not fall by more than 1. Then arcs are made straight, and knots left out, while it falls: noise
 * would bend the flat of a flat pad. */
#include "profile/profile.h"

#include "rwedge.h"

#include <math.h>

/* A knot is tried at so many places; it stays so many cells from others. It moves so many steps of
 * the first length at most, which is from end to end: a knot that does not reach its place makes
 * others be added (with 3 steps, two of them at a flat pad, whose pressure then errs by up to 77
 * %). More of the shorter steps take time and do not change pressures. */
enum {
    TRIES = 60,
    APART_NEW = RW_CELLS / 300,
    APART = RW_CELLS / 2000,
    FAR_MOVES = 120,
    MOVES = 8
};
static const int32_t steps[] = {RW_CELLS / 120, RW_CELLS / 300, RW_CELLS / 750, RW_CELLS / 2000, 1};

/* Heights are of the size 1: squares that are less are rounding. */
static const double ROUNDING = 1e-24;

static double place_of(int32_t knot)
{
    return 2.0 * knot / RW_CELLS - 1;
}

/* What level, slope and rates give on an arc: coefficients of 1, t and t^2 for each. */
static void take_terms(const rw_arcs *fit, int32_t arc, double term[][3])
{
    const double begin = place_of(fit->knot[arc]);
    for (int32_t j = 0; j < fit->arcs + 2; j++)
        term[j][0] = term[j][1] = term[j][2] = 0;
    term[0][0] = term[1][0] = term[1][1] = 1;
    for (int32_t j = 0; j < arc; j++) {
        const double end = place_of(fit->knot[j + 1]), width = end - place_of(fit->knot[j]);
        term[j + 2][0] = width * (width / 2 - end);
        term[j + 2][1] = width;
    }
    term[arc + 2][0] = begin * begin / 2;
    term[arc + 2][1] = -begin;
    term[arc + 2][2] = 0.5;
    for (int32_t j = 0; j < fit->arcs; j++)
        if (fit->is_straight[j])
            term[j + 2][0] = term[j + 2][1] = term[j + 2][2] = 0;
}

/* The columns of all equations, and their right side; what no parabola reduces is returned. */
static double set_equations(const rw_compressed *all, const rw_arcs *fit, double *A, double *v)
{
    double rest = 0, term[RW_MOST_COLUMNS][3];
    const int32_t rows = 3 * fit->arcs;
    for (int32_t arc = 0; arc < fit->arcs; arc++) {
        const rw_equations own =
            rw_compressed_range(all, (size_t)fit->knot[arc], (size_t)fit->knot[arc + 1]);
        take_terms(fit, arc, term);
        for (int32_t k = 0; k < 3; k++) {
            const double *row = own.row[k];
            v[3 * arc + k] = row[3];
            for (int32_t j = 0; j < fit->arcs + 2; j++)
                A[rows * j + 3 * arc + k] =
                    row[0] * term[j][0] + row[1] * term[j][1] + row[2] * term[j][2];
        }
        rest += own.rest;
    }
    return rest;
}

/* Makes the columns of length 1; one of zeros stays. */
static void scale(int32_t rows, int32_t columns, double *A, double size[])
{
    for (int32_t j = 0; j < columns; j++) {
        double square = 0;
        for (int32_t i = 0; i < rows; i++)
            square += A[rows * j + i] * A[rows * j + i];
        size[j] = square > 0 ? sqrt(square) : 1;
        for (int32_t i = 0; i < rows; i++)
            A[rows * j + i] /= size[j];
    }
}

/* The fit with these knots. Where there is none, as heights do not tell the arcs apart, its square
 * is infinite. */
static int32_t fit_knots(const rw_compressed *all, rw_arcs *fit)
{
    double A[RW_MOST_ROWS * RW_MOST_COLUMNS], v[RW_MOST_ROWS], size[RW_MOST_COLUMNS] = {0},
                                                               u[RW_MOST_COLUMNS], square = 0;
    const int32_t rows = 3 * fit->arcs, columns = fit->arcs + 2;
    const double rest = set_equations(all, fit, A, v);
    scale(rows, columns, A, size);
    const int32_t status = rw_nonnegative(rows, columns, 2, A, v, u, &square);
    fit->square = HUGE_VAL;
    if (status == RWEDGE_ERANK)
        return RWEDGE_OK;
    if (status != RWEDGE_OK)
        return status;
    fit->level = u[0] / size[0];
    fit->slope = u[1] / size[1];
    for (int32_t j = 0; j < fit->arcs; j++)
        fit->rate[j] = u[j + 2] / size[j + 2];
    fit->square = square + rest;
    return RWEDGE_OK;
}

/* ---- Knots are added ---- */

/* The fit with one knot more; false where it is too near to another one. */
static bool with_knot(const rw_arcs *fit, int32_t knot, rw_arcs *more)
{
    int32_t at = 1;
    while (fit->knot[at] < knot)
        at++;
    if (knot - fit->knot[at - 1] <= APART_NEW || fit->knot[at] - knot <= APART_NEW)
        return false;
    *more = *fit;
    for (int32_t i = fit->arcs; i >= at; i--)
        more->knot[i + 1] = fit->knot[i]; /* no arc is straight yet */
    more->knot[at] = knot;
    more->arcs++;
    return true;
}

static int32_t add_knot(const rw_compressed *all, const rw_arcs *fit, rw_arcs *best)
{
    best->square = HUGE_VAL;
    for (int32_t i = 1; i <= TRIES; i++) {
        rw_arcs more;
        if (!with_knot(fit, (int32_t)((int64_t)i * RW_CELLS / (TRIES + 1)), &more))
            continue;
        const int32_t status = fit_knots(all, &more);
        if (status != RWEDGE_OK)
            return status;
        if (more.square < best->square)
            *best = more;
    }
    return RWEDGE_OK;
}

/* ---- Knots are moved ---- */

static int32_t try_move(const rw_compressed *all, int32_t knot, int32_t by, rw_arcs *fit,
                        bool *moved)
{
    const double GAIN = 1e-6;
    rw_arcs other = *fit;
    other.knot[knot] += by;
    if (other.knot[knot] - other.knot[knot - 1] <= APART ||
        other.knot[knot + 1] - other.knot[knot] <= APART)
        return RWEDGE_OK;
    const int32_t status = fit_knots(all, &other);
    if (status == RWEDGE_OK && other.square < fit->square * (1 - GAIN)) {
        *fit = other;
        *moved = true;
    }
    return status;
}

static int32_t move_knots(const rw_compressed *all, rw_arcs *fit)
{
    int32_t status = RWEDGE_OK;
    for (size_t s = 0; s < sizeof steps / sizeof steps[0]; s++) {
        bool moved = true;
        for (int round = 0; round < (s == 0 ? FAR_MOVES : MOVES) && moved; round++) {
            moved = false;
            for (int32_t i = 1; i < fit->arcs && status == RWEDGE_OK; i++) {
                status = try_move(all, i, -steps[s], fit, &moved);
                if (status == RWEDGE_OK)
                    status = try_move(all, i, steps[s], fit, &moved);
            }
        }
    }
    return status;
}

/* ---- As many as are worth it ---- */

static double criterion(size_t n, const rw_arcs *fit)
{
    const double count = (double)n;
    int32_t parameters = 2 * fit->arcs + 2;
    for (int32_t j = 0; j < fit->arcs; j++)
        parameters -= fit->is_straight[j];
    return count * log(fit->square / count + ROUNDING) + parameters * log(count);
}

static rw_arcs with_straight_arc(const rw_arcs *fit, int32_t arc)
{
    rw_arcs less = *fit;
    less.is_straight[arc] = true;
    return less;
}

/* The arcs on either side of the knot are one. */
static rw_arcs without_knot(const rw_arcs *fit, int32_t knot)
{
    rw_arcs less = *fit;
    less.is_straight[knot - 1] = fit->is_straight[knot - 1] && fit->is_straight[knot];
    for (int32_t i = knot; i < fit->arcs; i++) {
        less.knot[i] = fit->knot[i + 1];
        if (i + 1 < fit->arcs)
            less.is_straight[i] = fit->is_straight[i + 1];
    }
    less.arcs--;
    return less;
}

/* Takes a fit if it has the lower criterion. */
static int32_t take_lower(const rw_compressed *all, size_t n, rw_arcs other, rw_arcs *best)
{
    const int32_t status = fit_knots(all, &other);
    if (status == RWEDGE_OK && criterion(n, &other) < criterion(n, best))
        *best = other;
    return status;
}

/* The simpler fit of the lowest criterion before its knots are moved, which may all be higher. */
static int32_t simpler_fit(const rw_compressed *all, size_t n, const rw_arcs *fit, bool keeps_arcs,
                           rw_arcs *simpler)
{
    int32_t status = RWEDGE_OK;
    *simpler = *fit;
    simpler->square = HUGE_VAL;
    for (int32_t i = 0; i < fit->arcs && status == RWEDGE_OK; i++) {
        if (!fit->is_straight[i])
            status = take_lower(all, n, with_straight_arc(fit, i), simpler);
        if (status == RWEDGE_OK && i > 0 && !keeps_arcs)
            status = take_lower(all, n, without_knot(fit, i), simpler);
    }
    return status;
}

static int32_t simplify(const rw_compressed *all, size_t n, bool keeps_arcs, rw_arcs *fit)
{
    for (int i = 0; i < 2 * RW_MOST_ARCS; i++) {
        rw_arcs simpler;
        int32_t status = simpler_fit(all, n, fit, keeps_arcs, &simpler);
        if (status == RWEDGE_OK && isfinite(simpler.square))
            status = move_knots(all, &simpler);
        if (status != RWEDGE_OK || !(criterion(n, &simpler) < criterion(n, fit)))
            return status;
        *fit = simpler;
    }
    return RWEDGE_OK;
}

int32_t rw_fit_arcs(const rw_compressed *all, size_t n, int32_t arcs, int32_t most, rw_arcs *best)
{
    rw_arcs fit = {.arcs = 1, .knot = {0, RW_CELLS}};
    int32_t status = fit_knots(all, &fit);
    *best = fit;
    while (status == RWEDGE_OK && fit.arcs < (arcs > 0 ? arcs : most)) {
        rw_arcs more;
        status = add_knot(all, &fit, &more);
        if (status != RWEDGE_OK || isinf(more.square))
            break;
        status = move_knots(all, &more);
        fit = more;
        if (status != RWEDGE_OK || (arcs == 0 && criterion(n, &fit) >= criterion(n, best) - 1))
            break;
        *best = fit;
    }
    return status == RWEDGE_OK ? simplify(all, n, arcs > 0, best) : status;
}
