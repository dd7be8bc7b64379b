/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>
#include <stdio.h>

const column_kind result_kinds[RESULT_COUNT] = {
    [RESULT_A] = {"A", "composite compliance", "1/stress"},
    [RESULT_BETA] = {"dundurs_beta", "Dundurs' beta; 0 for elastically similar bodies", "none"},
    [RESULT_ROUNDING] = {"a", "half-width of the rounding", "length"},
    [RESULT_RADIUS] = {"radius", "radius of the rounding", "length"},
    [RESULT_B] = {"b", "half-width of the contact", "length"},
    [RESULT_A_OVER_B] = {"a_over_b", "rounding over contact; 1 and more is Hertz' contact", "none"},
    [RESULT_AP_OVER_THETA_B] = {"AP_over_theta_b", "load A P/(theta b)", "none"},
    [RESULT_P0] = {"p0", "largest pressure, at p0_x; empty where it is infinite", "stress"},
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
    [RESULT_MOMENT] = {"moment", "M that holds the pad at the tilt", "force"},
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
    [RESULT_P0_X] = {"p0_x", "where the pressure is largest", "length"},
    [RESULT_P_SHAKEDOWN] = {"P_shakedown", "P that is carried pass after pass in full sliding",
                            "force/length"},
    [RESULT_SAFETY_SHAKEDOWN] = {"safety_shakedown",
                                 "P_shakedown/P: below 1 it goes on yielding in each pass", "none"},
    [RESULT_MU] = {"mu", "-dundurs_beta f, or dundurs_beta f where Q < 0", "none"},
    [RESULT_SWING] = {"swing", "how far friction moves the contact, in b; < 0: trailing", "none"},
};

/* Edges need moment or tension; the yield factor and shakedown take longest. The others are for
 * everybody. */
static const enum {
    NEEDS_NOTHING,
    NEEDS_EDGES,
    NEEDS_YIELD_FACTOR,
    NEEDS_SHAKEDOWN,
    NEEDS_TILT,
    NEEDS_COUPLING
} needs[RESULT_COUNT] = {
    [RESULT_LEFT] = NEEDS_EDGES,
    [RESULT_RIGHT] = NEEDS_EDGES,
    [RESULT_STICK_LEFT] = NEEDS_EDGES,
    [RESULT_STICK_RIGHT] = NEEDS_EDGES,
    [RESULT_TILT] = NEEDS_EDGES,
    [RESULT_MOMENT] = NEEDS_TILT,
    [RESULT_YIELD_FACTOR] = NEEDS_YIELD_FACTOR,
    [RESULT_P_SHAKEDOWN] = NEEDS_SHAKEDOWN,
    [RESULT_SAFETY_SHAKEDOWN] = NEEDS_SHAKEDOWN,
    [RESULT_MU] = NEEDS_COUPLING,
    [RESULT_SWING] = NEEDS_COUPLING,
};

bool results_include(results_wanted wanted, int result)
{
    return needs[result] == NEEDS_EDGES          ? wanted.edges
           : needs[result] == NEEDS_YIELD_FACTOR ? wanted.yield_factor
           : needs[result] == NEEDS_SHAKEDOWN    ? wanted.shakedown
           : needs[result] == NEEDS_TILT         ? wanted.moment
           : needs[result] == NEEDS_COUPLING     ? wanted.coupling
                                                 : true;
}

/* The pressure is NAN where it is infinite, or not known. */
static void put_peak(double pressure, double x, cell row[])
{
    row[RESULT_P0] = cell_number(pressure);
    row[RESULT_P0_X] = isnan(pressure) ? cell_text("") : cell_number(x);
}

/* Sizes of the contact under P alone, whose half-width is b. */
static void geometry(const contact_case *setup, double b, cell row[])
{
    const pad *shape = &setup->shape;
    const double alpha = shape->a / b, unit = shape->theta / setup->A;
    row[RESULT_A] = cell_number(setup->A);
    row[RESULT_BETA] = cell_number(setup->beta);
    row[RESULT_RADIUS] = cell_number(shape->radius);
    row[RESULT_B] = cell_number(b);
    put_peak(unit * rwedge_peak_pressure(alpha), 0, row);
    if (shape->kind == PAD_WEDGE) {
        row[RESULT_ROUNDING] = cell_number(shape->a);
        row[RESULT_A_OVER_B] = cell_number(alpha);
        row[RESULT_AP_OVER_THETA_B] = cell_number(rwedge_load(alpha));
        row[RESULT_P_TRANSITION] = cell_number(unit * rwedge_transition_pressure(alpha));
    }
}

