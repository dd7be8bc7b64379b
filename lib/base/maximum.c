/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brent's minimiser of GSL, for the negative of a function. root.c says why no call of GSL may fail
 * here, and the solver is on the stack. The bracket is proved before GSL sees it: its middle is
 * higher than both ends. */
#include "base/maximum.h"

#include "base/always.h"
#include "base/domain.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

void rw_spread_places(double left, double right, double place[RW_SPREAD])
{
    enum { LAST = RW_SPREAD - 1, STEPS = LAST / 2 };
    const double middle = (left + right) / 2, half = (right - left) / 2;
    for (int i = 1; i < LAST; i++)
        place[i] = middle + half * sin(RW_HALF_PI * (i - STEPS) / STEPS);
    place[0] = left;
    place[LAST] = right;
}

/* ---- One top ---- */

/* Brent's method takes about ten steps to a smooth top, and 40 to a sharp one. A step cannot be
 * less than 1.5e-8 of t. */
enum { MAX_STEPS = 100 };
static const double NEAREST_OF_T = 4e-8;

/* After these steps the gain still to come is less than the gain so far. */
enum { TRIAL = 12 };

/* GSL's steps are relative to the variable. So it is t, 0 to 1 from the first place to the last. */
typedef struct {
    rw_function f;
    const void *context;
    double from, length, nearest;
    rw_maximum best; /* so far */
} search;

typedef struct {
    double t, value;
} point;

/* GSL's handler would be told of a value that is not finite. */
static double value_at(search *s, double t)
{
    const double x = s->from + t * s->length, value = s->f(x, s->context);
    if (!isfinite(value))
        return 0;
    if (value > s->best.value)
        s->best = (rw_maximum){x, value};
    return value;
}

static double negative(double t, void *of_search)
{
    return -value_at(of_search, t);
}

/* Whether an end is lower than the middle, and apart from it. */
static bool is_below(const point *end, const point *middle)
{
    return end->t != middle->t && end->value < middle->value;
}

/* Looks half-way to an end that is as high as the middle, or opposite to one that is no end: there
 * is a higher middle, or the end comes nearer. */
static void draw_in(search *s, point at[3], int end)
{
    const double t = at[1].t + (at[end].t - at[1].t) / 2;
    const point between = {t, value_at(s, t)};
    if (between.value > at[1].value) {
        at[2 - end] = at[1];
        at[1] = between;
    } else {
        at[end] = between;
    }
}

/* Whether the middle could be made higher than both ends. Where it could not, it is the top itself,
 * or one of a level. */
static bool enclose(search *s, point at[3])
{
    for (double span = 1; span > s->nearest; span /= 2) {
        if (is_below(&at[0], &at[1]) && is_below(&at[2], &at[1]))
            return true;
        for (int end = 0; end <= 2; end += 2)
            if (at[end].t != at[1].t && !(is_below(&at[end], &at[1]) && at[2 - end].t != at[1].t))
                draw_in(s, at, end);
    }
    return false;
}

static bool is_given_up(const search *s, int step, double first, double highest)
{
    return step >= TRIAL && s->best.value + (s->best.value - first) < highest;
}

static void approach(search *s, const point at[3], double highest)
{
    const double first = s->best.value;
    gsl_function function = {negative, s};
    /* Brent's state is 6 doubles; a GSL that needs more is refused, and the state not overrun */
    double state[32];
    if (NEVER(gsl_min_fminimizer_brent->size > sizeof state)) /* in no GSL up to 2.8 */
        return;
    gsl_min_fminimizer solver = {.type = gsl_min_fminimizer_brent, .state = state};
    int status = gsl_min_fminimizer_set_with_values(&solver, &function, at[1].t, -at[1].value,
                                                    at[0].t, -at[0].value, at[2].t, -at[2].value);
    for (int step = 0; step < MAX_STEPS && !is_given_up(s, step, first, highest); step++) {
        if (NEVER(status != GSL_SUCCESS)) /* enclosed, and the function is finite */
            return;
        if (solver.x_upper - solver.x_lower < s->nearest + NEAREST_OF_T * solver.x_lower)
            return;
        status = gsl_min_fminimizer_iterate(&solver);
    }
}

/* The top of a function around a place. `at` are three places in ascending order with the values
 * there; the middle one is the highest, or as high as another, and may be the first or the last
 * place too. A top that will not reach the value `highest` is given up. */
static rw_maximum top_of(rw_function f, const void *context, const rw_maximum at[3], double highest)
{
    static const double NEAREST = 1e-8; /* of the distance of the places */
    const double length = at[2].x - at[0].x;
    search s = {f, context, at[0].x, length, NEAREST, at[1]};
    if (length == 0)
        return at[1];
    point around[3];
    for (int i = 0; i < 3; i++)
        around[i] = (point){(at[i].x - at[0].x) / length, at[i].value};
    if (around[1].t >= 0 && around[1].t <= 1 && enclose(&s, around))
        approach(&s, around, highest);
    return s.best;
}

/* ---- The highest of many ---- */

static bool is_top(size_t n, const double value[], size_t i)
{
    return (i == 0 || value[i] > value[i - 1]) && (i + 1 == n || value[i] >= value[i + 1]);
}

static size_t highest_of(size_t n, const double value[])
{
    size_t highest = 0;
    for (size_t i = 1; i < n; i++)
        highest = value[i] > value[highest] ? i : highest;
    return highest;
}

static rw_maximum top_around(rw_function f, const void *context, size_t n, const double place[],
                             const double value[], size_t i, double highest)
{
    const size_t before = i > 0 ? i - 1 : i, after = i + 1 < n ? i + 1 : i;
    const rw_maximum at[3] = {
        {place[before], value[before]}, {place[i], value[i]}, {place[after], value[after]}};
    return top_of(f, context, at, highest);
}

rw_maximum rw_largest_around(rw_function f, const void *context, size_t n, const double place[],
                             const double value[])
{
    static const double NEARLY = 0.97; /* such a part of the largest one is looked at */
    enum { SEARCHES = 8 };             /* enough for tops; ripples have more */
    const size_t first = highest_of(n, value);
    const double nearly = NEARLY * value[first];
    if (value[first] == 0)
        return (rw_maximum){place[first], 0};
    rw_maximum best = top_around(f, context, n, place, value, first, value[first]);
    for (size_t i = 0, searches = 1; i < n && searches < SEARCHES; i++) {
        if (i == first || value[i] < nearly || !is_top(n, value, i))
            continue;
        searches++;
        const rw_maximum top = top_around(f, context, n, place, value, i, best.value);
        best = top.value > best.value ? top : best;
    }
    return best;
}

rw_maximum rw_largest_value(rw_function f, const void *context, size_t n, const double place[],
                            double value[])
{
    for (size_t i = 0; i < n; i++) {
        value[i] = f(place[i], context);
        if (!isfinite(value[i]))
            value[i] = 0;
    }
    return rw_largest_around(f, context, n, place, value);
}
