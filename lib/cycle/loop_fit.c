/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a measured loop of Q over the displacement tells. A contact is driven by the displacements,
 * and what is left of the measured Q has the smallest sum of squares: Levenberg's and Marquardt's
 * steps, from the best of a grid of beginnings. GSL has such steps too, but allocates for them, and
 * tells the error handler of the process where memory is short; base/root.c says why that may not
 * be. */
#include "cycle/states.h"

#include "base/domain.h"
#include "base/linear.h"
#include "base/sort.h"

enum { FRICTION, COMPLIANCE, OFFSET, PARTS };

/* The rows, and the sizes of what is fitted to them. */
typedef struct {
    const rwedge_contact *contact;
    size_t n;
    const double *P, *M, *sigma, *displacement, *Q;
    double Q_most, way; /* the largest |Q|, the range of the displacement */
    double *work;       /* n numbers */
} measured;

/* Parts of the fit, how often the log is gone through, the forces that follow, and the squares of
 * what they leave; HUGE_VAL where the contact refuses a load. */
typedef struct {
    double part[PARTS];
    int passes;
    double *Q, squares;
} trial;

static void exchange(trial *a, trial *b)
{
    const trial before = *a;
    *a = *b;
    *b = before;
}

/* ---- The forces that follow ---- */

static int32_t contact_with(const measured *log, double f, rwedge_contact **contact)
{
    rwedge_contact bodies = *log->contact;
    bodies.f = f;
    const int32_t status =
        rw_is_friction(f) ? rw_contact_unloaded(&bodies, contact) : RWEDGE_EDOMAIN;
    if (status == RWEDGE_OK)
        (*contact)->tolerance = bodies.tolerance;
    return status;
}

static int32_t drive_through(const measured *log, rwedge_contact *contact, trial *t)
{
    int32_t status = rwedge_contact_apply(contact, log->P[0], log->M[0], 0, log->sigma[0]);
    for (int pass = 0; pass < t->passes; pass++)
        for (size_t i = 0; i < log->n && status == RWEDGE_OK; i++)
            status = rwedge_contact_drive(contact, log->P[i], log->M[i], log->sigma[i],
                                          log->displacement[i] - t->part[OFFSET],
                                          t->part[COMPLIANCE], &t->Q[i]);
    return status;
}

static double squares_of(const measured *log, const double Q[])
{
    double sum = 0;
    for (size_t i = 0; i < log->n; i++)
        sum += (Q[i] - log->Q[i]) * (Q[i] - log->Q[i]);
    return sum;
}

/* Only a lack of memory is an error. */
static int32_t follow(const measured *log, trial *t)
{
    rwedge_contact *contact = NULL;
    int32_t status = contact_with(log, t->part[FRICTION], &contact);
    if (status == RWEDGE_OK)
        status = drive_through(log, contact, t);
    rwedge_contact_destroy(contact);
    t->squares = status == RWEDGE_OK ? squares_of(log, t->Q) : HUGE_VAL;
    return status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : RWEDGE_OK;
}

/* ---- Where to begin ---- */

/* The value below which such a part of them is. */
static double quantile(double all[], size_t count, double part)
{
    rw_sort(all, count);
    return count > 0 ? all[(size_t)(part * (double)(count - 1))] : 0;
}

static double usual_ratio(const measured *log)
{
    size_t count = 0;
    for (size_t i = 0; i < log->n; i++)
        if (log->P[i] > 0)
            log->work[count++] = fabs(log->Q[i]) / log->P[i];
    return quantile(log->work, count, 0.98);
}

/* How far the displacement goes for Q, where Q changes fast: there little slips. */
static double usual_slope(const measured *log)
{
    const double FAST = 0.02;
    size_t count = 0;
    for (size_t i = 1; i < log->n; i++) {
        const double dQ = log->Q[i] - log->Q[i - 1],
                     d = log->displacement[i] - log->displacement[i - 1];
        if (fabs(dQ) > FAST * log->Q_most && d * dQ > 0)
            log->work[count++] = d / dQ;
    }
    const double slope = quantile(log->work, count, 0.3);
    return slope > 0 ? slope : log->way / (2 * log->Q_most);
}

