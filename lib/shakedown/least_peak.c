/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual stresses that stay after passes from far to far depend on the depth alone. Equilibrium
 * then leaves rho_xx(y) and rho_zz(y), which may be any functions. They move the first two parts of
 * the deviator by any constants, and never txy. So the least peak is the radius of the smallest
 * ball around the path with its centre on txy = 0: that of the path and its mirror image.
 *
 * The ball touches the path at few places. The square of the distance of the farthest place is a
 * convex function of the centre, made of one smooth function for each stretch of the path that
 * comes close to the ball. Newton's method finds its minimum. Where a step does not lower it, the
 * ball around all places seen so far gives the next centre: that is slow, but sure. */
#include "shakedown/least_peak.h"

#include "base/domain.h"
#include "base/linear.h"

enum { ACTIVE = 3, UNKNOWN = 2 + ACTIVE + 1 };

/* A top of the path, followed while the centre moves. The square of its distance from the centre,
 * and the derivatives of that by the centre. */
typedef struct {
    double t, length, step; /* step: the last one of t, in the length over which the path varies */
    double square, slope[2], bend[3]; /* bend: xx, xy, yy */
    double weight;                    /* 0: it does not touch */
} touch;

typedef struct {
    const rw_pass_path *path;
    double centre[2];
    int n;
    touch all[RW_TOPS];
} touches;

/* ---- The touching places from the present centre ---- */

typedef struct {
    rw_point at[3]; /* before, at and behind a place */
} stencil;

static const double SPACING = 2.5e-4; /* of a stencil, in the length over which the path varies */

/* The step to the top of the parabola, in the spacing of the stencil; limited where the place is
 * far from the top. */
static double step_to_top(double rise, double bend, bool *is_near)
{
    static const double LONGEST = 0.2 / SPACING;
    *is_near = bend < 0 && fabs(rise) < -LONGEST * bend;
    if (*is_near)
        return -rise / bend;
    return rise == 0 && bend == 0 ? 0 : copysign(LONGEST, rise);
}

/* Takes the derivatives at the top, if it is near, and moves the place to it. A corner of the path
 * stays. */
static void evaluate(const double centre[2], const stencil *around, touch *p)
{
    double square[3];
    bool is_near = false;
    for (int k = 0; k < 3; k++)
        square[k] = rw_square_from(centre, &around->at[k]);
    const double rise = (square[2] - square[0]) / 2, bend = square[2] - 2 * square[1] + square[0];
    const double step = p->length > 0 ? step_to_top(rise, bend, &is_near) : 0;
    p->square = square[1];
    for (int k = 0; k < 2; k++)
        p->slope[k] = -2 * (around->at[1].x[k] - centre[k]);
    p->bend[0] = p->bend[2] = 2;
    p->bend[1] = 0;
    p->step = SPACING * step;
    p->t += p->step * p->length;
    if (p->length == 0 || !is_near)
        return;
    const double turn[2] = {around->at[0].x[0] - around->at[2].x[0],
                            around->at[0].x[1] - around->at[2].x[1]}; /* of the slope, by t */
    p->square += rise * step / 2;
    p->slope[0] += turn[0] * step;
    p->slope[1] += turn[1] * step;
    p->bend[0] -= turn[0] * turn[0] / bend;
    p->bend[1] -= turn[0] * turn[1] / bend;
    p->bend[2] -= turn[1] * turn[1] / bend;
}

static void evaluate_all(touches *s)
{
    double x[3 * RW_TOPS];
    stencil around[RW_TOPS];
    for (int i = 0; i < s->n; i++) {
        s->all[i].length = rw_pass_length(s->path, s->all[i].t);
        for (int k = 0; k < 3; k++)
            x[3 * i + k] =
                rw_pass_place(s->path, s->all[i].t + (k - 1) * SPACING * s->all[i].length);
    }
    rw_pass_stresses(s->path->pass, s->path->y, (size_t)(3 * s->n), x, around[0].at);
    for (int i = 0; i < s->n; i++)
        evaluate(s->centre, &around[i], &s->all[i]);
}

/* ---- One step of the centre ---- */

typedef struct {
    int n, touch[ACTIVE];
    double weight[ACTIVE], step[2], square; /* square: of the radius after the step */
} newton_step;

/* The matrix of the weighted bends, the slopes, and the sum of the weights. */
static bool solve(const touches *s, newton_step *d)
{
    const int size = 3 + d->n;
    double A[UNKNOWN * UNKNOWN] = {0}, v[UNKNOWN] = {0}, sum = 0;
    for (int i = 0; i < s->n; i++)
        sum += s->all[i].weight;
    for (int i = 0; i < s->n; i++) {
        const double part = s->all[i].weight / sum;
        A[0] += part * s->all[i].bend[0];
        A[1] += part * s->all[i].bend[1];
        A[size + 1] += part * s->all[i].bend[2];
    }
    A[size] = A[1];
    for (int i = 0; i < d->n; i++) {
        const touch *p = &s->all[d->touch[i]];
        for (int k = 0; k < 2; k++)
            A[k * size + 2 + i] = A[(2 + i) * size + k] = p->slope[k];
        A[(2 + i) * size + size - 1] = -1;
        v[2 + i] = -p->square;
        A[(size - 1) * size + 2 + i] = 1;
    }
    v[size - 1] = 1;
    if (!rw_solve((size_t)size, 1, A, v))
        return false;
    d->step[0] = v[0];
    d->step[1] = v[1];
    for (int i = 0; i < d->n; i++)
        d->weight[i] = v[2 + i];
    d->square = v[size - 1];
    return true;
}

