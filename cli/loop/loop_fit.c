/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least squares of Q: a contact is driven by the displacements, and what is left of the measured Q
 * has the smallest sum of squares. Levenberg's and Marquardt's steps, from the best of a grid of
 * beginnings. A log may begin with a contact that has no shear yet, or in the middle of steady
 * cycles: it is gone through once, or twice of which the second time counts, as fits better. */
#include "loop.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is fitted, and the sizes of its parts. */
typedef struct {
    const contact_case *setup;
    size_t count;
    const load *row;
    int passes;
    double Q, way; /* the largest |Q|, the range of the displacement */
} problem;

typedef struct {
    double part[LOOP_PARTS];
} point;

static const double EXHAUSTED = 1 - 1e-9; /* of f P: the contact slides */

static load driven_load(const problem *p, const point *at, size_t i)
{
    load to = p->row[i];
    to.is_driven = true;
    to.displacement -= at->part[LOOP_OFFSET];
    to.compliance = at->part[LOOP_COMPLIANCE];
    if (to.P <= 0)
        to.P = to.M = 0;
    return to;
}

static int32_t drive_through(const problem *p, const point *at, rwedge_contact *contact, double Q[])
{
    const load first = {.P = fmax(p->row[0].P, 0), .M = p->row[0].M, .sigma = p->row[0].sigma};
    int32_t status = loads_apply(first, contact);
    for (int pass = 0; pass < p->passes; pass++)
        for (size_t i = 0; i < p->count && status == RWEDGE_OK; i++) {
            status = loads_apply(driven_load(p, at, i), contact);
            Q[i] = loads_of(contact).Q;
        }
    return status;
}

/* The forces that the parts give. */
static int32_t model(const problem *p, const point *at, double Q[])
{
    contact_case setup = *p->setup;
    rwedge_contact *contact = NULL;
    setup.f = at->part[LOOP_F];
    int32_t status = case_contact(&setup, &contact);
    if (status == RWEDGE_OK)
        status = drive_through(p, at, contact, Q);
    rwedge_contact_destroy(contact);
    return status;
}

/* HUGE_VAL where the contact refuses a load. */
static double squares(const problem *p, const point *at, double Q[])
{
    double sum = 0;
    if (model(p, at, Q) != RWEDGE_OK)
        return HUGE_VAL;
    for (size_t i = 0; i < p->count; i++)
        sum += (Q[i] - p->row[i].Q) * (Q[i] - p->row[i].Q);
    return isnan(sum) ? HUGE_VAL : sum;
}

/* ---- Where to begin ---- */

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The value below which such a part of them is; they are sorted. */
static double quantile(double all[], size_t count, double part)
{
    qsort(all, count, sizeof *all, compare);
    return count > 0 ? all[(size_t)(part * (double)(count - 1))] : 0;
}

static double usual_ratio(const problem *p, double work[])
{
    size_t count = 0;
    for (size_t i = 0; i < p->count; i++)
        if (p->row[i].P > 0)
            work[count++] = fabs(p->row[i].Q) / p->row[i].P;
    return quantile(work, count, 0.98);
}

/* How far the displacement goes for Q, where Q changes fast: there little slips. */
static double usual_slope(const problem *p, double work[])
{
    const double FAST = 0.02;
    size_t count = 0;
    for (size_t i = 1; i < p->count; i++) {
        const double dQ = p->row[i].Q - p->row[i - 1].Q,
                     d = p->row[i].displacement - p->row[i - 1].displacement;
        if (fabs(dQ) > FAST * p->Q && d * dQ > 0)
            work[count++] = d / dQ;
    }
    const double slope = quantile(work, count, 0.3);
    return slope > 0 ? slope : p->way / (2 * p->Q);
}

/* Where Q is 0: as the log begins, or in the middle of its loop. */
static double usual_offset(const problem *p, double slope, bool is_first)
{
    double Q[2] = {HUGE_VAL, -HUGE_VAL}, d[2] = {HUGE_VAL, -HUGE_VAL};
    if (is_first)
        return p->row[0].displacement - slope * p->row[0].Q;
    for (size_t i = 0; i < p->count; i++) {
        Q[0] = fmin(Q[0], p->row[i].Q);
        Q[1] = fmax(Q[1], p->row[i].Q);
        d[0] = fmin(d[0], p->row[i].displacement);
        d[1] = fmax(d[1], p->row[i].displacement);
    }
    return (d[0] + d[1]) / 2 - slope * (Q[0] + Q[1]) / 2;
}

