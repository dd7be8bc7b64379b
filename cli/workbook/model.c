/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include "text/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <rwedge.h>

static const double PI = 3.14159265358979323846;

static double rounded_to(double value, int digits)
{
    char text[NUMBER_SIZE];
    double rounded = value;
    if (isfinite(value)) {
        number_write(value, digits, '.', text);
        number_read(text, &rounded);
    }
    return rounded;
}

double workbook_rounded(double value)
{
    return rounded_to(value, 10);
}

/* ---- The table ------------------------------------------------------------------------------- */

/* The nodes are closer from nu = 0.18 on. There the branch below the surface begins to decide, and
 * near there it ends. Where a value of a patch is missing, the surface alone decides. f = 0.385 is
 * above all critical frictions (0.378). Hertz' contact still has the branch there. */
static const double nus[NUS] = {0,     0.1,  0.175, 0.2, 0.225, 0.25, 0.275, 0.3,
                                0.325, 0.35, 0.375, 0.4, 0.425, 0.45, 0.475, 0.5};
static const double frictions[FRICTIONS] = {0,     0.025, 0.05,  0.075, 0.1,   0.125, 0.15,
                                            0.175, 0.2,   0.225, 0.25,  0.275, 0.3,   0.325,
                                            0.35,  0.375, 0.385, 0.5,   0.6,   0.7,   0.8};

/* Enough beside the error of interpolation, and the file is smaller. */
enum { TABLE_DIGITS = 6 };

/* (load/limit)^2, rounded; 0 where there is no such branch, or J2 is 0 as on the surface for nu =
 * 0.5 and f = 0. False where it could not be computed. */
static bool fill_one(double load, int32_t status, double limit, double *value)
{
    *value = status == RWEDGE_OK ? rounded_to(load / limit * (load / limit), TABLE_DIGITS) : 0;
    return status == RWEDGE_OK || status == RWEDGE_EABSENT;
}

static bool fill_tip(yield_table *table, int i)
{
    const double tip = 1 / cosh(table->t[i]), load = rwedge_load(tip);
    bool done = true;
    for (int j = 0; j < NUS; j++)
        for (int k = 0; k < FRICTIONS; k++) {
            double limit = 0, x, y;
            const int32_t status = rwedge_surface_yield(tip, frictions[k], nus[j], &limit, &x);
            done = fill_one(load, status, limit, &table->surface[i][j][k]) && done;
            table->below[i][j][k] = 0;
            if (k >= FRICTIONS_BELOW)
                continue;
            const int32_t deep = rwedge_subsurface_yield(tip, frictions[k], nus[j], &limit, &x, &y);
            done = fill_one(load, deep, limit, &table->below[i][j][k]) && done;
        }
    return done;
}

/* x is odd in f, so x/f is even, as J2 is. This f stands for 0. */
static const double SMALL_FRICTION = 1e-3;

/* A branch whose J2 is less than this share of the other's decides in no cell of the table around
 * it: its place is left out. */
static const double FAR_BELOW = 0.7;

static double thousandths(double value)
{
    return floor(1000 * value + 0.5) / 1000;
}

static void fill_places(yield_table *table, int i)
{
    const double tip = 1 / cosh(table->t[PLACE_STEP * i]);
    for (int j = 0; j < NUS; j++)
        for (int k = 0; k < FRICTIONS; k++) {
            const double f = fmax(frictions[k], SMALL_FRICTION);
            const double surface = table->surface[PLACE_STEP * i][j][k],
                         below = table->below[PLACE_STEP * i][j][k];
            double limit, x, y;
            for (int which = 0; which < PLACES; which++)
                table->place[which][i][j][k] = 0;
            if (surface >= FAR_BELOW * below &&
                rwedge_surface_yield(tip, f, nus[j], &limit, &x) == RWEDGE_OK)
                table->place[SURFACE_X][i][j][k] = thousandths(x / (tip * f));
            if (below > 0 && below >= FAR_BELOW * surface &&
                rwedge_subsurface_yield(tip, f, nus[j], &limit, &x, &y) == RWEDGE_OK) {
                table->place[BELOW_X][i][j][k] = thousandths(x / (tip * f));
                table->place[BELOW_Y][i][j][k] = thousandths(y / tip);
            }
        }
}