static int lightest(const newton_step *d)
{
    int best = 0;
    for (int i = 1; i < d->n; i++)
        best = d->weight[i] < d->weight[best] ? i : best;
    return best;
}

static bool has(const newton_step *d, int which)
{
    for (int i = 0; i < d->n; i++)
        if (d->touch[i] == which)
            return true;
    return false;
}

/* The touch that is farthest outside after the step; -1 where none is. */
static int outside(const touches *s, const newton_step *d)
{
    static const double TOLERANCE = 1e-12;
    int worst = -1;
    double most = d->square * (1 + TOLERANCE);
    for (int i = 0; i < s->n; i++) {
        const touch *p = &s->all[i];
        const double square = p->square + p->slope[0] * d->step[0] + p->slope[1] * d->step[1];
        if (!has(d, i) && square > most) {
            most = square;
            worst = i;
        }
    }
    return worst;
}

/* Takes one more touch for that which then has no weight. */
static bool replace_one(const touches *s, newton_step *d, int more)
{
    for (int i = 0; i < ACTIVE; i++) {
        newton_step other = *d;
        other.touch[i] = more;
        if (solve(s, &other) && other.weight[lightest(&other)] >= 0) {
            *d = other;
            return true;
        }
    }
    return false;
}

/* The touches on the ball after the step: those of negative weight leave, those outside come. False
 * where this does not end. */
static bool choose(const touches *s, newton_step *d)
{
    for (int round = 0; round < 3 * RW_TOPS; round++) {
        const bool is_regular = solve(s, d);
        const int light = is_regular ? lightest(d) : d->n - 1;
        if (!is_regular || d->weight[light] < 0) {
            if (d->n == 1)
                return false;
            d->touch[light] = d->touch[--d->n];
            continue;
        }
        const int more = outside(s, d);
        if (more < 0)
            return true;
        if (d->n < ACTIVE)
            d->touch[d->n++] = more;
        else if (!replace_one(s, d, more))
            return false;
    }
    return false;
}

/* Newton's step. */
static bool step_centre(touches *s, newton_step *d)
{
    d->n = 0;
    for (int i = 0; i < s->n; i++)
        if (s->all[i].weight > 0 && d->n < ACTIVE)
            d->touch[d->n++] = i;
    if (!choose(s, d))
        return false;
    for (int i = 0; i < s->n; i++)
        s->all[i].weight = 0;
    for (int i = 0; i < d->n; i++)
        s->all[d->touch[i]].weight = d->weight[i];
    for (int k = 0; k < 2; k++)
        s->centre[k] += d->step[k];
    return true;
}

/* Newton's method from some tops. False where it does not converge. */
static bool converge(touches *s, double *square)
{
    enum { STEPS = 8 };
    static const double MOVED = 1e-5, STEP = 1e-7;
    for (int i = 0; i < STEPS; i++) {
        newton_step d;
        double moved = 0;
        evaluate_all(s);
        if (!step_centre(s, &d))
            return false;
        for (int k = 0; k < d.n; k++)
            moved = fmax(moved, fabs(s->all[d.touch[k]].step));
        *square = d.square;
        const double step = d.step[0] * d.step[0] + d.step[1] * d.step[1];
        if (moved < MOVED && step < STEP * STEP * d.square)
            return true;
    }
    return false;
}

/* ---- The ball ---- */

enum { SEEN = 64, ROUNDS = 60 };

typedef struct {
    const rw_pass_path *path;
    double centre[2], least; /* least: no ball has a smaller squared radius; without Newton */
    touches last;            /* with the weights at the end */
    size_t seen;
    rw_point points[SEEN]; /* of the path, at these places */
    double t[SEEN];
} search;

static void see(search *s, double t, const rw_point *point)
{
    if (s->seen == SEEN)
        return;
    s->t[s->seen] = t;
    s->points[s->seen++] = *point;
}

/* The ball around all places that were seen. */
static void go_to_ball(search *s)
{
    const rw_ball ball = rw_smallest_mirrored_ball(s->seen, s->points);
    for (int k = 0; k < 2; k++)
        s->last.centre[k] = ball.centre.x[k];
    s->last.n = ball.count;
    for (int i = 0; i < ball.count; i++)
        s->last.all[i] = (touch){.t = s->t[ball.support[i]], .weight = ball.weight[i]};
    s->least = ball.radius * ball.radius;
}

