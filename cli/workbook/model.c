/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include "text/number.h"
#include "sheet/xlsx.h"

#include <math.h>

#include <rwedge.h>

static const double PI = 3.14159265358979323846;

double workbook_rounded(double value)
{
    char text[NUMBER_SIZE];
    double rounded = value;
    if (isfinite(value)) {
        number_write(value, 10, '.', text);
        number_read(text, &rounded);
    }
    return rounded;
}

/* ---- The table ------------------------------------------------------------------------------- */

/* The nodes are closer from nu = 0.18 on. There the branch below the surface begins to decide, and
 * near there it ends. Where one of the nine values of a patch is missing, the surface alone
 * decides. f = 0.385 is above all critical frictions (0.378). Hertz' contact still has the branch
 * there. */
static const double nus[NUS] = {0,     0.1,  0.175, 0.2, 0.225, 0.25, 0.275, 0.3,
                                0.325, 0.35, 0.375, 0.4, 0.425, 0.45, 0.475, 0.5};
static const double frictions[FRICTIONS] = {0,     0.025, 0.05,  0.075, 0.1,   0.125, 0.15,
                                            0.175, 0.2,   0.225, 0.25,  0.275, 0.3,   0.325,
                                            0.35,  0.375, 0.385, 0.5,   0.6,   0.7,   0.8};

/* t equally spaced from a/b = 0.01 to 1, a/b to four digits. */
static void fill_tips(limit_table *table)
{
    const double first = -acosh(1 / WORKBOOK_TIP_MIN);
    for (int i = 0; i < TIPS; i++) {
        char text[NUMBER_SIZE];
        double *tip = &table->tip[i];
        number_write(1 / cosh(first * (TIPS - 1 - i) / (TIPS - 1)), 4, '.', text);
        number_read(text, tip);
        table->t[i] = workbook_rounded(log(*tip / (1 + sqrt((1 - *tip) * (1 + *tip)))));
        table->load[i] = workbook_rounded(rwedge_load(*tip));
        table->log_load[i] = workbook_rounded(log(rwedge_load(*tip) / *tip));
    }
}

static bool fill_surface(limit_table *table, int tip, int nu, int f)
{
    double limit, x;
    const int32_t status = rwedge_surface_yield(table->tip[tip], frictions[f], nus[nu], &limit, &x);
    if (status != RWEDGE_OK)
        limit = XLSX_INFINITE; /* for nu = 0.5 and f = 0, J2 is 0 on the surface */
    table->surface[tip][nu][f] = workbook_rounded(limit);
    return status == RWEDGE_OK || status == RWEDGE_EABSENT;
}

static bool fill_below(limit_table *table, int tip, int nu, int f)
{
    double limit, x, y;
    const int32_t status =
        rwedge_subsurface_yield(table->tip[tip], frictions[f], nus[nu], &limit, &x, &y);
    table->below[tip][nu][f] = status == RWEDGE_OK ? workbook_rounded(limit) : NAN;
    return status == RWEDGE_OK || status == RWEDGE_EABSENT;
}

bool limit_table_fill(limit_table *table)
{
    bool done = true;
    fill_tips(table);
    for (int i = 0; i < NUS; i++)
        table->nu[i] = nus[i];
    for (int i = 0; i < FRICTIONS; i++)
        table->f[i] = frictions[i];
    for (int i = 0; i < TIPS; i++)
        for (int j = 0; j < NUS; j++)
            for (int f = 0; f < FRICTIONS; f++) {
                done = fill_surface(table, i, j, f) && done;
                if (f < FRICTIONS_BELOW)
                    done = fill_below(table, i, j, f) && done;
            }
    return done;
}

/* ---- The contact ----------------------------------------------------------------------------- */

static double cosine_of(double alpha)
{
    return sqrt((1 - alpha) * (1 + alpha));
}

/* a/b from x = theta a/(AP): Newton on a^2/(phi0 + a c0) = x, nearly a straight line; the
 * parabola that it starts from is exact at both ends. */