bool yield_table_fill(yield_table *table)
{
    const double first = -acosh(1 / WORKBOOK_TIP_MIN);
    bool done = true;
    memcpy(table->nu, nus, sizeof nus);
    memcpy(table->f, frictions, sizeof frictions);
    for (int i = 0; i < TIPS; i++) {
        table->t[i] = workbook_rounded(first * (TIPS - 1 - i) / (TIPS - 1));
        done = fill_tip(table, i) && done;
    }
    for (int i = 0; i < PLACE_TIPS; i++)
        fill_places(table, i);
    return done;
}

/* ---- Inputs ---------------------------------------------------------------------------------- */

static double given_or(double value, double other)
{
    return isnan(value) ? other : value;
}

static void take_inputs(const double in[], double v[])
{
    const double SQRT_3 = sqrt(3);
    v[WORK_ANY] = 0;
    for (int i = 0; i < INPUT_CELLS; i++) {
        v[i] = in[i];
        v[WORK_ANY] += !isnan(in[i]);
    }
    v[WORK_BAD] = NAN;
    const bool ok = v[WORK_ANY] > 0;
    v[WORK_OK] = ok;
    const double theta = given_or(in[CELL_THETA], in[CELL_THETA_DEG] * PI / 180);
    v[WORK_THETA] = ok ? theta : 0.1;
    v[WORK_ROUNDING] = ok ? given_or(in[CELL_ROUNDING], in[CELL_RADIUS] * theta) : 1;
    v[WORK_E2] = ok ? given_or(in[CELL_E2], in[CELL_E1]) : 1;
    v[WORK_NU2] = ok ? given_or(in[CELL_NU2], in[CELL_NU1]) : 0;
    v[WORK_COMPLIANCE] =
        ok ? rwedge_compliance(in[CELL_E1], in[CELL_NU1], v[WORK_E2], v[WORK_NU2]) : 1;
    v[WORK_LOAD] = ok ? in[CELL_LOAD] : 1;
    v[WORK_F] = ok ? in[CELL_F] : 0;
    v[WORK_Q] = ok ? fabs(given_or(in[CELL_Q], 0)) : 0;
    v[WORK_SLIDES] = 0;
    v[WORK_HAS_K] = !isnan(in[CELL_K]) || !isnan(in[CELL_YIELD_STRESS]);
    v[WORK_K] = v[WORK_HAS_K] > 0 ? given_or(in[CELL_K], in[CELL_YIELD_STRESS] / SQRT_3) : 1;
}

/* ---- The contact ----------------------------------------------------------------------------- */

static double cosine_of(double alpha)
{
    return sqrt((1 - alpha) * (1 + alpha));
}

/* The Newton steps of cells.c. */
static void iterate(double x, double step[6])
{
    step[0] = x * (2 - (4 / PI - 1) * PI * PI / 4 * x);
    for (int i = 0; i < 5; i++) {
        const double a = step[i], phi = asin(a), load = phi + a * cosine_of(a);
        step[i + 1] = fmin(1, a - (a * a * load - x * load * load) / (2 * phi * a));
    }
}

static double ratio_of(double x, double step)
{
    return x >= 2 / PI ? sqrt(PI / 2 * x) : step;
}

static void solve_contact(double v[])
{
    const double a = v[WORK_ROUNDING], A = v[WORK_COMPLIANCE], P = v[WORK_LOAD];
    v[WORK_X] = fmax(1e-60, v[WORK_THETA] * a / (A * P));
    v[WORK_X1] = fmin(v[WORK_X], 2 / PI);
    iterate(v[WORK_X1], &v[WORK_N0]);
    v[WORK_COS] = cosine_of(v[WORK_N5]);
    v[WORK_RATIO] = a == 0 ? 0 : ratio_of(v[WORK_X], v[WORK_N5]);
    v[WORK_B] = a == 0 ? A * P / (2 * v[WORK_THETA]) : a / v[WORK_RATIO];
}

/* The stick zone is the contact of a smaller load. Its potential at the edge of the contact makes
 * the difference between the tension under Q and that in full sliding. */