static double middle_of(size_t n, const double number[])
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        least = fmin(least, number[i]);
        most = fmax(most, number[i]);
    }
    return least / 2 + most / 2;
}

/* Tries a grid: the friction, the compliance, and whether Q is 0 as the log begins or in the middle
 * of its loop. */
static int32_t begin(const measured *log, trial *best, trial *tried)
{
    static const double friction[] = {1, 1.1, 1.5}, compliance[] = {0.65, 0.9};
    const double ratio = usual_ratio(log), slope = usual_slope(log);
    const double way[] = {log->displacement[0], middle_of(log->n, log->displacement)},
                 force[] = {log->Q[0], middle_of(log->n, log->Q)};
    int32_t status = RWEDGE_OK;
    best->squares = HUGE_VAL;
    for (int i = 0; i < 3 * 2 * 2 && status == RWEDGE_OK; i++) {
        const double C = slope * compliance[i / 2 % 2];
        tried->part[FRICTION] = ratio * friction[i / 4];
        tried->part[COMPLIANCE] = C;
        tried->part[OFFSET] = way[i % 2] - C * force[i % 2];
        tried->passes = best->passes;
        status = follow(log, tried);
        if (tried->squares < best->squares)
            exchange(best, tried);
    }
    return status;
}

/* ---- Steps ---- */

/* The normal equations of a step, whose unknowns are counted in their sizes, and which of them the
 * loop tells. */
typedef struct {
    double size[PARTS], matrix[PARTS][PARTS], side[PARTS];
    bool is_told[PARTS];
} normal;

/* How Q changes with a part, into n numbers: 0 where the contact refuses the part beside. */
static int32_t find_slope(const measured *log, const trial *at, int part, double size,
                          double *slope)
{
    const double STEP = 1e-4;
    trial beside = *at;
    beside.Q = slope;
    beside.part[part] += STEP * size;
    const int32_t status = follow(log, &beside);
    for (size_t i = 0; i < log->n; i++)
        slope[i] = beside.squares < HUGE_VAL ? (slope[i] - at->Q[i]) / STEP : 0;
    return status;
}

/* A part that moves Q by next to nothing is not told, and stays. */
static void drop_untold(const measured *log, normal *equations)
{
    const double NOTHING = 1e-4; /* of the largest Q, in the mean, by the size of the part */
    for (int j = 0; j < PARTS; j++) {
        const double mean = sqrt(equations->matrix[j][j] / (double)log->n);
        equations->is_told[j] = mean > NOTHING * log->Q_most;
        for (int k = 0; k < PARTS && !equations->is_told[j]; k++)
            equations->matrix[j][k] = equations->matrix[k][j] = j == k;
        equations->side[j] = equations->is_told[j] ? equations->side[j] : 0;
    }
}

/* `slopes` has room for those of each part. */
static int32_t linearise(const measured *log, const trial *at, double *slopes, normal *equations)
{
    const size_t n = log->n;
    int32_t status = RWEDGE_OK;
    *equations = (normal){.size = {at->part[FRICTION], log->way / log->Q_most, log->way}};
    for (int j = 0; j < PARTS && status == RWEDGE_OK; j++)
        status = find_slope(log, at, j, equations->size[j], slopes + (size_t)j * n);
    for (int j = 0; j < PARTS; j++) {
        const double *slope = slopes + (size_t)j * n;
        for (size_t i = 0; i < n; i++)
            equations->side[j] += slope[i] * (log->Q[i] - at->Q[i]);
        for (int k = 0; k < PARTS; k++)
            equations->matrix[j][k] = rw_dot(n, slope, slopes + (size_t)k * n);
    }
    drop_untold(log, equations);
    return status;
}