static void solve_contact(const workbook_inputs *in, workbook_results *out)
{
    out->A = rwedge_compliance(in->E1, in->nu1, in->E2, in->nu2);
    out->x = in->theta * in->a / (out->A * in->P);
    const double x = fmin(out->x, 2 / PI);
    out->step[0] = x * (2 - (4 / PI - 1) * PI * PI / 4 * x);
    for (int i = 0; i < NEWTON_STEPS; i++) {
        const double a = out->step[i], phi = asin(a), load = phi + a * cosine_of(a);
        out->step[i + 1] = fmin(1, a - (a * a * load - x * load * load) / (2 * phi * a));
    }
    out->a_over_b = out->x >= 2 / PI ? sqrt(PI / 2 * out->x) : out->step[NEWTON_STEPS];
    out->tip = fmin(1, out->a_over_b);
    out->cosine = cosine_of(out->tip);
    out->b = in->a / out->a_over_b;
}

static void derive_stresses(const workbook_inputs *in, workbook_results *out)
{
    out->p0 = in->theta / out->A * rwedge_peak_pressure(out->a_over_b);
    out->tension_ratio = rwedge_max_tension(out->a_over_b);
    out->tension = in->f * in->P / out->b * out->tension_ratio;
    out->beta = rwedge_dundurs_beta(in->E1, in->nu1, in->E2, in->nu2);
}

/* ---- Interpolation --------------------------------------------------------------------------- */

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

/* The third node is the next one above in nu, and the one below in f. There the branch below the
 * surface exists. */
static void place_patch(const limit_table *table, const workbook_inputs *in, workbook_results *out)
{
    double node[3];
    out->nu_node = (int)fmin(match(table->nu, NUS, in->nu1), NUS - 2) - 1;
    out->f_node = (int)fmin(fmax(match(table->f, FRICTIONS, in->f) - 1, 1), FRICTIONS - 2) - 1;
    out->m = m_of(in->nu1);
    for (int i = 0; i < 3; i++)
        node[i] = m_of(table->nu[out->nu_node + i]);
    lagrange(node, out->m, out->weight_nu);
    for (int i = 0; i < 3; i++)
        node[i] = table->f[out->f_node + i] * table->f[out->f_node + i];
    lagrange(node, in->f * in->f, out->weight_f);
}

/* Interpolated next to 0, 1/limit^2 may be 0 or less. The limit is then 1000, which is never the
 * smaller one. */
static double limit_from(double sum)
{
    return 1 / sqrt(fmax(sum, 1e-6));
}

/* From the limits of a tip at three nodes of nu, `stride` apart, and at some nodes of f. */
static double interpolate(const double *limit, int stride, const double weight_nu[3],
                          const double weight_f[], int nodes_f)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < nodes_f; j++) {
            const double node = limit[i * stride + j];
            sum += weight_nu[i] * weight_f[j] / (node * node);
        }
    return isnan(sum) ? NAN : limit_from(sum);
}

static void interpolate_tips(const limit_table *table, workbook_results *out)
{
    const bool deep = out->f_node + 3 <= FRICTIONS_BELOW;
    for (int i = 0; i < TIPS; i++) {
        out->surface[i] = interpolate(&table->surface[i][out->nu_node][out->f_node], FRICTIONS,
                                      out->weight_nu, out->weight_f, 3);
        out->below[i] = deep ? interpolate(&table->below[i][out->nu_node][out->f_node],
                                           FRICTIONS_BELOW, out->weight_nu, out->weight_f, 3)
                             : NAN;
        out->stress_surface[i] = table->load[i] / out->surface[i];
        out->stress_below[i] = isnan(out->below[i]) ? 0 : table->load[i] / out->below[i];
        out->stress[i] = fmax(out->stress_surface[i], out->stress_below[i]);
    }
}

static double between(double low, double high, double share)
{
    return (1 - share) * low + share * high;
}

static void find_limit(const limit_table *table, workbook_results *out)
{
    out->t = log(out->tip / (1 + out->cosine));
    const int found = (int)fmin(fmax(match(table->t, TIPS, out->t), 1), TIPS - 1) - 1;
    out->node = found;
    out->share = (out->t - table->t[found]) / (table->t[found + 1] - table->t[found]);
    out->limit_surface = between(out->surface[found], out->surface[found + 1], out->share);
    out->limit_below = between(out->below[found], out->below[found + 1], out->share);
    out->limit = fmin(out->limit_surface, out->limit_below); /* of a number and NAN, the number */
}

/* ---- The yield load -------------------------------------------------------------------------- */

