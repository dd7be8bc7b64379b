/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "probe.hpp"

#include <float.h>
#include <math.h>

enum { FIRST_BITS = 128, MOST_BITS = 1 << 14, MOST_DRAWS = 1000 };

/* What the radius of the reference may add to a figure: a ten-thousandth of epsilon, or of the
 * figure. */
const double NEGLIGIBLE = 1e-4;

/* Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014:
 * splitmix64. */
static uint64_t mixed(uint64_t v)
{
    v = (v ^ (v >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    v = (v ^ (v >> 27)) * UINT64_C(0x94d049bb133111eb);
    return v ^ (v >> 31);
}

double uniform(probe *call)
{
    call->random += UINT64_C(0x9e3779b97f4a7c15);
    return ldexp((double)(mixed(call->random) >> 11), -53);
}

double between(probe *call, double lo, double hi)
{
    return lo + (hi - lo) * uniform(call);
}

double log_between(probe *call, double lo, double hi)
{
    return exp(between(call, log(lo), log(hi)));
}

bool chance(probe *call, double probability)
{
    return uniform(call) < probability;
}

double either_sign(probe *call, double value)
{
    return chance(call, 0.5) ? value : -value;
}

/* ---- Results ---- */

bool gives(probe *call, double value)
{
    call->result[0] = value;
    return true;
}

bool gives(probe *call, int32_t status)
{
    return status == 0 || gives(call, NAN);
}

/* ---- Arguments ---- */

double argument(probe *call, const char *name, double value)
{
    if (call->arguments < ARGUMENTS_MAX) {
        call->name[call->arguments] = name;
        call->value[call->arguments++] = value;
    }
    return value;
}

double near(probe *call, double mark)
{
    return mark + either_sign(call, mark * log_between(call, 1e-17, 1));
}

double some_rounded_alpha(probe *call)
{
    const double kind = uniform(call);
    if (kind < 0.3)
        return log_between(call, 1e-8, 1);
    if (kind < 0.5)
        return 1 - uniform(call);
    if (kind < 0.7)
        return 1 - log_between(call, 1e-16, 1);
    if (kind < 0.75)
        return near(call, 1);
    if (kind < 0.85)
        return log_between(call, 1, 100);
    if (kind < 0.93)
        return log_between(call, 1e-20, 1e-6);
    if (kind < 0.95)
        return log_between(call, 1e-60, 1e-20);
    if (kind < 0.97)
        return log_between(call, 1, 1e60);
    static const double EXACT[] = {
        1, 1 - DBL_EPSILON / 2, 1 + DBL_EPSILON, 0.5, 0.1, 1e-8, 0.7071067811865476, 2};
    return EXACT[(int)(8 * uniform(call))];
}

double some_alpha(probe *call)
{
    return chance(call, 0.01) ? 0 : some_rounded_alpha(call);
}

/* The domain begins at 1e-60. */
static double none_if_tiny(double v)
{
    return fabs(v) < 1e-60 ? 0 : v;
}

double some_fraction(probe *call, double mark)
{
    const double kind = uniform(call);
    double v = kind < 0.3    ? uniform(call)
               : kind < 0.45 ? log_between(call, 1e-16, 1)
               : kind < 0.5  ? log_between(call, 1e-60, 1)
               : kind < 0.75 ? 1 - log_between(call, 1e-16, 1)
               : kind < 0.95 ? near(call, mark)
               : kind < 0.97 ? 0
               : kind < 0.98 ? mark
                             : 1;
    return none_if_tiny(fmax(0, fmin(1, v)));
}

double some_c(probe *call)
{
    return some_fraction(call, fmin(call->value[0], 1));
}

/* One of the marks of the surface. */
static double some_mark(probe *call, double alpha, double c)
{
    const double kind = uniform(call);
    return kind < 0.3 ? fmin(alpha, 1) : kind < 0.5 ? c : 1;
}

double some_place(probe *call, double alpha, double c)
{
    const double kind = uniform(call);
    double x = kind < 0.25   ? uniform(call)
               : kind < 0.4  ? fmin(alpha, 1) * uniform(call)
               : kind < 0.5  ? log_between(call, 1e-17, 1)
               : kind < 0.55 ? log_between(call, 1, 1e4)
               : kind < 0.56 ? 0
               : kind < 0.6  ? some_mark(call, alpha, c)
                             : near(call, some_mark(call, alpha, c));
    return none_if_tiny(either_sign(call, x));
}

void some_point(probe *call)
{
    const double alpha = call->value[0], c = call->value[2];
    double x, y;
    const double kind = uniform(call);
    if (kind < 0.2) { /* next to the contact */
        x = between(call, -1.5, 1.5);
        y = between(call, 0, 1.5);
    } else if (kind < 0.35) { /* the surface */
        x = some_place(call, alpha, c);
        y = 0;
    } else if (kind < 0.5) { /* next to the surface */
        x = some_place(call, alpha, c);
        y = log_between(call, 1e-18, 1);
    } else if (kind < 0.6) { /* the far field */
        const double r = log_between(call, 1, chance(call, 0.02) ? 1e60 : 1e4),
                     angle = between(call, 0, 3.14159);
        x = r * cos(angle);
        y = r * sin(angle);
    } else { /* around a mark, at every scale */
        const double mark = chance(call, 0.3) ? 0 : either_sign(call, some_mark(call, alpha, c));
        const double least = mark == 0 && chance(call, 0.1) ? 1e-60 : 1e-17;
        const double r =
            log_between(call, least, 2) * (mark == 0 && chance(call, 0.5) ? fmin(alpha, 1) : 1);
        const double angle = between(call, 0, 3.14159);
        x = mark + r * cos(angle);
        y = r * sin(angle);
    }
    x = none_if_tiny(x);
    y = none_if_tiny(y);
    argument(call, "x", x);
    argument(call, "y", y);
}

double some_friction(probe *call)
{
    const double kind = uniform(call);
    return kind < 0.1    ? 0
           : kind < 0.7  ? uniform(call)
           : kind < 0.85 ? log_between(call, 1e-12, 1)
                         : log_between(call, 0.1, 1e6);
}

double some_poisson(probe *call)
{
    const double kind = uniform(call);
    return kind < 0.6    ? between(call, 0, 0.5)
           : kind < 0.8  ? 0.3
           : kind < 0.85 ? 0
           : kind < 0.9  ? 0.5
                         : 0.5 - log_between(call, 1e-16, 0.5);
}

/* ---- Errors ---- */

ball error_over(double result, const ball &exact, const ball &scale)
{
    const ball difference = result - exact;
    return is_zero(difference) ? 0 : abs(difference / scale);
}

ball error_over(const double result[3], const tensor &exact, const ball &scale)
{
    return max(max(error_over(result[0], exact.xx, scale), error_over(result[1], exact.yy, scale)),
               error_over(result[2], exact.xy, scale));
}

ball relative_error(double result, const ball &exact)
{
    return error_over(result, exact, exact);
}

std::function<ball(const probe &)> relative_to(ball (*exact)(const double *v))
{
    return [=](const probe &call) { return relative_error(call.result[0], exact(call.value)); };
}

std::function<ball(const probe &)> over(ball (*scale)(const double *v),
                                        ball (*exact)(const double *v))
{
    return [=](const probe &call) {
        return error_over(call.result[0], exact(call.value), scale(call.value));
    };
}

static bool is_told(const ball &error)
{
    return is_finite(error) && radius(error) <= NEGLIGIBLE * fmax(DBL_EPSILON, fabs(middle(error)));
}

static bool is_refused(const probe *call)
{
    for (int i = 0; i < RESULTS_MAX; i++)
        if (isnan(call->result[i]))
            return true;
    return false;
}

double probe_error(const row *claim, uint64_t seed, uint64_t index, probe *call)
{
    *call = {};
    call->random = mixed(mixed(seed) + index);
    for (const char *c = claim->function; *c; c++)
        call->random = mixed(call->random + (unsigned char)*c);
    for (int draws = 1; !claim->draw(call); draws++) {
        if (draws == MOST_DRAWS)
            return HUGE_VAL;
        const uint64_t random = call->random;
        *call = {};
        call->random = random;
    }
    if (is_refused(call))
        return HUGE_VAL;
    for (slong wanted = FIRST_BITS; wanted <= MOST_BITS; wanted *= 2) {
        const precision here(wanted);
        const ball error = claim->judge(*call);
        if (is_told(error))
            return fmax(0, upper_bound(error));
    }
    return HUGE_VAL;
}