/* Tries a grid; keeps the best point, and how often the log is gone through there. */
static double begin(problem *p, point *best, double work[])
{
    static const double friction[] = {1, 1.03, 1.1, 1.3, 1.8}, compliance[] = {0.6, 0.8, 0.95};
    const double ratio = usual_ratio(p, work), slope = usual_slope(p, work);
    double least = HUGE_VAL;
    int passes = 1;
    for (int i = 0; i < 5 * 3 * 2 * 2; i++) {
        const double C = slope * compliance[i / 4 % 3];
        const point at = {{ratio * friction[i / 12], C, usual_offset(p, C, i % 2 == 0)}};
        p->passes = 1 + i / 2 % 2;
        const double sum = squares(p, &at, work);
        if (sum < least) {
            least = sum;
            *best = at;
            passes = p->passes;
        }
    }
    p->passes = passes;
    return least;
}

/* ---- Steps ---- */

/* The normal equations of a step, and their right-hand side. */
typedef struct {
    double matrix[LOOP_PARTS][LOOP_PARTS], side[LOOP_PARTS];
} normal;

static double difference_of(const problem *p, const point *at, int part)
{
    const double size[LOOP_PARTS] = {at->part[LOOP_F], p->way / p->Q, p->way};
    return 1e-4 * size[part];
}

/* `slopes` has room for the slopes of Q by each part. */
static bool linearise(const problem *p, const point *at, const double Q[], double *slopes,
                      normal *equations)
{
    memset(equations, 0, sizeof *equations);
    for (int j = 0; j < LOOP_PARTS; j++) {
        double *slope = slopes + (size_t)j * p->count;
        point beside = *at;
        const double by = difference_of(p, at, j);
        beside.part[j] += by;
        if (model(p, &beside, slope) != RWEDGE_OK)
            return false;
        for (size_t i = 0; i < p->count; i++)
            slope[i] = (slope[i] - Q[i]) / by;
    }
    for (int j = 0; j < LOOP_PARTS; j++)
        for (size_t i = 0; i < p->count; i++) {
            const double slope = slopes[(size_t)j * p->count + i];
            equations->side[j] += slope * (p->row[i].Q - Q[i]);
            for (int k = 0; k < LOOP_PARTS; k++)
                equations->matrix[j][k] += slope * slopes[(size_t)k * p->count + i];
        }
    return true;
}

/* Solves in place; a part that nothing depends on stays. False where it is singular. */
static bool solve(normal e, const bool is_told[LOOP_PARTS], double step[LOOP_PARTS])
{
    for (int j = 0; j < LOOP_PARTS; j++)
        for (int k = 0; k < LOOP_PARTS && !is_told[j]; k++) {
            e.matrix[j][k] = e.matrix[k][j] = j == k ? 1 : 0;
            e.side[j] = 0;
        }
    double size[LOOP_PARTS];
    for (int j = 0; j < LOOP_PARTS; j++)
        size[j] = e.matrix[j][j];
    for (int j = 0; j < LOOP_PARTS; j++) { /* positive: no pivots are needed */
        if (!(e.matrix[j][j] > 1e-13 * size[j]))
            return false;
        for (int i = j + 1; i < LOOP_PARTS; i++) {
            const double part = e.matrix[i][j] / e.matrix[j][j];
            for (int k = j; k < LOOP_PARTS; k++)
                e.matrix[i][k] -= part * e.matrix[j][k];
            e.side[i] -= part * e.side[j];
        }
    }
    for (int j = LOOP_PARTS - 1; j >= 0; j--) {
        step[j] = e.side[j];
        for (int k = j + 1; k < LOOP_PARTS; k++)
            step[j] -= e.matrix[j][k] * step[k];
        step[j] /= e.matrix[j][j];
    }
    return true;
}

/* Which parts the loop tells: a change of the size of a part changes Q by more than next to
 * nothing. */
static void find_told(const problem *p, const point *at, const normal *e, bool is_told[LOOP_PARTS])
{
    const double NOTHING = 1e-4; /* of the largest Q, in the mean */
    for (int j = 0; j < LOOP_PARTS; j++) {
        const double by = difference_of(p, at, j) * 1e4;
        is_told[j] = sqrt(e->matrix[j][j] / (double)p->count) * by > NOTHING * p->Q;
    }
}

static point moved(const problem *p, const point *at, const double step[LOOP_PARTS])
{
    point next = *at;
    for (int j = 0; j < LOOP_PARTS; j++)
        next.part[j] += step[j];
    next.part[LOOP_F] = fmax(next.part[LOOP_F], at->part[LOOP_F] / 2);
    next.part[LOOP_F] = fmin(next.part[LOOP_F], 2 * at->part[LOOP_F]);
    next.part[LOOP_COMPLIANCE] = fmax(next.part[LOOP_COMPLIANCE], 1e-6 * p->way / p->Q);
    return next;
}