static void put_contact(double left, double right, double tilt, cell row[])
{
    row[RESULT_LEFT] = cell_number(left);
    row[RESULT_RIGHT] = cell_number(right);
    row[RESULT_TILT] = cell_number(tilt);
}

/* Without friction there is neither stick nor slip to speak of. */
static void put_friction(const contact_case *setup, double c, double c_over_b, double left,
                         double right, cell row[])
{
    if (setup->f == 0)
        return;
    row[RESULT_Q_OVER_FP] = cell_number(case_shear_ratio(setup));
    row[RESULT_C] = cell_number(c);
    row[RESULT_C_OVER_B] = cell_number(c_over_b);
    if (!(left < right))
        return;
    row[RESULT_STICK_LEFT] = cell_number(left);
    row[RESULT_STICK_RIGHT] = cell_number(right);
}

/* ---- Under a moment or a tension, after a history, and of pads without formulas ---- */

/* Returns the library's status. */
static int32_t put_peak_of(const rwedge_contact *contact, cell row[])
{
    double pressure = NAN, x = NAN;
    const int32_t status = rwedge_contact_peak_pressure(contact, &pressure, &x);
    put_peak(pressure, x, row);
    return status == RWEDGE_EABSENT ? RWEDGE_OK : status;
}

/* The formulas of the wedge hold for similar bodies. */
static bool has_formulas(const contact_case *setup)
{
    return pad_has_formulas(&setup->shape) && !setup->is_coupled;
}

/* Corrects the results of geometry(): the pressures at x = -a and a differ under a moment. Returns
 * the library's status. */
static int32_t results_of_state(const contact_case *setup, cell row[])
{
    const rwedge_contact *contact = setup->contact;
    const bool is_other = setup->M != 0 || !has_formulas(setup);
    double edge[2], sxx[2], left = 0, right = 0;
    int32_t status = setup->status == RWEDGE_OK ? edge_tensions(contact, edge, sxx) : setup->status;
    if (status != RWEDGE_OK)
        return status;
    const double b = rwedge_contact_half_width(contact),
                 c = rwedge_contact_stick_half_width(contact);
    if (is_other) {
        row[RESULT_B] = cell_number(b);
        row[RESULT_P_TRANSITION] = cell_text("");
        status = put_peak_of(contact, row);
    }
    if (status != RWEDGE_OK)
        return status;
    if (is_other && setup->shape.kind == PAD_WEDGE) {
        row[RESULT_A_OVER_B] = cell_number(setup->shape.a / b);
        row[RESULT_AP_OVER_THETA_B] = cell_number(setup->A * setup->P / (setup->shape.theta * b));
    }
    rwedge_contact_stick_zone(contact, &left, &right);
    put_contact(edge[0], edge[1], rwedge_contact_tilt(contact), row);
    row[RESULT_MOMENT] = cell_number(setup->M);
    put_friction(setup, c, c / b, left, right, row);
    row[RESULT_TENSION] = cell_number(fmax(sxx[0], sxx[1])); /* that of the trailing edge */
    if (!isnan(setup->k))
        row[RESULT_LOAD_OVER_BK] = cell_number(setup->P / b / setup->k);
    return RWEDGE_OK;
}

/* ---- By formulas ---- */

static bool state_by_formulas(const contact_case *setup, double b, cell row[], complaint *why)
{
    const double alpha = setup->shape.a / b, ratio = case_shear_ratio(setup);
    const double c = rwedge_stick_width(alpha, fabs(ratio));
    double sxx = 0, syy, txy;
    if (ratio != 0) {
        const int32_t status = rwedge_stress(alpha, setup->f, c, -1, 0, &sxx, &syy, &txy);
        if (status != RWEDGE_OK)
            return complain(why, "max_tension: %s", rwedge_strerror(status));
    }
    put_contact(-b, b, 0, row);
    put_friction(setup, c * b, c, -c * b, c * b, row);
    row[RESULT_TENSION] = cell_number(setup->shape.theta / setup->A * sxx);
    return true;
}

/* Where it yields once P has grown to P_yield: the contact grows on the way. Q < 0 is the mirror
 * image. */