/* A x = side, in place; false where A is singular. */
static bool solve(const normal *equations, double damping, double side[PARTS])
{
    double A[PARTS * PARTS];
    for (int j = 0; j < PARTS; j++)
        for (int k = 0; k < PARTS; k++)
            A[j * PARTS + k] = equations->matrix[j][k] * (j == k ? 1 + damping : 1);
    if (!rw_cholesky(PARTS, A))
        return false;
    rw_cholesky_solve(PARTS, A, side);
    return true;
}

/* The friction changes by a factor of 2 at most. */
static void move(const measured *log, const trial *at, const normal *equations, double damping,
                 trial *next)
{
    double step[PARTS] = {equations->side[0], equations->side[1], equations->side[2]};
    const bool is_solved = solve(equations, damping, step);
    const double f = at->part[FRICTION];
    for (int j = 0; j < PARTS; j++)
        next->part[j] = at->part[j] + (is_solved ? step[j] * equations->size[j] : 0);
    next->part[FRICTION] = fmax(f / 2, fmin(next->part[FRICTION], 2 * f));
    next->part[COMPLIANCE] = fmax(next->part[COMPLIANCE], 1e-6 * log->way / log->Q_most);
    next->passes = at->passes;
}

/* Steps until the squares do not fall any more; the equations are those at the end. */
static int32_t descend(const measured *log, trial *at, trial *tried, double *slopes,
                       normal *equations)
{
    enum { STEPS = 40 };
    const double DONE = 1e-6, DAMPED = 1e4;
    double damping = 1e-3;
    bool is_done = false;
    int32_t status = linearise(log, at, slopes, equations);
    for (int i = 0; i < STEPS && damping < DAMPED && !is_done && status == RWEDGE_OK; i++) {
        move(log, at, equations, damping, tried);
        status = follow(log, tried);
        const bool is_better = tried->squares < at->squares;
        damping *= is_better ? 0.1 : 10;
        if (!is_better || status != RWEDGE_OK)
            continue;
        is_done = at->squares - tried->squares <= DONE * at->squares;
        exchange(at, tried);
        status = linearise(log, at, slopes, equations);
    }
    return status;
}

/* ---- What it comes to ---- */

typedef struct {
    double value[PARTS], uncertainty[PARTS], told[PARTS], regime;
} result;

/* The uncertainty of a part of the linear problem, by the noise. */
static bool find_uncertainty(const normal *equations, int part, double noise, double *uncertainty)
{
    double column[PARTS] = {part == 0, part == 1, part == 2};
    if (!equations->is_told[part] || !solve(equations, 0, column) || !(column[part] > 0))
        return false;
    *uncertainty = noise * sqrt(column[part]) * equations->size[part];
    return true;
}

static bool slides(const measured *log, const trial *fit)
{
    const double EXHAUSTED = 1 - 1e-9; /* of f P */
    for (size_t i = 0; i < log->n; i++)
        if (log->P[i] > 0 && fabs(fit->Q[i]) >= EXHAUSTED * fit->part[FRICTION] * log->P[i])
            return true;
    return false;
}

/* A friction that may as well be half as large, or twice, is not told: the loop is a line. */
static result result_of(const measured *log, const trial *fit, const normal *equations)
{
    const double noise = sqrt(fit->squares / (double)(log->n - PARTS));
    result r = {.regime = RWEDGE_LOOP_STICK};
    for (int j = 0; j < PARTS; j++) {
        double uncertainty;
        if (!find_uncertainty(equations, j, noise, &uncertainty) ||
            (j == FRICTION && uncertainty >= fit->part[j] / 2))
            continue;
        r.told[j] = 1;
        r.value[j] = fit->part[j];
        r.uncertainty[j] = uncertainty;
    }
    if (r.told[FRICTION] > 0)
        r.regime = slides(log, fit) ? RWEDGE_LOOP_GROSS_SLIP : RWEDGE_LOOP_PARTIAL_SLIP;
    return r;
}

/* In gross slip an offset lets a contact without shear begin anywhere on a steady loop. So it is
 * better only where it takes from the squares what three standard deviations have. */
static const double BETTER = 9;

