/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GSL's Brent. GSL reports errors to one handler of the whole process, which aborts by default
 * and is the host's to set: so nothing here may fail. The bracket is proved before GSL sees it,
 * and the solver lives on the stack, because its allocator is another way to the handler. */
#include "base/root.h"

#include "base/always.h"
#include "base/domain.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

/* Brent takes ten steps or so; halving alone would take 60 to the last bits, or to 1e-18 of a
 * bracket that begins at 0. */
enum { MAX_STEPS = 200 };

typedef struct {
    rw_function f;
    const void *context;
} problem;

static double evaluate(double x, void *params)
{
    const problem *p = params;
    return p->f(x, p->context);
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
    problem p = {f, context};
    gsl_function function = {evaluate, &p};
    /* Brent's is 12 doubles; a GSL that needs more is refused rather than overrun */
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
            return solver.root;
    }
    return NAN;
}