/* A place that was seen and is higher than all tops is beside one that the grid hides. */
static int add_farthest_seen(const search *s, int n, double highest, rw_top tops[])
{
    rw_top farthest = {.square = 0};
    for (size_t i = 0; i < s->seen; i++) {
        const double square = rw_square_from(s->centre, &s->points[i]);
        if (square > farthest.square)
            farthest = (rw_top){s->t[i], s->points[i], square};
    }
    static const double HIGHER = 1e-13;
    if (n == RW_TOPS || (n > 0 && farthest.square <= highest * (1 + HIGHER)))
        return n;
    tops[n] = farthest;
    return n + 1;
}

/* The tops that are nearly as high as the highest may be on the ball. */
static touches touches_at(const search *s, int n, const rw_top tops[], double highest)
{
    static const double NEARLY = 1e-2;
    touches all = {.path = s->path, .centre = {s->centre[0], s->centre[1]}, .n = n};
    for (int i = 0; i < n; i++)
        all.all[i] = (touch){.t = tops[i].t, .weight = tops[i].square >= (1 - NEARLY) * highest};
    return all;
}

/* The square of the radius. Each round begins with all tops as the present centre has them: the
 * highest is an upper bound. The next centre is Newton's, unless the bound has not come down. */
static double settle(search *s)
{
    static const double GAP = 1e-12, LOWER = 0.95;
    double best = HUGE_VAL, square = s->least, highest = 0;
    for (int round = 0; round < ROUNDS; round++) {
        rw_top tops[RW_TOPS];
        int n = rw_tops(s->path, s->centre, LOWER * fmin(square, best), tops);
        highest = 0;
        for (int i = 0; i < n; i++) {
            highest = fmax(highest, tops[i].square);
            see(s, tops[i].t, &tops[i].point);
        }
        n = add_farthest_seen(s, n, highest, tops);
        highest = fmax(highest, tops[n - 1].square);
        if (round > 0 && fabs(highest - square) <= GAP * square)
            return highest;
        const bool is_better = highest < best;
        best = fmin(best, highest);
        s->last = touches_at(s, n, tops, highest);
        if (!is_better || !converge(&s->last, &square)) {
            go_to_ball(s);
            square = s->least;
        }
        s->centre[0] = s->last.centre[0];
        s->centre[1] = s->last.centre[1];
    }
    return highest;
}

/* By how much the peak grows with the depth: each touching place counts by its weight. */
static double slope_of(const touches *s, double square)
{
    static const double STEP = 1. / 8192;
    double x[RW_TOPS], change = 0;
    rw_point at[RW_TOPS];
    for (int i = 0; i < s->n; i++)
        x[i] = rw_pass_place(s->path, s->all[i].t);
    for (int side = -1; side <= 1; side += 2) {
        rw_pass_stresses(s->path->pass, s->path->y * (1 + side * STEP), (size_t)s->n, x, at);
        for (int i = 0; i < s->n; i++)
            change += side * s->all[i].weight * rw_square_from(s->centre, &at[i]);
    }
    return change / (4 * STEP * sqrt(square));
}

double rw_least_peak_coarse(const rw_pass *pass, double y)
{
    rw_pass_path path;
    rw_pass_sample(&path, pass, y, 0.5);
    return rw_smallest_mirrored_ball(path.n, path.path).radius;
}

static rw_least_peak result(const touches *s, double square)
{
    rw_least_peak peak = {.peak = sqrt(square), .centre = {s->centre[0], s->centre[1]}, .n = s->n};
    for (int i = 0; i < s->n; i++) {
        peak.t[i] = s->all[i].t;
        peak.weight[i] = s->all[i].weight;
    }
    if (s->path->y > 0)
        peak.slope = slope_of(s, square);
    return peak;
}

rw_least_peak rw_least_peak_at(const rw_pass *pass, double y, double step)
{
    rw_pass_path path;
    rw_pass_sample(&path, pass, y, step);
    const rw_ball ball = rw_smallest_mirrored_ball(path.n, path.path);
    search s = {.path = &path,
                .centre = {ball.centre.x[0], ball.centre.x[1]},
                .least = ball.radius * ball.radius};
    for (int i = 0; i < ball.count; i++)
        see(&s, path.t[ball.support[i]], &path.path[ball.support[i]]);
    const double square = settle(&s);
    return result(&s.last, square);
}

bool rw_least_peak_follows(const rw_least_peak *from, const rw_pass *pass, double y,
                           rw_least_peak *peak)
{
    rw_pass_path path;
    double square;
    rw_pass_path_at(&path, pass, y);
    touches s = {.path = &path, .centre = {from->centre[0], from->centre[1]}, .n = from->n};
    for (int i = 0; i < s.n; i++)
        s.all[i] = (touch){.t = from->t[i], .weight = from->weight[i]};
    if (!converge(&s, &square))
        return false;
    *peak = result(&s, square);
    return true;
}

double rw_least_peak_checked(const rw_least_peak *known, const rw_pass *pass, double y, double step)
{
    rw_pass_path path;
    rw_top tops[RW_TOPS];
    const double square = known->peak * known->peak;
    rw_pass_sample(&path, pass, y, step);
    const int n = rw_tops(&path, known->centre, square, tops);
    double highest = square;
    for (int i = 0; i < n; i++)
        highest = fmax(highest, tops[i].square);
    return sqrt(highest);
}