/* Steps until the sum does not fall any more; `Q` is that of the last point, `least` its sum. */
static void descend(const problem *p, point *at, double Q[], double least, double *work, normal *e)
{
    enum { STEPS = 40 };
    const double DONE = 1e-9;
    double damping = 1e-3, *tried = work, *slopes = work + p->count;
    bool is_new = true;
    for (int i = 0; i < STEPS && damping < 1e8; i++) {
        bool is_told[LOOP_PARTS];
        double step[LOOP_PARTS];
        if (is_new && !linearise(p, at, Q, slopes, e))
            return;
        find_told(p, at, e, is_told);
        normal damped = *e;
        for (int j = 0; j < LOOP_PARTS; j++)
            damped.matrix[j][j] *= 1 + damping;
        const point next = solve(damped, is_told, step) ? moved(p, at, step) : *at;
        const double sum = squares(p, &next, tried);
        is_new = sum < least;
        damping *= is_new ? 0.1 : 10;
        if (!is_new)
            continue;
        const bool is_done = least - sum <= DONE * least;
        *at = next;
        least = sum;
        memcpy(Q, tried, p->count * sizeof *Q);
        if (is_done)
            break;
    }
    linearise(p, at, Q, slopes, e);
}

/* ---- What it comes to ---- */

static void find_uncertainty(const problem *p, const point *at, const normal *e, loop_fit *fit)
{
    bool is_told[LOOP_PARTS];
    find_told(p, at, e, is_told);
    for (int j = 0; j < LOOP_PARTS; j++) {
        normal unit = *e;
        double column[LOOP_PARTS];
        memset(unit.side, 0, sizeof unit.side);
        unit.side[j] = 1;
        fit->value[j] = at->part[j];
        fit->uncertainty[j] = is_told[j] && solve(unit, is_told, column) && column[j] > 0
                                  ? fit->noise * sqrt(column[j])
                                  : NAN;
    }
}

/* A friction that may as well be half as large, or twice, is not known: the loop is a line. */
static void find_regime(const problem *p, loop_fit *fit)
{
    bool slides = false;
    for (size_t i = 0; i < p->count; i++)
        slides = slides || (p->row[i].P > 0 &&
                            fabs(fit->Q[i]) >= EXHAUSTED * fit->value[LOOP_F] * p->row[i].P);
    fit->regime = slides ? LOOP_GROSS : LOOP_PARTIAL;
    if (fit->uncertainty[LOOP_F] < fit->value[LOOP_F] / 2)
        return;
    fit->regime = LOOP_STICKS;
    fit->value[LOOP_F] = fit->uncertainty[LOOP_F] = NAN;
}

static bool measure(problem *p, complaint *why)
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    bool presses = false;
    for (size_t i = 0; i < p->count; i++) {
        p->Q = fmax(p->Q, fabs(p->row[i].Q));
        least = fmin(least, p->row[i].displacement);
        most = fmax(most, p->row[i].displacement);
        presses = presses || p->row[i].P > 0;
    }
    p->way = most - least;
    if (p->count < 8)
        return complain(why, "%zu rows: too few for a loop; needed: 8", p->count);
    if (!presses || !(p->Q > 0) || !(p->way > 0))
        return complain(why, "no loop: P, Q or the displacement stays 0, or does not change");
    return true;
}

bool loop_fit_find(const contact_case *setup, size_t count, const load row[], loop_fit *fit,
                   complaint *why)
{
    problem p = {.setup = setup, .count = count, .row = row};
    point at;
    normal e;
    *fit = (loop_fit){.Q = memory_zeroed(count + 1, sizeof *fit->Q)};
    if (!measure(&p, why))
        return false;
    double *work = memory_zeroed((LOOP_PARTS + 1) * count, sizeof *work);
    double least = begin(&p, &at, work);
    if (least < HUGE_VAL) {
        least = squares(&p, &at, fit->Q);
        descend(&p, &at, fit->Q, least, work, &e);
        fit->noise = sqrt(squares(&p, &at, fit->Q) / (double)(count - LOOP_PARTS));
        find_uncertainty(&p, &at, &e, fit);
        find_regime(&p, fit);
    }
    free(work);
    return least < HUGE_VAL ||
           complain(why, "no friction is found with which the contact follows these displacements; "
                         "under a moment or a tension it must not slide fully");
}
