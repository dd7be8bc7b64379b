/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include <math.h>

/* ---- The results ---- */

static int32_t judge(const series *all, test_run *run, int criterion, worst_verdict *its)
{
    return worst_verdict_of(&run->last, &all->below,
                            &run->worst[measure_column(criterion, PART_VALUE)], criterion, its);
}

bool test_judge(const series *all, test_run *run, complaint *why)
{
    const int of_lives = series_of_lives(all);
    run->results.damage = run->results.life = NAN;
    for (int i = 0; i < DAMAGE; i++) {
        if (!criterion_exists(i) || !series_shows(all, i))
            continue;
        const worst_row *row = &run->worst[measure_column(i, PART_VALUE)];
        test_criterion *to = &run->results.criterion[i];
        worst_verdict its;
        *to = (test_criterion){row->value, row->x, NAN, NAN};
        if (isnan(row->value))
            continue;
        const int32_t status = judge(all, run, i, &its);
        if (status != RWEDGE_OK)
            return complain(why, "the worst place of %s: %s", criterion_name(i),
                            rwedge_strerror(status));
        to->at_length = its.is_below ? its.judged.value : NAN;
        to->load_factor = its.load_factor;
        if (i == of_lives) {
            run->results.life = its.judged.life;
            run->results.damage = measured_part(&its.at, i + DAMAGE, PART_VALUE);
        }
    }
    return true;
}

/* ---- Scatter ---- */

static bool counts(const test_run *run, bool is_of_lives)
{
    return run->is_run && (!is_of_lives || (!isnan(run->test.tested) && !run->test.is_run_out));
}

/* The first that is told of, as it is asked for or by itself; DAMAGE for none. */
static int first_shown(const series *all, bool is_asked_for)
{
    int i = 0;
    while (i < DAMAGE && !(criterion_exists(i) && series_shows(all, i) &&
                           (!is_asked_for || all->asked.is_wanted[i])))
        i++;
    return i;
}

int series_leading(const series *all, size_t n, const test_run run[], bool *is_of_lives)
{
    const int of_lives = series_of_lives(all), wanted = first_shown(all, true);
    size_t tested = 0;
    for (size_t i = 0; i < n; i++)
        tested += counts(&run[i], true) ? 1 : 0;
    *is_of_lives = of_lives != NO_CRITERION && tested > 1;
    return *is_of_lives ? of_lives : wanted < DAMAGE ? wanted : first_shown(all, false);
}

/* What a test counts with: the logarithm of tested over predicted, or the criterion over what it
 * must not exceed, where that is known. NAN where it counts not. */
static double share_of(const series *all, const test_run *run, int criterion, bool is_of_lives)
{
    const worst_row *row = &run->worst[measure_column(criterion, PART_VALUE)];
    worst_verdict its;
    if (isnan(row->value) ||
        worst_verdict_of(&run->last, &all->below, row, criterion, &its) != RWEDGE_OK)
        return NAN;
    const criterion_verdict *judged = &its.judged;
    if (is_of_lives)
        return log10(run->test.tested / judged->life);
    return isnan(judged->allowable) ? judged->value : judged->value / judged->allowable;
}

double series_scatter(const series *all, size_t n, const test_run run[], double length)
{
    series at = *all;
    bool is_of_lives;
    double sum = 0, squares = 0, count = 0;
    const int criterion = series_leading(all, n, run, &is_of_lives);
    at.below.length = length;
    for (size_t i = 0; i < n; i++) {
        if (!counts(&run[i], is_of_lives))
            continue;
        const double share = share_of(&at, &run[i], criterion, is_of_lives);
        const double further = share - (count > 0 ? sum / count : 0);
        count++;
        sum += share;
        squares += further * (share - sum / count); /* about the mean so far: no digits are lost */
    }
    const double deviation = sqrt(squares / (count - 1));
    return count < 2 || !isfinite(deviation) ? NAN
           : is_of_lives                     ? deviation
                                             : deviation / (sum / count);
}

/* ---- The length ---- */

/* Lengths, each longer by this factor; then the golden section, to this part of the length. */
enum { LENGTHS = 32 };
static const double FACTOR = 1.25, NEAREST = 1e-6;

/* Where a test has no value there is no length. */
static double scatter_at(const series *all, size_t n, const test_run run[], double log_length)
{
    const double scatter = series_scatter(all, n, run, exp(log_length));
    return isnan(scatter) ? HUGE_VAL : scatter;
}

/* The least between two lengths that enclose a smaller one; logarithms. */
static double golden_section(const series *all, size_t n, const test_run run[], double lo,
                             double hi)
{
    const double golden = (sqrt(5) - 1) / 2;
    double left = hi - golden * (hi - lo), right = lo + golden * (hi - lo);
    double at_left = scatter_at(all, n, run, left), at_right = scatter_at(all, n, run, right);
    while (hi - lo > NEAREST)
        if (at_left <= at_right) {
            hi = right;
            right = left;
            at_right = at_left;
            left = hi - golden * (hi - lo);
            at_left = scatter_at(all, n, run, left);
        } else {
            lo = left;
            left = right;
            at_left = at_right;
            right = lo + golden * (hi - lo);
            at_right = scatter_at(all, n, run, right);
        }
    return lo / 2 + hi / 2;
}

double series_fit_length(const series *all, size_t n, const test_run run[], complaint *why)
{
    double largest = 0, least = series_scatter(all, n, run, NAN), first;
    int best = -1; /* the surface */
    if (isnan(least)) {
        complain(why, "two tests with a value are needed at least");
        return NAN;
    }
    for (size_t i = 0; i < n; i++)
        if (run[i].is_run)
            largest = fmax(largest, (run[i].results.right - run[i].results.left) / 2);
    first = log(largest) - (LENGTHS - 1) * log(FACTOR);
    for (int k = 0; k < LENGTHS; k++) {
        const double scatter = scatter_at(all, n, run, first + k * log(FACTOR));
        if (scatter < least)
            least = scatter, best = k;
    }
    if (best < 0 || best == LENGTHS - 1) {
        complain(why, "the scatter is least at %s",
                 best < 0 ? "the surface" : "the largest half-width of a contact, or beyond");
        return NAN;
    }
    return exp(golden_section(all, n, run, first + (best - 1) * log(FACTOR),
                              first + (best + 1) * log(FACTOR)));
}
