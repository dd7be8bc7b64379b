/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One call of one function at random arguments, and the error of its result. A row of the report
 * draws a call and judges it. The judge computes the error in balls: the exact error is within the
 * ball that it returns. It is asked again with more bits until the reference adds nothing to the
 * figure. */
#ifndef PROBE_HPP
#define PROBE_HPP

#include <stdint.h>

#include <functional>
#include <tuple>
#include <vector>

#include "references/field.hpp"

enum { ARGUMENTS_MAX = 12, RESULTS_MAX = 9, LOADS_MAX = 12 };

struct probe {
    uint64_t random; /* state of the random numbers */
    int arguments;   /* how many were drawn, with their names and values */
    const char *name[ARGUMENTS_MAX];
    double value[ARGUMENTS_MAX];
    int loads; /* of a history */
    double P[LOADS_MAX], Q[LOADS_MAX];
    double result[RESULTS_MAX]; /* of the library; NaN where it refused what is in the domain */
};

struct row {
    const char *function, *domain;
    const char *measure; /* what the error is relative to */
    double promised;     /* bound of the error in that measure */
    const char *promise; /* as the header says it; in parentheses where it says nothing */
    double part;         /* of the calls asked for; below 1 where a call is costly */
    /* false: outside the domain, or rightly without a result; draw again */
    std::function<bool(probe *call)> draw;
    std::function<ball(const probe &call)> judge; /* not negative */
};

/* The error of the call number `index` of a row; HUGE_VAL where no number of bits could tell it. */
double probe_error(const row *claim, uint64_t seed, uint64_t index, probe *call);

/* Records an argument; returns it. */
double argument(probe *call, const char *name, double value);

/* What the library gives, or its status: the results are there already, NaN where it refuses. True,
 * as draw() is. */
bool gives(probe *call, double value);
bool gives(probe *call, int32_t status);

/* ---- Random numbers ---- */

double uniform(probe *call); /* [0, 1) */
double between(probe *call, double lo, double hi);
double log_between(probe *call, double lo, double hi); /* 0 < lo < hi */
bool chance(probe *call, double probability);
double either_sign(probe *call, double value);

/* ---- Arguments, with their edges over-sampled ---- */

/* 0 and 1e-60 to 1e60, dense next to 1 */
double some_alpha(probe *call);
double some_rounded_alpha(probe *call); /* not 0 */
/* [0, 1], dense next to 0, 1 and the mark */
double some_fraction(probe *call, double mark);
/* c/b, dense next to 0, alpha, 1; alpha is drawn */
double some_c(probe *call);
/* on the surface: next to 0, +-alpha, +-c, +-1 */
double some_place(probe *call, double alpha, double c);
void some_point(probe *call); /* x, y of the half-plane; alpha, f, c are drawn */
double some_friction(probe *call);
double some_poisson(probe *call);
double near(probe *call, double mark); /* from a factor of 2 to the next double */

/* ---- Errors ---- */

/* |result - exact|/scale. */
ball error_over(double result, const ball &exact, const ball &scale);

/* The largest error of the components. */
ball error_over(const double result[3], const tensor &exact, const ball &scale);

/* The relative error; 0 where both are 0. */
ball relative_error(double result, const ball &exact);

/* ---- Rows of functions of numbers ---- */

/* An argument, or several; they may depend on those before, in call->value. */
struct drawn {
    std::function<void(probe *call)> draw;

    drawn(const char *name, std::function<double(probe *call)> value)
        : draw([=](probe *call) { argument(call, name, value(call)); })
    {
    }
    drawn(void (*several)(probe *call)) : draw(several)
    {
    }
};

inline bool is_any(const probe &)
{
    return true;
}

/* The next argument of a function: a number, or where a result goes. */
struct in_order {
    const double *value;
    double *result;

    operator double()
    {
        return *value++;
    }
    operator int32_t()
    {
        return (int32_t)*value++;
    }
    operator double *()
    {
        return result++;
    }
};

/* The value of f, or all its results; other arguments are drawn where the call does not count. */
template <typename Answer, typename... Numbers>
std::function<bool(probe *)> calling(Answer (*f)(Numbers...), const std::vector<drawn> &arguments,
                                     bool (*counts)(const probe &call) = is_any)
{
    return [=](probe *call) {
        for (const drawn &a : arguments)
            a.draw(call);
        in_order next = {call->value, call->result};
        gives(call, std::apply(f, std::tuple<Numbers...>{(Numbers)next...}));
        return counts(*call);
    };
}

/* The error of that value, relative to what is exact of these arguments, or over a scale. */
std::function<ball(const probe &)> relative_to(ball (*exact)(const double *v));
std::function<ball(const probe &)> over(ball (*scale)(const double *v),
                                        ball (*exact)(const double *v));

#endif
