/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Brent's method of GSL, which no other file sees. GSL reports errors to one handler of the whole
 * process. By default the handler aborts; only the host may set it. So no call of GSL may fail
 * here. The bracket is checked before GSL sees it. The solver is on the stack, because GSL's
 * allocator may call the handler too. */
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

/* ---- Integrals ---- */

enum { PAIRS = 8 };

/* Positive zeros of the Legendre polynomial P_16, and their weights 2/((1-x^2) P'(x)^2). */
static const struct {
    double node, weight;
} RULE[PAIRS] = {
    {0.095012509837637440185, 0.18945061045506849629},
    {0.28160355077925891323, 0.18260341504492358887},
    {0.45801677765722738634, 0.16915651939500253819},
    {0.61787624440264374845, 0.14959598881657673208},
    {0.7554044083550030339, 0.12462897125553387205},
    {0.86563120238783174388, 0.09515851168249278481},
    {0.94457502307323257608, 0.062253523938647892863},
    {0.9894009349916499326, 0.027152459411754094852},
};

double rw_integral(rw_function f, const void *context, double lo, double hi)
{
    const double middle = lo + (hi - lo) / 2, half = (hi - lo) / 2;
    double sum = 0;
    for (int i = 0; i < PAIRS; i++) {
        const double offset = half * RULE[i].node;
        sum += RULE[i].weight * (f(middle - offset, context) + f(middle + offset, context));
    }
    return half * sum;
}
