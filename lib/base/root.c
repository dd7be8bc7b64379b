/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brent's method of GSL. GSL reports errors to one handler of the whole process. By default the
 * handler aborts; only the host may set it. So no call of GSL may fail here. The bracket is checked
 * before GSL sees it. The solver is on the stack, because GSL's allocator may call the handler too.
 */
#include "base/root.h"

#include "base/always.h"
#include "base/domain.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

/* Brent's method takes about ten steps. Halving alone would take 60, to the last bits or to 1e-18
 * of a bracket that begins at 0. */
enum { MAX_STEPS = 200 };

typedef struct {
    rw_function f;
    const void *context;
    int broken; /* the function was not finite somewhere */
} problem;

/* GSL's handler would be told of a value that is not finite. */
static double evaluate(double x, void *params)
{
    problem *p = params;
    const double value = p->f(x, p->context);
    if (isfinite(value))
        return value;
    p->broken = 1;
    return 0;
}

double rw_root(rw_function f, const void *context, double lo, double hi, double nearest)
{
    const double at_lo = f(lo, context), at_hi = f(hi, context);
    if (!isfinite(at_lo) || !isfinite(at_hi) || (at_lo < 0 && at_hi < 0) ||
        (at_lo > 0 && at_hi > 0))
        return NAN;
    if (at_lo == 0)
        return lo;
    if (at_hi == 0)
        return hi;
    problem p = {f, context, 0};
    gsl_function function = {evaluate, &p};
    /* Brent's state is 12 doubles; a GSL that needs more is refused, and the state not overrun */
    double state[32];
    if (NEVER(gsl_root_fsolver_brent->size > sizeof state)) /* in no GSL up to 2.8 */
        return NAN;
    gsl_root_fsolver solver = {.type = gsl_root_fsolver_brent, .state = state};
    int status = gsl_root_fsolver_set(&solver, &function, lo, hi);
    if (NEVER(status != GSL_SUCCESS)) /* the signs differ */
        return NAN;
    for (int step = 0; step < MAX_STEPS; step++) {
        status = gsl_root_fsolver_iterate(&solver);
        if (NEVER(status != GSL_SUCCESS)) /* f is finite on the bracket */
            return NAN;
        if (gsl_root_test_interval(solver.x_lower, solver.x_upper, nearest, 2 * DBL_EPSILON) ==
            GSL_SUCCESS)
            return p.broken ? NAN : solver.root;
    }
    return NAN;
}