static double stick_potential(const double v[])
{
    const double c = v[WORK_C], a = v[WORK_ROUNDING], root = v[WORK_ROOT_C], tip = v[WORK_C5];
    if (v[WORK_Q] * c == 0)
        return 0;
    if (c <= a)
        return c / a / (v[WORK_B] / c + root);
    const double z = v[WORK_B] / c, cosine = v[WORK_COS_C];
    return 2 / PI *
           (atan2(cosine, root) + z / tip * atan(tip / cosine * root / z) - asin(tip) * root / tip);
}

static void solve_stick(double v[])
{
    const double a = v[WORK_ROUNDING], A = v[WORK_COMPLIANCE], P = v[WORK_LOAD];
    const double load = v[WORK_Q] == 0 ? P : fmax(0, P - v[WORK_Q] / v[WORK_F]);
    v[WORK_STICK_LOAD] = load;
    v[WORK_XC] = load > 0 ? fmax(1e-60, v[WORK_THETA] * a / (A * load)) : 1;
    v[WORK_XC1] = fmin(v[WORK_XC], 2 / PI);
    iterate(v[WORK_XC1], &v[WORK_C0]);
    v[WORK_COS_C] = cosine_of(v[WORK_C5]);
    v[WORK_C] = load == 0        ? 0
                : v[WORK_Q] == 0 ? v[WORK_B]
                : a == 0         ? A * load / (2 * v[WORK_THETA])
                                 : a / ratio_of(v[WORK_XC], v[WORK_C5]);
    const double z = v[WORK_C] > 0 ? v[WORK_B] / v[WORK_C] : 1;
    v[WORK_ROOT_C] = sqrt(fmax(0, (z - 1) * (z + 1)));
    v[WORK_G] = stick_potential(v);
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

/* The third node is the next one above in nu and in t, and the one below in f. There the branch
 * below the surface exists. */
static void place_patch(const yield_table *table, double v[])
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

typedef const double branch[][NUS][FRICTIONS];

/* From a tip's values at three nodes of nu, for one node of f; missing is set where one is 0. */
static double over_nu(branch values, int tip, int f, const double v[], bool *missing)
{
    const int j = (int)v[WORK_NU_NODE] - 1;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += v[WORK_WEIGHT_NU + i] * values[tip][j + i][f];
        *missing = *missing || values[tip][j + i][f] <= 0;
    }
    return sum;
}

static double at_tip(branch values, int tip, const double v[], bool *missing)
{
    const int k = (int)v[WORK_F_NODE] - 1;
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += v[WORK_WEIGHT_F + i] * over_nu(values, tip, k + i, v, missing);
    return sum;
}

static double at_tips(branch values, int first, const double weight[3], const double v[],
                      bool *missing)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += weight[i] * at_tip(values, first + i, v, missing);
    return sum;
}

static double at_case(branch values, const double v[], bool *missing)
{
    return at_tips(values, (int)v[WORK_TIP_NODE] - 1, &v[WORK_WEIGHT_T], v, missing);
}

static void parabola(double u, double weight[3])
{
    weight[0] = (u - 1) * (u - 2) / 2;
    weight[1] = u * (2 - u);
    weight[2] = u * (u - 1) / 2;
}

static void find_limit(const yield_table *table, double v[])
{
    bool none = false, missing = false;
    const double tip = v[WORK_N5];
    v[WORK_T] = fmax(log(tip / (1 + v[WORK_COS])), table->t[0]);
    v[WORK_TIP_NODE] = fmin(match(table->t, TIPS, v[WORK_T]), TIPS - 2);
    const double u = (1 - v[WORK_T] / table->t[0]) * (TIPS - 1) - (v[WORK_TIP_NODE] - 1);
    v[WORK_U] = u;
    parabola(u, &v[WORK_WEIGHT_T]);
    v[WORK_SURFACE] = at_case(table->surface, v, &none);
    v[WORK_BELOW] = at_case(table->below, v, &missing);
    if (missing)
        v[WORK_BELOW] = 0;
    v[WORK_LIMIT] = v[WORK_ROUNDING] == 0 ? 0
                                          : (asin(tip) / tip + v[WORK_COS]) /
                                                sqrt(fmax(v[WORK_SURFACE], v[WORK_BELOW]));
    v[WORK_OK_F] = v[WORK_OK] > 0 && v[CELL_NU1] >= 0 && v[WORK_F] <= WORKBOOK_FRICTION_MAX;
    v[WORK_OK_TIP] = v[WORK_ROUNDING] == 0 || v[WORK_RATIO] >= WORKBOOK_TIP_MIN * (1 - 1e-9);
}

