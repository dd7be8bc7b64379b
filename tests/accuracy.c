/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest error of each function against the 20-digit values of tests/data/, as lib/README.md quotes it. The promise that
 * the header makes stands beside it; the tests assert that. */
#include "claims.h"
#include "rwedge.h"

#include <stdio.h>

typedef double (*error_of_row)(const double *row);

static double relative(double value, double expected)
{
    return value == expected ? 0 : fabs(value - expected) / fabs(expected);
}

static double load(const double *v)
{
    return relative(rwedge_load(v[0]), v[1]);
}

static double a_over_b(const double *v)
{
    return relative(rwedge_a_over_b(v[1] / v[0]), v[0]);
}

static double peak_pressure(const double *v)
{
    return relative(rwedge_peak_pressure(v[0]), v[2]);
}

static double transition_pressure(const double *v)
{
    return relative(rwedge_transition_pressure(v[0]), v[3]);
}

static double max_tension(const double *v)
{
    return relative(rwedge_max_tension(v[0]), v[4]);
}

static double pressure(const double *v)
{
    return relative(rwedge_pressure(v[0], v[1]), v[2]);
}

static double coefficient(const double *v)
{
    return relative(rwedge_coefficient(v[0], (int32_t)v[1]), v[2]);
}

static double shear_ratio(const double *v)
{
    return relative(rwedge_shear_ratio(v[0], v[2]), v[5]);
}

static double tensor(double alpha, double f, double c, const double *point, const double *expected)
{
    double s[3], worst = 0, squares = 0;
    if (rwedge_stress(alpha, f, c, point[0], point[1], &s[0], &s[1], &s[2]) != RWEDGE_OK)
        return HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        worst = fmax(worst, fabs(s[i] - expected[i]));
        squares += (i == 2 ? 2 : 1) * expected[i] * expected[i];
    }
    return worst / fmax(sqrt(squares), 1 / (1 + hypot(point[0], point[1])));
}

static double stress_sliding(const double *v)
{
    return tensor(v[0], v[1], 0, &v[2], &v[4]);
}

static double stress_partial_slip(const double *v)
{
    return tensor(v[0], v[1], v[2], &v[3], &v[6]);
}

static double elastic_limit(const double *v)
{
    return relative(rwedge_elastic_limit(v[0], v[1], v[2]), v[3]);
}

static double paper_grid(const double *v)
{
    return relative(rwedge_elastic_limit(v[0], v[1], 0.3), v[2]);
}

static double critical_friction(const double *v)
{
    return relative(rwedge_critical_friction(v[0], v[1]), v[2]);
}

int main(void)
{
    static const struct {
        const char *name, *table, *promise;
        error_of_row error;
    } rows[] = {
        {"rwedge_load", "contact_law.csv", "4 epsilon", load},
        {"rwedge_a_over_b", "contact_law.csv", "1e-14", a_over_b},
        {"rwedge_peak_pressure", "contact_law.csv", "1e-14", peak_pressure},
        {"rwedge_transition_pressure", "contact_law.csv", "1e-14", transition_pressure},
        {"rwedge_max_tension", "contact_law.csv", "1e-14", max_tension},
        {"rwedge_pressure", "pressure.csv", "1e-12", pressure},
        {"rwedge_coefficient", "coefficients.csv", "1e-14", coefficient},
        {"rwedge_shear_ratio", "stress_partial_slip.csv", "1e-14", shear_ratio},
        {"rwedge_stress, full sliding", "stress_sliding.csv", "1e-13", stress_sliding},
        {"rwedge_stress, partial slip", "stress_partial_slip.csv", "1e-13", stress_partial_slip},
        {"rwedge_elastic_limit", "elastic_limit.csv", "1e-12", elastic_limit},
        {"the same, on the paper's grid", "paper_grid.csv", "1e-12", paper_grid},
        {"rwedge_critical_friction", "critical_friction.csv", "1e-11", critical_friction},
    };
    printf("%-32s %8s %14s   %s\n", "", "values", "largest error", "promised");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double worst = 0;
        reference table = reference_open(rows[i].table);
        while (reference_next(&table))
            worst = fmax(worst, rows[i].error(table.cell));
        printf("%-32s %8zu %14.1e   %s\n", rows[i].name, table.row, worst, rows[i].promise);
    }
    return 0;
}
