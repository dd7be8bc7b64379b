/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lives from criteria, by the curves of Basquin, Coffin and Manson. Over the logarithm of the
 * number of reversals the logarithm of such a curve falls. Its slope lies between those of the two
 * powers. */
#include "life/life.h"

#include "base/always.h"
#include "base/domain.h"
#include "measures/catalogue.h"

/* A bound on logarithms: exp() of minus this is negligible, but does not underflow, which would set
 * errno. */
static const double NEGLIGIBLE = 700;

/* u = log(2 N) for a logarithm of the value, and the derivative of u. Newton's steps begin where
 * the larger power alone has the value. The sum of both is convex over u: so they go one way, and
 * never beyond. */
static double reversals_of(const rw_life_curve *c, double wanted, double *rate)
{
    enum { STEPS = 64 }; /* 10 are taken at the most */
    static const double LAST = 1e-9;
    const double *height = c->height, *slope = c->slope;
    double u = fmax((wanted - height[0]) / slope[0], (wanted - height[1]) / slope[1]);
    for (int i = 0; ALWAYS(i < STEPS); i++) {
        const double first = height[0] + slope[0] * u, second = height[1] + slope[1] * u;
        const int larger = second > first;
        const double ratio = exp(-fmin(fabs(first - second), NEGLIGIBLE));
        *rate = (1 + ratio) / (slope[larger] + ratio * slope[1 - larger]);
        const double step = (wanted - fmax(first, second) - log1p(ratio)) * *rate;
        u += step;
        if (step < LAST)
            break;
    }
    return u;
}

static double cycles_of(double u)
{
    const double cycles = u > log(4 * RW_LARGEST) ? HUGE_VAL : exp(fmax(u, -NEGLIGIBLE)) / 2;
    return cycles > RW_LARGEST ? HUGE_VAL : cycles >= RW_SMALLEST ? cycles : NAN;
}

static bool is_run_out(const rw_life_curve *curve, double value)
{
    return value == 0 || value < curve->limit;
}

double rw_life(const rw_life_curve *curve, double value)
{
    double rate;
    return is_run_out(curve, value) ? HUGE_VAL : cycles_of(reversals_of(curve, log(value), &rate));
}

/* ---- By a table ---- */

/* Lines of the table for each unit of the logarithm of the value. */
static const double DENSITY = 64;

void rw_life_table_begin(const rw_life_curve *curve, rw_life_table *table)
{
    table->curve = curve;
    for (size_t i = 0; i < RW_LIFE_LINES; i++)
        table->line[i].place = NAN;
}

static const rw_life_line *line_at(rw_life_table *table, double place)
{
    rw_life_line *line = &table->line[(size_t)(int64_t)place % RW_LIFE_LINES];
    if (line->place != place) {
        line->u = reversals_of(table->curve, place / DENSITY, &line->rate);
        line->rate /= DENSITY;
        line->place = place;
    }
    return line;
}

/* Interpolates between two lines with their u and their rates. */
double rw_life_by_table(rw_life_table *table, double value)
{
    if (is_run_out(table->curve, value))
        return HUGE_VAL;
    const double place = DENSITY * log(value), below = floor(place), t = place - below;
    const rw_life_line *from = line_at(table, below), *to = line_at(table, below + 1);
    const double rise = to->u - from->u,
                 bend = (1 - t) * (from->rate - rise) - t * (to->rate - rise);
    return cycles_of(from->u + t * (rise + (1 - t) * bend));
}

/* ---- The curves ---- */

static rw_life_curve swt_curve(double E, const double c[])
{
    const double sf = c[0], b = c[1], ef = c[2], exponent = c[3];
    return (rw_life_curve){{log(sf * sf / E), log(sf * ef)}, {2 * b, b + exponent}, c[4]};
}

static rw_life_curve fatemi_socie_curve(const double c[])
{
    const double G = c[0], tf = c[1], b0 = c[2], gf = c[3], c0 = c[4];
    return (rw_life_curve){{log(tf / G), log(gf)}, {b0, c0}, c[5]};
}

bool rw_life_curve_of(int32_t criterion, const double constants[], rw_life_curve *curve)
{
    const rw_measure *measure = rw_measure_of(criterion);
    const int count = rwedge_damage_constants(criterion);
    if (count == 0 || !rw_are_constants(measure, count, constants))
        return false;
    const double *own = constants + measure->own;
    *curve =
        criterion == RWEDGE_MEASURE_SWT ? swt_curve(constants[0], own) : fatemi_socie_curve(own);
    return true;
}

double rwedge_life(int32_t criterion, const double constants[], double parameter)
{
    rw_life_curve curve;
    if (!constants || !rw_is_magnitude(parameter) ||
        !rw_life_curve_of(criterion, constants, &curve))
        return NAN;
    return rw_life(&curve, parameter);
}
