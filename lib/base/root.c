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

/* Zeros below 0 of the Legendre polynomials P_4, P_8 and P_16, and half of the weights
 * 2/((1-x^2) P'(x)^2). */
typedef double half_rule[2];
static const half_rule OF_4[] = {{-0.86113631159405257522, 0.17392742256872692869},
                                 {-0.33998104358485626480, 0.32607257743127307131}};
static const half_rule OF_8[] = {{-0.96028985649753623168, 0.050614268145188129576},
                                 {-0.79666647741362673959, 0.11119051722668723527},
                                 {-0.52553240991632898582, 0.15685332293894364367},
                                 {-0.18343464249564980494, 0.18134189168918099148}};
static const half_rule OF_16[] = {{-0.9894009349916499326, 0.013576229705877047426},
                                  {-0.94457502307323257608, 0.031126761969323946431},
                                  {-0.86563120238783174388, 0.047579255841246392405},
                                  {-0.7554044083550030339, 0.062314485627766936026},
                                  {-0.61787624440264374845, 0.074797994408288366041},
                                  {-0.45801677765722738634, 0.084578259697501269095},
                                  {-0.28160355077925891323, 0.091301707522461794433},
                                  {-0.095012509837637440185, 0.094725305227534248143}};

void rw_gauss(int n, double node[], double weight[])
{
    const half_rule *rule = n == 16 ? OF_16 : n == 8 ? OF_8 : OF_4;
    for (int i = 0; i < n / 2; i++) {
        node[i] = (1 + rule[i][0]) / 2;
        node[n - 1 - i] = (1 - rule[i][0]) / 2;
        weight[i] = weight[n - 1 - i] = rule[i][1];
    }
}

/* A row of angles takes one sine and one cosine, and a turn for each angle. */
void rw_half_circle(int n, double node[], double weight[])
{
    const double step = RW_PI / n, turn_re = cos(step), turn_im = sin(step);
    double re = cos(step / 2), im = sin(step / 2);
    for (int i = 0; i < n; i++) {
        const double before = re;
        node[i] = (1 - re) / 2;
        weight[i] = step / 2 * im;
        re = re * turn_re - im * turn_im;
        im = before * turn_im + im * turn_re;
    }
}

double rw_integral(rw_function f, const void *context, double lo, double hi)
{
    const double middle = lo + (hi - lo) / 2, half = (hi - lo) / 2;
    double sum = 0;
    for (int i = 8; i-- > 0;) {
        const double offset = half * -OF_16[i][0];
        sum += OF_16[i][1] * (f(middle - offset, context) + f(middle + offset, context));
    }
    return half * sum * 2;
}