static bool yield_place(const contact_case *setup, double P_yield, cell row[], complaint *why)
{
    const pad *shape = &setup->shape;
    const double b = rwedge_half_width(shape->theta, shape->a, setup->A, P_yield);
    const double alpha = b > 0 ? shape->a / b : 0;
    double limit, x, y;
    const int32_t status = rwedge_yield_point(alpha, setup->f, setup->nu1, &limit, &x, &y);
    if (status != RWEDGE_OK)
        return complain(why, "yield_x: %s", rwedge_strerror(status));
    yield_place_settle(&x, &y);
    row[RESULT_YIELD_X] = cell_number(setup->Q < 0 ? -x * b : x * b);
    row[RESULT_YIELD_Y] = cell_number(y * b);
    row[RESULT_YIELD_BRANCH] = cell_text(y > 0 ? "subsurface" : "surface");
    return true;
}

/* The library looks for first yield up to this b/a. */
static const double WIDTH_MOST = 1e14;

/* The bound where no load yields as far as the library looks: the load there, as a power of ten. */
static void bound_safety(const contact_case *setup, results *answer)
{
    const pad *shape = &setup->shape;
    const double most = rwedge_normal_load(shape->theta, shape->a, setup->A, WIDTH_MOST * shape->a);
    if (isfinite(most)) {
        snprintf(answer->bound, sizeof answer->bound, "> 1e%.0f", floor(log10(most / setup->P)));
        answer->value[RESULT_SAFETY] = cell_text(answer->bound);
    }
    results_warn(answer, "nothing yields before the contact is 1e14 a wide: safety is a bound");
}

static bool strength(const contact_case *setup, double b, cell row[], complaint *why)
{
    const pad *shape = &setup->shape;
    const double alpha = shape->a / b;
    const double limit = rwedge_elastic_limit(alpha, setup->f, setup->nu1);
    row[RESULT_TENSION_SLIDING] = cell_number(setup->f * setup->P / b * rwedge_max_tension(alpha));
    row[RESULT_VON_MISES_SLIDING] = cell_number(SQRT_3 * setup->P / b / limit);
    row[RESULT_F_CRITICAL] =
        alpha > 0 ? cell_number(rwedge_critical_friction(alpha, setup->nu1)) : cell_text("");
    row[RESULT_P_OVER_BK] = cell_number(limit);
    if (isnan(setup->k))
        return true;
    const double P_yield =
        rwedge_yield_load(shape->theta, shape->a, setup->A, setup->f, setup->nu1, setup->k);
    if (isnan(P_yield))
        return complain(why, "P_yield: %s", rwedge_strerror(RWEDGE_ERANGE));
    row[RESULT_LOAD_OVER_BK] = cell_number(setup->P / b / setup->k);
    if (shape->kind == PAD_CYLINDER &&
        !(rwedge_half_width(shape->theta, shape->a, setup->A, P_yield) <= shape->radius))
        return true;
    row[RESULT_P_YIELD] = cell_number(P_yield);
    row[RESULT_SAFETY] = cell_number(P_yield / setup->P);
    return isinf(P_yield) ? true : yield_place(setup, P_yield, row, why);
}

int32_t results_find_hardest(const contact_case *setup, results *answer)
{
    const bool strong = !isnan(setup->k);
    const double k = strong ? setup->k : 1 / setup->A;
    double factor;
    int32_t status = setup->status;
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(setup->contact, setup->nu1, k, &factor,
                                             &answer->hardest_x, &answer->hardest_y);
    if (status != RWEDGE_OK)
        return status;
    yield_place_settle(&answer->hardest_x, &answer->hardest_y);
    answer->value[RESULT_YIELD_FACTOR] = strong ? cell_number(factor) : cell_text("");
    answer->hardest_von_mises = SQRT_3 * k / factor;
    return RWEDGE_OK;
}

double results_sliding_factor(const results *answer)
{
    const cell limit = answer->value[RESULT_P_OVER_BK], now = answer->value[RESULT_LOAD_OVER_BK];
    return limit.text == NULL && now.text == NULL ? limit.number / now.number : NAN;
}

/* Whether what is of full sliding belongs to this contact: without moment and tension. The moment
 * of a pad that is held level is a result. */
static bool has_sliding(const contact_case *setup)
{
    const bool is_level = setup->is_coupled && setup->is_held && setup->tilt == 0;
    return setup->sigma == 0 && (setup->M == 0 || is_level);
}

static void add_coupling(const contact_case *setup, results *answer)
{
    const coupling of = coupling_of(setup, setup->contact, setup->has_history);
    answer->value[RESULT_MU] = cell_number((setup->Q < 0 ? 1 : -1) * setup->beta * setup->f);
    answer->value[RESULT_SWING] = isnan(of.swing) ? cell_text("") : cell_number(of.swing);
    answer->doubts.coupled = of;
}