/* Through the log so often; it becomes the best, with its equations, if it is better. */
static int32_t fit_passes(const measured *log, int passes, double *slopes, trial *best,
                          trial spare[2], normal *equations)
{
    normal own;
    trial *at = &spare[0], *tried = &spare[1];
    at->passes = passes;
    int32_t status = begin(log, at, tried);
    if (status == RWEDGE_OK && at->squares < HUGE_VAL)
        status = descend(log, at, tried, slopes, &own);
    if (status == RWEDGE_OK &&
        at->squares * (1 + BETTER / (double)(log->n - PARTS)) < best->squares) {
        *equations = own;
        exchange(best, at);
    }
    return status;
}

/* A log may begin in steady cycles, or with a contact that has no shear: as fits better. `room` has
 * 5 n numbers. */
static int32_t fit_to(const measured *log, double *room, trial *best, result *r)
{
    trial spare[2] = {{.Q = room}, {.Q = room + log->n}};
    double *slopes = room + 2 * log->n;
    normal equations = {.size = {0}};
    int32_t status = RWEDGE_OK;
    for (int passes = 2; passes >= 1 && status == RWEDGE_OK; passes--)
        status = fit_passes(log, passes, slopes, best, spare, &equations);
    if (status == RWEDGE_OK && best->squares == HUGE_VAL)
        status = RWEDGE_ENOCONV;
    if (status == RWEDGE_OK)
        *r = result_of(log, best, &equations);
    return status;
}

/* ---- The rows ---- */

static bool are_rows(const measured *log)
{
    for (size_t i = 0; i < log->n; i++)
        if (!rw_is_magnitude(log->P[i]) || !rw_is_signed(log->M[i]) ||
            (log->P[i] == 0 && log->M[i] != 0) || !rw_is_signed(log->sigma[i]) ||
            !rw_is_signed(log->displacement[i]) || !rw_is_signed(log->Q[i]))
            return false;
    return true;
}

/* False where there is no loop. */
static bool find_sizes(measured *log)
{
    double least = HUGE_VAL, most = -HUGE_VAL, P_most = 0;
    for (size_t i = 0; i < log->n; i++) {
        log->Q_most = fmax(log->Q_most, fabs(log->Q[i]));
        P_most = fmax(P_most, log->P[i]);
        least = fmin(least, log->displacement[i]);
        most = fmax(most, log->displacement[i]);
    }
    log->way = most - least;
    return P_most > 0 && log->Q_most > 0 && log->way > 0;
}

int32_t rwedge_contact_loop_fit(const rwedge_contact *contact, size_t n, const double P[],
                                const double M[], const double sigma[], const double displacement[],
                                const double Q[], double value[3], double uncertainty[3],
                                double told[3], double *regime, double fitted[])
{
    enum { LEAST_ROWS = 8, ROOMS = 7 };
    if (!contact || (n > 0 && (!P || !M || !sigma || !displacement || !Q || !fitted)) || !value ||
        !uncertainty || !told || !regime)
        return RWEDGE_ENULL;
    if (n < LEAST_ROWS || n > SIZE_MAX / ROOMS / sizeof *P)
        return RWEDGE_ERANGE;
    measured log = {contact, n, P, M, sigma, displacement, Q, 0, 0, NULL};
    if (!are_rows(&log))
        return RWEDGE_EDOMAIN;
    if (!find_sizes(&log))
        return RWEDGE_EABSENT;
    double *room = malloc(ROOMS * n * sizeof *room);
    if (!room)
        return RWEDGE_ENOMEM;
    log.work = room;
    trial fit = {.Q = room + n, .squares = HUGE_VAL};
    result r;
    const int32_t status = fit_to(&log, room + 2 * n, &fit, &r);
    if (status == RWEDGE_OK) {
        memcpy(value, r.value, sizeof r.value);
        memcpy(uncertainty, r.uncertainty, sizeof r.uncertainty);
        memcpy(told, r.told, sizeof r.told);
        memcpy(fitted, fit.Q, n * sizeof *fitted);
        *regime = r.regime;
    }
    free(room);
    return status;
}