/* ln(AP/(theta a)) where the stress of a branch reaches the strength between the tips i and i +
 * 1; NAN where it does not. */
static double crossing(const limit_table *table, const double stress[], int i, double strength)
{
    if (stress[i] < strength || stress[i + 1] <= 0)
        return NAN;
    return table->log_load[i] + log(strength / stress[i]) / log(stress[i + 1] / stress[i]) *
                                    (table->log_load[i + 1] - table->log_load[i]);
}

/* The load that makes a tip grows as the tip shrinks, and so does the stress: the first tip that
 * is strong enough is counted, without a search. */
static void find_yield(const limit_table *table, const workbook_inputs *in, workbook_results *out)
{
    out->strength = in->k * out->A / in->theta;
    out->reached = 0;
    for (int i = 0; i < TIPS; i++)
        out->reached += out->stress[i] >= out->strength;
    out->yield_surface = out->yield_below = out->yield_either = NAN;
    if (out->reached > 0 && out->reached < TIPS) {
        const int i = out->reached - 1;
        out->yield_surface = crossing(table, out->stress_surface, i, out->strength);
        out->yield_below = crossing(table, out->stress_below, i, out->strength);
        out->yield_either = crossing(table, out->stress, i, out->strength);
    }
    const double ratio = out->strength / out->stress[TIPS - 1];
    const double first = fmin(out->yield_surface, out->yield_below);
    out->yield = out->reached == 0      ? NAN
                 : out->reached == TIPS ? PI / 2 * ratio * ratio
                                        : exp(isnan(first) ? out->yield_either : first);
    out->P_yield = out->yield * in->theta * in->a / out->A;
    out->safety = out->P_yield / in->P;
    out->load_over_bk = in->P / (out->b * in->k);
}

/* ---- Critical friction ----------------------------------------------------------------------- */

static double over_nu(const workbook_results *out, const double *limit, int stride)
{
    const double one = 1;
    return interpolate(limit, stride, out->weight_nu, &one, 1);
}

static void trace_friction(const limit_table *table, workbook_results *out)
{
    const int node = out->node, nu = out->nu_node;
    for (int f = 0; f < FRICTIONS; f++) {
        const bool deep = f < FRICTIONS_BELOW;
        out->low_surface[f] = over_nu(out, &table->surface[node][nu][f], FRICTIONS);
        out->high_surface[f] = over_nu(out, &table->surface[node + 1][nu][f], FRICTIONS);
        out->low_below[f] = deep ? over_nu(out, &table->below[node][nu][f], FRICTIONS_BELOW) : NAN;
        out->high_below[f] =
            deep ? over_nu(out, &table->below[node + 1][nu][f], FRICTIONS_BELOW) : NAN;
        out->curve_surface[f] = between(out->low_surface[f], out->high_surface[f], out->share);
        out->curve_below[f] = between(out->low_below[f], out->high_below[f], out->share);
        out->curve[f] = fmin(out->curve_surface[f], out->curve_below[f]);
        const double s = out->curve_surface[f], d = out->curve_below[f];
        out->gap[f] = isnan(d) ? 1 : 1 / (s * s) - 1 / (d * d);
    }
}

/* Where the branches cross. The difference of their 1/limit^2 is nearly linear in f^2. If the
 * branch below the surface has ended at the next node, the line through the two nodes before it is
 * extended. */
static void find_critical(const limit_table *table, workbook_results *out)
{
    out->gaps = 0;
    for (int f = 0; f < FRICTIONS; f++)
        out->gaps += out->gap[f] < 0;
    out->f_critical = 0;
    if (out->gaps == 0)
        return;
    int i = out->gaps - 1;
    if (isnan(out->curve_below[i + 1]) && i > 0)
        i--;
    const double low = table->f[i] * table->f[i], high = table->f[i + 1] * table->f[i + 1];
    out->f_critical = sqrt(low + (high - low) * out->gap[i] / (out->gap[i] - out->gap[i + 1]));
}

void workbook_compute(const limit_table *table, const workbook_inputs *in, workbook_results *out)
{
    solve_contact(in, out);
    derive_stresses(in, out);
    place_patch(table, in, out);
    interpolate_tips(table, out);
    find_limit(table, out);
    find_yield(table, in, out);
    trace_friction(table, out);
    find_critical(table, out);
}
