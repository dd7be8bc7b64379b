/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpolation.h"

#include <math.h>

/* How many of the ascending nodes are not above the value. */
static int match(const double node[], int count, double value)
{
    int found = 0;
    while (found < count && node[found] <= value)
        found++;
    return found;
}

static double m_of(double nu)
{
    return (1 - 2 * nu) * (1 - 2 * nu) / 3;
}

static void lagrange(const double node[3], double at, double weight[3])
{
    for (int i = 0; i < 3; i++) {
        const double p = node[(i + 1) % 3], q = node[(i + 2) % 3];
        weight[i] = (at - p) * (at - q) / ((node[i] - p) * (node[i] - q));
    }
}

void parabola(double u, double weight[3])
{
    weight[0] = (u - 1) * (u - 2) / 2;
    weight[1] = u * (2 - u);
    weight[2] = u * (u - 1) / 2;
}

/* The third node is the next one above in nu and in t, and the one below in f. There the branch
 * below the surface exists. */
static void place_in_nu_and_f(const yield_table *table, double v[])
{
    double node[3];
    const double nu = v[WORK_OK] > 0 ? fmin(fmax(v[CELL_NU1], 0), 0.5) : 0.3;
    const double f = fmin(v[WORK_F], WORKBOOK_FRICTION_MAX);
    const int j = (int)fmin(match(table->nu, NUS, nu), NUS - 2);
    const int k = (int)fmin(fmax(match(table->f, FRICTIONS, f) - 1, 1), FRICTIONS - 2);
    v[WORK_NU_TABLE] = nu;
    v[WORK_F_TABLE] = f;
    v[WORK_NU_NODE] = j;
    v[WORK_F_NODE] = k;
    v[WORK_M] = m_of(nu);
    for (int i = 0; i < 3; i++)
        node[i] = m_of(table->nu[j - 1 + i]);
    lagrange(node, v[WORK_M], &v[WORK_WEIGHT_NU]);
    for (int i = 0; i < 3; i++)
        node[i] = table->f[k - 1 + i] * table->f[k - 1 + i];
    lagrange(node, f * f, &v[WORK_WEIGHT_F]);
    v[WORK_COLUMN] = (j - 1) * FRICTIONS + k;
}

static void place_in_t(const yield_table *table, double v[])
{
    v[WORK_T] = fmax(log(v[WORK_N5] / (1 + v[WORK_COS])), table->t[0]);
    v[WORK_TIP_NODE] = fmin(match(table->t, TIPS, v[WORK_T]), TIPS - 2);
    v[WORK_U] = (1 - v[WORK_T] / table->t[0]) * (TIPS - 1) - (v[WORK_TIP_NODE] - 1);
    parabola(v[WORK_U], &v[WORK_WEIGHT_T]);
}

void patch_find(const yield_table *table, double v[CELL_COUNT])
{
    place_in_nu_and_f(table, v);
    place_in_t(table, v);
}

double patch_at_friction(branch values, int tip, int f, const double v[CELL_COUNT], bool *missing)
{
    const int j = (int)v[WORK_NU_NODE] - 1;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += v[WORK_WEIGHT_NU + i] * values[tip][j + i][f];
        *missing = *missing || values[tip][j + i][f] <= 0;
    }
    return sum;
}

double patch_at_tip(branch values, int tip, const double v[CELL_COUNT], bool *missing)
{
    const int k = (int)v[WORK_F_NODE] - 1;
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += v[WORK_WEIGHT_F + i] * patch_at_friction(values, tip, k + i, v, missing);
    return sum;
}

double patch_at_tips(branch values, int first, const double weight[3], const double v[CELL_COUNT],
                     bool *missing)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += weight[i] * patch_at_tip(values, first + i, v, missing);
    return sum;
}

double patch_at_case(branch values, const double v[CELL_COUNT], bool *missing)
{
    return patch_at_tips(values, (int)v[WORK_TIP_NODE] - 1, &v[WORK_WEIGHT_T], v, missing);
}