/* ---- The yield load -------------------------------------------------------------------------- */

static const double NEVER = 1e99;

/* The tips at which the branch is below k^2 are the last ones, as J2 falls where the tip grows. */
static void reach(branch values, bool may_miss, const double v[], double y[])
{
    int beyond = 0;
    for (int i = 0; i < TIPS; i++) {
        bool missing = false;
        const double value = at_tip(values, i, v, &missing);
        beyond += value < v[WORK_STRENGTH] && !(may_miss && missing);
    }
    y[YIELD_REACHED] = TIPS - beyond;
    y[YIELD_NODE] = fmin(fmax(y[YIELD_REACHED], 1), TIPS - 2);
    for (int i = 0; i < 3; i++) {
        bool missing = false;
        y[YIELD_K + i] = at_tip(values, (int)y[YIELD_NODE] - 1 + i, v, &missing);
        if (may_miss && missing)
            y[YIELD_K + i] = 0;
    }
}

static void find_yield(const yield_table *table, branch values, bool may_miss, const double v[],
                       double y[])
{
    reach(values, may_miss, v, y);
    const double reached = y[YIELD_REACHED], k2 = v[WORK_STRENGTH], *k = &y[YIELD_K];
    const double first = fmax(reached, 1) - y[YIELD_NODE], bend = k[2] - 2 * k[1] + k[0];
    const bool none = reached == 0 || fmin(k[0], fmin(k[1], k[2])) <= 0;
    y[YIELD_G] = k[(int)first] - k2;
    y[YIELD_D] = k[1] - k[0] + bend * (first - 0.5);
    const double root = sqrt(fmax(0, y[YIELD_D] * y[YIELD_D] - 2 * bend * y[YIELD_G]));
    const double place =
        none || reached == TIPS ? 0 : reached - 1 + 2 * y[YIELD_G] / (root - y[YIELD_D]);
    const double t = y[YIELD_U] = table->t[0] * (1 - place / (TIPS - 1));
    y[YIELD_LOAD] = none              ? NEVER
                    : reached == TIPS ? PI / 2 * k2 / k[2]
                                      : (asin(1 / cosh(t)) - tanh(t) / cosh(t)) * cosh(t) * cosh(t);
}

static void find_strength(const yield_table *table, double v[])
{
    const double unit = v[WORK_K] * v[WORK_COMPLIANCE] / v[WORK_THETA];
    v[WORK_STRENGTH] = unit * unit;
    find_yield(table, table->surface, false, v, &v[WORK_YIELD_S]);
    find_yield(table, table->below, true, v, &v[WORK_YIELD_B]);
    v[WORK_YIELD] = fmin(v[WORK_YIELD_S + YIELD_LOAD], v[WORK_YIELD_B + YIELD_LOAD]);
    const double bound = workbook_end_of_table() * v[WORK_X];
    v[WORK_BOUND] = bound >= 10 ? floor(bound) : floor(bound * 10) / 10;
}

static bool at_surface(const double v[])
{
    return v[WORK_YIELD_S + YIELD_LOAD] <= v[WORK_YIELD_B + YIELD_LOAD];
}

static void place_yield(const yield_table *table, double v[])
{
    const double t = v[WORK_YIELD] <= PI / 2 ? 0
                     : at_surface(v)         ? v[WORK_YIELD_S + YIELD_U]
                                             : v[WORK_YIELD_B + YIELD_U];
    v[WORK_YIELD_T] = t;
    v[WORK_PLACE_U] = (1 - t / table->t[0]) * (PLACE_TIPS - 1);
    v[WORK_PLACE_NODE] = fmin(floor(v[WORK_PLACE_U]), PLACE_TIPS - 3);
    parabola(v[WORK_PLACE_U] - v[WORK_PLACE_NODE], &v[WORK_WEIGHT_PLACE]);
    v[WORK_PLACE_ROW] = v[WORK_PLACE_NODE] + 1 + (at_surface(v) ? 0 : PLACE_TIPS);
    v[WORK_PLACE_UNIT] = v[WORK_ROUNDING] * sqrt(fmin(1, 2 / PI * v[WORK_YIELD]));
}