static const char beyond_pad[] = "the contact would reach farther than the radius, or results "
                                 "leave 1e-60 to 1e60";

static bool compute(const contact_case *setup, double b, results *answer, complaint *why)
{
    cell *row = answer->value;
    const bool is_formula = has_formulas(setup), slides_centred = has_sliding(setup);
    geometry(setup, b, row);
    if (is_formula && slides_centred && !setup->has_history && !setup->is_held)
        return state_by_formulas(setup, b, row, why) && strength(setup, b, row, why);
    int32_t status = results_of_state(setup, row);
    if (status == RWEDGE_OK && slides_centred && !is_formula)
        status = results_of_sliding(setup, row);
    if (status == RWEDGE_ENOCONV && status == setup->status) {
        const load to = {.P = setup->P, .M = setup->M, .Q = setup->Q, .sigma = setup->sigma};
        const load_fault fault = loads_fault(status, to, setup->f, setup->contact);
        return complain(why, "the loads: %s", fault.why.text);
    }
    if (status != RWEDGE_OK)
        return complain(why, "left: %s",
                        status == RWEDGE_ERANGE && setup->shape.kind != PAD_WEDGE
                            ? beyond_pad
                            : rwedge_strerror(status));
    answer->doubts = doubts_of_error(setup->contact);
    if (setup->is_coupled)
        add_coupling(setup, answer);
    return !slides_centred || !is_formula || strength(setup, b, row, why);
}

/* The columns are there where P_yield is: in full sliding, without moment and tension; in plane
 * strain. They are empty where the library finds no load that is too large. */
static void add_shakedown(const contact_case *setup, results *answer)
{
    const pad *shape = &setup->shape;
    if (isnan(setup->k) || !has_sliding(setup) || setup->is_plane_stress)
        return;
    const double P = has_formulas(setup) ? rwedge_shakedown_load(shape->theta, shape->a, setup->A,
                                                                 setup->f, setup->nu1, setup->k)
                                         : sliding_shakedown(setup);
    if (!isfinite(P) ||
        (shape->kind == PAD_CYLINDER && !(pad_half_width(shape, setup->A, P) <= shape->radius)))
        return;
    answer->value[RESULT_P_SHAKEDOWN] = cell_number(P);
    answer->value[RESULT_SAFETY_SHAKEDOWN] = cell_number(P / setup->P);
}

static bool yield_factor(const contact_case *setup, results *answer, complaint *why)
{
    const int32_t status = results_find_hardest(setup, answer);
    return status == RWEDGE_OK || complain(why, "yield_factor: %s", rwedge_strerror(status));
}

bool results_compute(const contact_case *setup, results_wanted wanted, results *answer,
                     complaint *why)
{
    for (int i = 0; i < RESULT_COUNT; i++)
        answer->value[i] = cell_text("");
    const pad *shape = &setup->shape;
    const double b = pad_half_width(shape, setup->A, setup->P);
    if (isnan(b) && shape->kind != PAD_WEDGE)
        return complain(why, "b: %s", beyond_pad);
    if (!isnormal(b) || isinf(shape->a / b))
        return complain(why, "b: %s", "so large or small that results leave 1e-60 to 1e60");
    answer->doubts = (doubts){0};
    answer->is_of_body2 = false;
    if (!compute(setup, b, answer, why) ||
        (wanted.yield_factor && !isnan(setup->k) && !yield_factor(setup, answer, why)))
        return false;
    if (wanted.shakedown)
        add_shakedown(setup, answer);
    const double safety = answer->value[RESULT_SAFETY].number; /* NAN where it is empty */
    doubts_add(&answer->doubts, doubts_of(setup, answer->value[RESULT_LEFT].number,
                                          answer->value[RESULT_RIGHT].number, safety));
    answer->doubts.bits |= doubt_of_zones(setup->contact);
    answer->warnings[0] = '\0';
    answer->is_doubtful = doubts_matter(answer->doubts);
    doubts_write(answer->doubts, answer->warnings, sizeof answer->warnings);
    if (isinf(safety))
        bound_safety(setup, answer);
    if (shape->kind != PAD_WEDGE && isnan(safety) && !isnan(setup->k) && setup->M == 0 &&
        setup->sigma == 0)
        results_warn(answer, "nothing yields as far as the pad is known: there is no safety");
    answer->value[RESULT_WARNINGS] = cell_text(answer->warnings);
    return true;
}

void results_warn(results *answer, const char *warning)
{
    answer->is_doubtful = true;
    list_add(answer->warnings, sizeof answer->warnings, "; ", "%s", warning);
}
