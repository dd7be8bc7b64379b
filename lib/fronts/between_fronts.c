/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is between the fronts where they are right: the traction of what sticks, and w' of what
 * slips. */
#include "base/domain.h"
#include "base/processor.h"
#include "fronts/fronts.h"

void rw_fronts_prepare(rw_fronts *f)
{
    for (size_t i = 0; i < f->count; i++)
        f->change[i] *= f->step[i] / f->X[i] / RW_PI;
}

/* sum += change/(s - x) over n points, none of them at x: a division for every two. */
RW_INLINE void sum_poles(size_t n, const double s[], const double change[], double x, double *sum)
{
    double part[RW_FRONT_LANES / 2] = {0};
    for (size_t i = 0; i < n; i += RW_FRONT_LANES)
        RW_EACH (k, RW_FRONT_LANES / 2) {
            const double d = s[i + k] - x, next = s[i + k + RW_FRONT_LANES / 2] - x;
            part[k] += (change[i + k] * next + change[i + k + RW_FRONT_LANES / 2] * d) / (d * next);
        }
    *sum += (part[0] + part[1]) + (part[2] + part[3]);
}

RW_DISPATCH(add_poles, sum_poles,
            (size_t n, const double s[], const double change[], double x, double *sum),
            (n, s, change, x, sum))

/* The same for the changes less a level times the steps, 0 where a point is at x. */
RW_INLINE void sum_level_poles(size_t n, const double s[], const double change[],
                               const double step[], double level, double x, double *sum)
{
    double part[RW_FRONT_LANES] = {0};
    for (size_t i = 0; i < n; i += RW_FRONT_LANES)
        for (size_t k = 0; k < RW_FRONT_LANES; k++) {
            const double d = s[i + k] - x;
            part[k] += (change[i + k] - level * step[i + k]) / (d == 0 ? HUGE_VAL : d);
        }
    for (size_t k = 0; k < RW_FRONT_LANES; k++)
        *sum += part[k];
}

RW_DISPATCH(add_level_poles, sum_level_poles,
            (size_t n, const double s[], const double change[], const double step[], double level,
             double x, double *sum),
            (n, s, change, step, level, x, sum))

double rw_fronts_transform(const rw_fronts *f, double x)
{
    double sum = 0;
    add_poles(f->count, f->x, f->change, x, &sum);
    return sum;
}

void rw_fronts_stick_traction(const rw_fronts *f, const rw_stuck *s, size_t n, const double x[],
                              double t[])
{
    double lack[RW_TERMS], X[RW_TERMS];
    rw_base_traction(f->problem, &f->layers, n, x, t);
    rw_fronts_lack(f, s, n, x, lack);
    rw_X_values(s, n, x, X);
    for (size_t i = 0; i < n; i++)
        t[i] += (rw_fronts_transform(f, x[i]) + lack[i]) * X[i];
}

/* The segments around x that follow one another without a gap; without points where there is
 * none. */
static rw_segment around(const rw_fronts *f, double x)
{
    rw_segment all = {.from = x, .to = x};
    for (int i = 0;
         i < f->segments && !(all.count > 0 && all.to > x && all.to < f->segment[i].from); i++) {
        const rw_segment s = f->segment[i];
        if (all.count == 0 || s.from > all.to)
            all = s;
        else {
            all.to = s.to;
            all.count += s.count;
        }
    }
    if (!(all.from < x && x < all.to))
        all.count = 0;
    return all;
}

void rw_fronts_slope(const rw_fronts *f, const rw_stuck *s, int label, size_t n, const double x[],
                     double slope[])
{
    double F[RW_TERMS], base[RW_TERMS], X[RW_TERMS];
    rw_X_values(s, n, x, X);
    rw_friction_after(f->problem, n, x, F);
    rw_base_traction(f->problem, &f->layers, n, x, base);
    for (size_t i = 0; i < n; i++) {
        const rw_segment here = around(f, x[i]);
        const size_t from = here.first, to = from + here.count;
        const double level = here.count > 0 ? (label * F[i] - base[i]) / X[i] / RW_PI : 0;
        double sum = level != 0 ? level * log((here.to - x[i]) / (x[i] - here.from)) : 0;
        add_poles(from, f->x, f->change, x[i], &sum);
        add_level_poles(here.count, f->x + from, f->change + from, f->step + from, level, x[i],
                        &sum);
        add_poles(f->count - to, f->x + to, f->change + to, x[i], &sum);
        slope[i] = X[i] * sum;
    }
}