double workbook_end_of_table(void)
{
    return workbook_rounded(rwedge_load(WORKBOOK_TIP_MIN) / WORKBOOK_TIP_MIN);
}

/* ---- Critical friction ----------------------------------------------------------------------- */

/* The J2 of the surface less that below it, at this a/b and nu. */
static double gap_at(const yield_table *table, int f, const double v[], bool *missing)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const int tip = (int)v[WORK_TIP_NODE] - 1 + i;
        bool none = false;
        sum += v[WORK_WEIGHT_T + i] * (over_nu(table->surface, tip, f, v, &none) -
                                       over_nu(table->below, tip, f, v, missing));
    }
    return sum;
}

/* Where the branches cross. The difference of their J2 is nearly linear in f^2. If the branch below
 * the surface has ended at the next node, the line through the two nodes before it is extended. */
static void find_critical(const yield_table *table, double v[])
{
    int gaps = 0;
    for (int f = 0; f < FRICTIONS; f++) {
        bool missing = false;
        gaps += gap_at(table, f, v, &missing) < 0 && !missing;
    }
    bool ended = false, ignored = false;
    gap_at(table, gaps, v, &ended);
    const int node = ended && gaps > 1 ? gaps - 1 : (int)fmax(1, gaps);
    v[WORK_GAPS] = gaps;
    v[WORK_GAP_NODE] = node;
    v[WORK_GAP_1] = gap_at(table, node - 1, v, &ignored);
    v[WORK_GAP_2] = gap_at(table, node, v, &ignored);
}

static double critical_friction(const yield_table *table, const double v[])
{
    if (v[WORK_GAPS] <= 0)
        return 0;
    const double *f = &table->f[(int)v[WORK_GAP_NODE] - 1];
    const double share = v[WORK_GAP_1] / (v[WORK_GAP_1] - v[WORK_GAP_2]);
    return sqrt(f[0] * f[0] + (f[1] * f[1] - f[0] * f[0]) * share);
}

/* ---- Results --------------------------------------------------------------------------------- */

static void answer_contact(double v[])
{
    const double unit = v[WORK_THETA] / v[WORK_COMPLIANCE], ratio = v[WORK_RATIO];
    const bool rough = v[WORK_F] > 0, blunt = v[WORK_ROUNDING] > 0;
    v[CELL_COMPLIANCE] = v[WORK_COMPLIANCE];
    v[CELL_BETA] = rwedge_dundurs_beta(v[CELL_E1], v[CELL_NU1], v[WORK_E2], v[WORK_NU2]);
    v[CELL_B] = v[WORK_B];
    v[CELL_A_OVER_B] = ratio;
    v[CELL_LOAD_NUMBER] = v[WORK_LOAD] / (unit * v[WORK_B]);
    v[CELL_P0] = blunt ? unit * rwedge_peak_pressure(ratio) : NAN;
    v[CELL_P_TRANSITION] = blunt ? unit * rwedge_transition_pressure(ratio) : NAN;
    v[CELL_P_MEAN] = v[WORK_LOAD] / (2 * v[WORK_B]);
    v[CELL_Q_OVER_FP] = rough ? given_or(v[CELL_Q], 0) / (v[WORK_F] * v[WORK_LOAD]) : NAN;
    v[CELL_C] = rough ? v[WORK_C] : NAN;
    v[CELL_C_OVER_B] = rough ? v[WORK_C] / v[WORK_B] : NAN;
    v[CELL_TENSION] = v[WORK_Q] > 0 ? 2 * v[WORK_F] * unit * (1 / fmax(1, ratio) - v[WORK_G]) : 0;
    v[CELL_TENSION_SLIDING] = 2 * v[WORK_F] * unit / fmax(1, ratio);
}

