/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact_values.h"

#include "text/pi.h"

#include <math.h>

#include <rwedge.h>

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

void contact_solve(const double input[INPUT_CELLS], double v[CELL_COUNT])
{
    take_inputs(input, v);
    solve_contact(v);
    solve_stick(v);
}

/* ---- Results --------------------------------------------------------------------------------- */

void contact_answer(double v[CELL_COUNT])
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
