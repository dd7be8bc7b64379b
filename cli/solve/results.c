/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include "present_state.h"

#include "contact/doubts.h"
#include "contact/loads.h"
#include "text/list.h"

#include <math.h>

#include <rwedge.h>

const column_kind result_kinds[RESULT_COUNT] = {
    [RESULT_A] = {"A", "composite compliance", "1/stress"},
    [RESULT_BETA] = {"dundurs_beta", "Dundurs' beta; 0 for elastically similar bodies", "none"},
    [RESULT_ROUNDING] = {"a", "half-width of the rounding", "length"},
    [RESULT_RADIUS] = {"radius", "radius of the rounding", "length"},
    [RESULT_B] = {"b", "half-width of the contact", "length"},
    [RESULT_A_OVER_B] = {"a_over_b", "rounding over contact; 1 and more is Hertz' contact", "none"},
    [RESULT_AP_OVER_THETA_B] = {"AP_over_theta_b", "load A P/(theta b)", "none"},
    [RESULT_P0] = {"p0", "peak pressure, at x = 0", "stress"},
    [RESULT_P_TRANSITION] = {"p_transition", "pressure where the rounding meets the flank, x = a",
                             "stress"},
    [RESULT_Q_OVER_FP] = {"Q_over_fP", "tangential force over its sliding value", "none"},
    [RESULT_C] = {"c", "half-width of the stick zone", "length"},
    [RESULT_C_OVER_B] = {"c_over_b", "stick zone over contact; 0 slides", "none"},
    [RESULT_LEFT] = {"left", "left edge of the contact", "length"},
    [RESULT_RIGHT] = {"right", "right edge of the contact", "length"},
    [RESULT_STICK_LEFT] = {"stick_left", "left edge of the stick zone", "length"},
    [RESULT_STICK_RIGHT] = {"stick_right", "right edge of the stick zone", "length"},
    [RESULT_TILT] = {"tilt", "angle by which the moment tilts body 2, in radians", "rad"},
    [RESULT_TENSION] = {"max_tension", "tension at the trailing edge under P and Q", "stress"},
    [RESULT_TENSION_SLIDING] = {"max_tension_sliding", "the same in full sliding, Q = f P",
                                "stress"},
    [RESULT_VON_MISES_SLIDING] = {"von_mises_sliding", "largest von Mises stress in full sliding",
                                  "stress"},
    [RESULT_F_CRITICAL] = {"f_critical", "friction from which on yield starts at the surface",
                           "none"},
    [RESULT_LOAD_OVER_BK] = {"load_over_bk", "load P/(bk)", "none"},
    [RESULT_P_OVER_BK] = {"P_over_bk", "elastic limit of P/(bk) for this a/b in full sliding",
                          "none"},
    [RESULT_P_YIELD] = {"P_yield", "P at first yield in full sliding", "force/length"},
    [RESULT_SAFETY] = {"safety", "P_yield/P: below 1 it yields in full sliding", "none"},
    [RESULT_YIELD_X] = {"yield_x", "where it yields first, under P_yield", "length"},
    [RESULT_YIELD_Y] = {"yield_y", "and how deep", "length"},
    [RESULT_YIELD_BRANCH] = {"yield_branch", "surface or subsurface", "text"},
    [RESULT_YIELD_FACTOR] = {"yield_factor", "k over the largest sqrt(J2) under P and Q", "none"},
    [RESULT_WARNINGS] = {"warnings", "what makes these numbers doubtful", "text"},
};

bool results_include(results_wanted wanted, int result)
{
    if (result == RESULT_YIELD_FACTOR)
        return wanted.yield_factor;
    return wanted.edges || result < RESULT_LEFT || result > RESULT_TILT;
}

static const double SQRT_3 = 1.7320508075688772;

static bool not_computed(const char *what, const char *why, char complaint[COMPLAINT_SIZE])
{
    snprintf(complaint, COMPLAINT_SIZE, "%s: %s", what, why);
    return false;
}

static void geometry(const contact_case *what, double b, cell row[])
{
    const double alpha = what->a / b, unit = what->theta / what->A;
    row[RESULT_A] = cell_number(what->A);
    row[RESULT_BETA] = cell_number(what->beta);
    row[RESULT_ROUNDING] = cell_number(what->a);
    row[RESULT_RADIUS] = cell_number(rwedge_radius(what->theta, what->a));
    row[RESULT_B] = cell_number(b);
    row[RESULT_A_OVER_B] = cell_number(alpha);
    row[RESULT_AP_OVER_THETA_B] = cell_number(rwedge_load(alpha));
    row[RESULT_P0] = cell_number(unit * rwedge_peak_pressure(alpha));
    row[RESULT_P_TRANSITION] = cell_number(unit * rwedge_transition_pressure(alpha));
    row[RESULT_LEFT] = cell_number(-b);
    row[RESULT_RIGHT] = cell_number(b);
    row[RESULT_TILT] = cell_number(0);
}

/* Without friction there is neither stick nor slip to speak of. */
static bool friction(const contact_case *what, double b, cell row[], char complaint[COMPLAINT_SIZE])
{
    const double alpha = what->a / b, ratio = case_shear_ratio(what);
    const double c = rwedge_stick_width(alpha, fabs(ratio));
    double sxx = 0, syy, txy;
    if (ratio != 0) {
        const int32_t status = rwedge_stress(alpha, what->f, c, -1, 0, &sxx, &syy, &txy);
        if (status != RWEDGE_OK)
            return not_computed("max_tension", rwedge_strerror(status), complaint);
    }
    const bool rough = what->f > 0;
    row[RESULT_Q_OVER_FP] = rough ? cell_number(ratio) : cell_empty();
    row[RESULT_C] = rough ? cell_number(c * b) : cell_empty();
    row[RESULT_C_OVER_B] = rough ? cell_number(c) : cell_empty();
    row[RESULT_STICK_LEFT] = rough && c > 0 ? cell_number(-c * b) : cell_empty();
    row[RESULT_STICK_RIGHT] = rough && c > 0 ? cell_number(c * b) : cell_empty();
    row[RESULT_TENSION] = cell_number(what->theta / what->A * sxx);
    return true;
}