static void answer_place(const yield_table *table, case_values *out)
{
    double *v = out->number;
    const bool surface = v[WORK_ROUNDING] == 0 || at_surface(v);
    const int node = (int)v[WORK_PLACE_NODE];
    const double *weight = &v[WORK_WEIGHT_PLACE];
    bool none = false;
    const double x = at_tips(table->place[at_surface(v) ? SURFACE_X : BELOW_X], node, weight, v,
                             &none),
                 y = at_tips(table->place[BELOW_Y], node, weight, v, &none);
    snprintf(out->branch, sizeof out->branch, "%s", surface ? "surface" : "subsurface");
    v[CELL_YIELD_X] =
        (given_or(v[CELL_Q], 0) < 0 ? -1 : 1) * v[WORK_PLACE_UNIT] * v[WORK_F_TABLE] * x;
    v[CELL_YIELD_Y] = surface ? 0 : v[WORK_PLACE_UNIT] * y;
}

static void answer_yield(const yield_table *table, case_values *out)
{
    double *v = out->number;
    const bool has_k = v[WORK_HAS_K] > 0, tip = v[WORK_OK_TIP] > 0, f = v[WORK_OK_F] > 0;
    const bool sharp = v[WORK_ROUNDING] == 0;
    v[CELL_LOAD_OVER_BK] = has_k ? v[WORK_LOAD] / (v[WORK_B] * v[WORK_K]) : NAN;
    v[CELL_P_OVER_BK] = f && tip ? v[WORK_LIMIT] : NAN;
    if (f && tip && !sharp)
        v[CELL_VON_MISES] = sqrt(3) * v[WORK_LOAD] / v[WORK_B] / v[WORK_LIMIT];
    if (tip && !sharp && v[CELL_NU1] >= 0)
        v[CELL_F_CRITICAL] = critical_friction(table, v);
    v[CELL_SAFETY_STRENGTH] = v[CELL_P_OVER_BK] / v[CELL_LOAD_OVER_BK];
    if (!has_k || !f)
        return;
    if (sharp || v[WORK_YIELD] < NEVER) {
        v[CELL_P_YIELD] =
            sharp ? 0 : v[WORK_YIELD] * v[WORK_THETA] * v[WORK_ROUNDING] / v[WORK_COMPLIANCE];
        v[CELL_SAFETY] = v[CELL_P_YIELD] / v[WORK_LOAD];
        answer_place(table, out);
    } else
        snprintf(out->safety, sizeof out->safety, "> %.*f", v[WORK_BOUND] >= 10 ? 0 : 1,
                 v[WORK_BOUND]);
}

void workbook_compute(const yield_table *table, const double input[INPUT_CELLS], case_values *out)
{
    double *v = out->number;
    for (int i = 0; i < CELL_COUNT; i++)
        v[i] = NAN;
    out->safety[0] = out->branch[0] = '\0';
    take_inputs(input, v);
    solve_contact(v);
    solve_stick(v);
    place_patch(table, v);
    find_limit(table, v);
    find_strength(table, v);
    place_yield(table, v);
    find_critical(table, v);
    if (v[WORK_OK] > 0) {
        answer_contact(v);
        answer_yield(table, out);
    }
}

/* ---- Curves ---------------------------------------------------------------------------------- */

static double limit_from(double load, double surface, double below, bool missing)
{
    return load / sqrt(fmax(surface, missing ? 0 : below));
}

double workbook_limit_at_tip(const yield_table *table, const case_values *values, int node)
{
    bool none = false, missing = false;
    const double surface = at_tip(table->surface, node, values->number, &none),
                 below = at_tip(table->below, node, values->number, &missing);
    return limit_from(rwedge_load(1 / cosh(table->t[node])), surface, below, missing);
}

double workbook_limit_at_friction(const yield_table *table, const case_values *values, int node)
{
    const double *v = values->number;
    bool missing = false;
    double surface = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        const int tip = (int)v[WORK_TIP_NODE] - 1 + i;
        bool none = false;
        surface += v[WORK_WEIGHT_T + i] * over_nu(table->surface, tip, node, v, &none);
        below += v[WORK_WEIGHT_T + i] * over_nu(table->below, tip, node, v, &missing);
    }
    return limit_from(asin(v[WORK_N5]) / v[WORK_N5] + v[WORK_COS], surface, below, missing);
}