/* Where it yields once P has grown to P_yield: the contact grows on the way. Q < 0 is the mirror
 * image. */
static bool yield_place(const contact_case *what, double P_yield, cell row[],
                        char complaint[COMPLAINT_SIZE])
{
    const double b = rwedge_half_width(what->theta, what->a, what->A, P_yield);
    const double alpha = b > 0 ? what->a / b : 0;
    double limit, x, y;
    const int32_t status = rwedge_yield_point(alpha, what->f, what->nu1, &limit, &x, &y);
    if (status != RWEDGE_OK)
        return not_computed("yield_x", rwedge_strerror(status), complaint);
    row[RESULT_YIELD_X] = cell_number(what->Q < 0 ? -x * b : x * b);
    row[RESULT_YIELD_Y] = cell_number(y * b);
    row[RESULT_YIELD_BRANCH] = cell_text(y > 0 ? "subsurface" : "surface");
    return true;
}

/* The library looks for first yield up to this b/a. */
static const double WIDTH_MOST = 1e14;

/* Where no load yields as far as the library looks: the load there, as a power of ten, is a
 * bound. */
static void bound_safety(const contact_case *what, results *found)
{
    const double most = rwedge_normal_load(what->theta, what->a, what->A, WIDTH_MOST * what->a);
    if (isfinite(most)) {
        snprintf(found->bound, sizeof found->bound, "> 1e%.0f", floor(log10(most / what->P)));
        found->value[RESULT_SAFETY] = cell_text(found->bound);
    }
    results_warn(found, "nothing yields before the contact is 1e14 a wide: safety is a bound");
}

static bool strength(const contact_case *what, double b, cell row[], char complaint[COMPLAINT_SIZE])
{
    const double alpha = what->a / b;
    const double limit = rwedge_elastic_limit(alpha, what->f, what->nu1);
    row[RESULT_TENSION_SLIDING] = cell_number(what->f * what->P / b * rwedge_max_tension(alpha));
    row[RESULT_VON_MISES_SLIDING] = cell_number(SQRT_3 * what->P / b / limit);
    row[RESULT_F_CRITICAL] =
        alpha > 0 ? cell_number(rwedge_critical_friction(alpha, what->nu1)) : cell_empty();
    row[RESULT_P_OVER_BK] = cell_number(limit);
    if (isnan(what->k))
        return true;
    const double P_yield =
        rwedge_yield_load(what->theta, what->a, what->A, what->f, what->nu1, what->k);
    if (isnan(P_yield))
        return not_computed("P_yield", rwedge_strerror(RWEDGE_ERANGE), complaint);
    row[RESULT_LOAD_OVER_BK] = cell_number(what->P / b / what->k);
    row[RESULT_P_YIELD] = cell_number(P_yield);
    row[RESULT_SAFETY] = cell_number(P_yield / what->P);
    return isinf(P_yield) ? true : yield_place(what, P_yield, row, complaint);
}

static bool yield_factor(const contact_case *what, cell row[], char complaint[COMPLAINT_SIZE])
{
    rwedge_contact *contact = NULL;
    double factor;
    int32_t status = case_loaded(what, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, what->nu1, what->k, &factor, NULL, NULL);
    rwedge_contact_destroy(contact);
    if (status != RWEDGE_OK)
        return not_computed("yield_factor", rwedge_strerror(status), complaint);
    row[RESULT_YIELD_FACTOR] = cell_number(factor);
    return true;
}

static bool compute(const contact_case *what, double b, cell row[], char complaint[COMPLAINT_SIZE])
{
    const bool centred = what->M == 0 && what->sigma == 0;
    geometry(what, b, row);
    if (centred && what->after == NULL)
        return friction(what, b, row, complaint) && strength(what, b, row, complaint);
    const int32_t status = results_of_state(what, row);
    if (status != RWEDGE_OK)
        return not_computed("left", rwedge_strerror(status), complaint);
    return !centred || strength(what, b, row, complaint);
}

bool results_compute(const contact_case *what, results_wanted wanted, results *found,
                     char complaint[COMPLAINT_SIZE])
{
    for (int i = 0; i < RESULT_COUNT; i++)
        found->value[i] = cell_empty();
    const double b = rwedge_half_width(what->theta, what->a, what->A, what->P);
    if (!isnormal(b) || !isfinite(what->a / b))
        return not_computed("b", "so large or small that results leave 1e-60 to 1e60", complaint);
    if (!compute(what, b, found->value, complaint) ||
        (wanted.yield_factor && !isnan(what->k) && !yield_factor(what, found->value, complaint)))
        return false;
    const double safety = found->value[RESULT_SAFETY].number; /* NAN where it is empty */
    found->doubts = doubts_of(what, found->value[RESULT_B].number, safety);
    found->warnings[0] = '\0';
    doubts_write(found->doubts, found->warnings, sizeof found->warnings);
    if (isinf(safety))
        bound_safety(what, found);
    found->value[RESULT_WARNINGS] = cell_text(found->warnings);
    return true;
}

void results_warn(results *found, const char *warning)
{
    list_add(found->warnings, sizeof found->warnings, "; ", "%s", warning);
}
