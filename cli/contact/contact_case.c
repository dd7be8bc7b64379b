/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact_case.h"

#include "text/list.h"
#include "text/number.h"

#include <math.h>

#include <rwedge.h>

static const double RADIANS_PER_DEGREE = 0.017453292519943295, SQRT_3 = 1.7320508075688772;

/* Two ways to give the same; the second is -1 where there is one way only. */
typedef struct {
    int one, other;
} alternatives;

static const alternatives ways[] = {
    {INPUT_E1, -1}, {INPUT_NU1, -1}, {INPUT_THETA, INPUT_THETA_DEG}, {INPUT_A, INPUT_RADIUS},
    {INPUT_P, -1},  {INPUT_F, -1},   {INPUT_K, INPUT_YIELD_STRESS},
};
enum { WAY_COUNT = sizeof ways / sizeof ways[0] };

static bool excluded(const input_texts *given, int one, int other, char complaint[COMPLAINT_SIZE])
{
    char first[INPUT_NAME_SIZE], second[INPUT_NAME_SIZE];
    snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: given together with %s; allowed: one of the two",
             input_name(given, other, second), given->text[other], input_name(given, one, first));
    return false;
}

static bool is_needed(const input_texts *given, int input, case_needs needs)
{
    if (input == INPUT_K)
        return false;
    if (input == INPUT_P)
        return needs == CASE_WITH_LOADS || needs == CASE_OF_SOLVE;
    if (input == INPUT_F && needs == CASE_OF_COURSE)
        return true;
    if (input == INPUT_F)
        return needs == CASE_OF_SOLVE &&
               (input_is_given(given, INPUT_Q) || input_is_given(given, INPUT_SIGMA) ||
                input_is_given(given, INPUT_K) || input_is_given(given, INPUT_YIELD_STRESS));
    return true;
}

/* Adds it to the list of what is missing. */
static void add_missing(const input_texts *given, const alternatives *way,
                        char complaint[COMPLAINT_SIZE])
{
    char first[INPUT_NAME_SIZE], second[INPUT_NAME_SIZE];
    const bool two = way->other >= 0;
    list_add(complaint, COMPLAINT_SIZE, complaint[0] == '\0' ? "" : ", ", "%s%s%s%s",
             complaint[0] == '\0' ? "missing: " : "", input_name(given, way->one, first),
             two ? " or " : "", two ? input_name(given, way->other, second) : "");
}

/* Body 2 is given whole or not at all: a guess would look like a result. */
static bool second_body_is_whole(const input_texts *given, char complaint[COMPLAINT_SIZE])
{
    char name[INPUT_NAME_SIZE], other[INPUT_NAME_SIZE];
    const bool E2 = input_is_given(given, INPUT_E2), nu2 = input_is_given(given, INPUT_NU2);
    if (E2 == nu2)
        return true;
    double value;
    if (E2 && !input_read(given, INPUT_E2, &value, complaint))
        return false;
    if (E2 && isinf(value)) /* a rigid body has no Poisson's ratio */
        return true;
    const int there = E2 ? INPUT_E2 : INPUT_NU2, absent = E2 ? INPUT_NU2 : INPUT_E2;
    snprintf(complaint, COMPLAINT_SIZE,
             "%s %.60s: needs %s; allowed: both, or neither for two bodies of one material",
             input_name(given, there, name), given->text[there], input_name(given, absent, other));
    return false;
}

bool case_is_complete(const input_texts *given, case_needs needs, char complaint[COMPLAINT_SIZE])
{
    bool cells = false, friction = false;
    complaint[0] = '\0';
    for (int i = 0; i < WAY_COUNT; i++) {
        const bool one = input_is_given(given, ways[i].one);
        const bool other = ways[i].other >= 0 && input_is_given(given, ways[i].other);
        if (one && other)
            return excluded(given, ways[i].one, ways[i].other, complaint);
        if (one || other || !is_needed(given, ways[i].one, needs))
            continue;
        add_missing(given, &ways[i], complaint);
        cells = cells || given->is_cell[ways[i].one];
        friction = friction || ways[i].one == INPUT_F;
    }
    if (friction)
        list_add(complaint, COMPLAINT_SIZE, "; ", "friction has no default %s",
                 needs == CASE_OF_COURSE ? "here" : "where Q, sigma or a yield stress is given");
    if (cells)
        list_add(complaint, COMPLAINT_SIZE, "; ", "allowed: columns or options");
    return complaint[0] == '\0' && second_body_is_whole(given, complaint);
}

static double either(double one, double other)
{
    return isnan(one) ? other : one;
}

static void fill(const double value[INPUT_COUNT], contact_case *what)
{
    what->E1 = value[INPUT_E1];
    what->nu1 = value[INPUT_NU1];
    what->E2 = either(value[INPUT_E2], what->E1);
    what->nu2 = either(value[INPUT_NU2], what->nu1); /* of no effect where body 2 is rigid */
    what->theta = either(value[INPUT_THETA], value[INPUT_THETA_DEG] * RADIANS_PER_DEGREE);
    what->a = either(value[INPUT_A], rwedge_rounding(what->theta, value[INPUT_RADIUS]));
    what->P = either(value[INPUT_P], 0);
    what->M = either(value[INPUT_M], 0);
    what->Q = either(value[INPUT_Q], 0);
    what->sigma = either(value[INPUT_SIGMA], 0);
    what->f = either(value[INPUT_F], 0);
    what->k = either(value[INPUT_K], value[INPUT_YIELD_STRESS] / SQRT_3);
    what->A = rwedge_compliance(what->E1, what->nu1, what->E2, what->nu2);
    what->beta = rwedge_dundurs_beta(what->E1, what->nu1, what->E2, what->nu2);
    what->after = NULL;
}

int32_t case_contact(const contact_case *what, rwedge_contact **contact)
{
    *contact = NULL;
    return rwedge_contact_create(what->theta, what->a, what->A, what->f, contact);
}

load case_load(const contact_case *what)
{
    return (load){what->P, what->M, what->Q, what->sigma};
}

int32_t case_loaded(const contact_case *what, rwedge_contact **contact)
{
    if (what->after != NULL)
        return rwedge_contact_copy(what->after, contact);
    const int32_t status = case_contact(what, contact);
    return status == RWEDGE_OK ? loads_apply_monotonic(case_load(what), *contact) : status;
}

/* The library is asked to apply the loads, and so its tolerance counts. */
static load_fault fault_of_loads(const contact_case *what)
{
    rwedge_contact *contact = NULL;
    load_fault fault = {.input = INPUT_COUNT};
    if (case_contact(what, &contact) == RWEDGE_OK) {
        const int32_t status = loads_apply_monotonic(case_load(what), contact);
        if (status != RWEDGE_OK)
            fault = loads_fault(status, case_load(what), what->f, contact);
    }
    rwedge_contact_destroy(contact);
    return fault;
}

/* Whether the loads can be applied. What is beyond the range of numbers is told later. */
static bool has_equilibrium(const input_texts *given, const contact_case *what,
                            char complaint[COMPLAINT_SIZE])
{
    const load_fault fault = fault_of_loads(what);
    if (fault.input == INPUT_COUNT)
        return true;
    char name[INPUT_NAME_SIZE];
    snprintf(complaint, COMPLAINT_SIZE, "%s %.60s: %s%s", input_name(given, fault.input, name),
             given->text[fault.input], fault.why,
             fault.input != INPUT_Q || input_is_given(given, INPUT_F) ? "" : "; f is missing");
    return false;
}

bool case_read(const input_texts *given, case_needs needs, contact_case *what,
               char complaint[COMPLAINT_SIZE])
{
    if (!case_is_complete(given, needs, complaint))
        return false;
    double value[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++) {
        value[i] = NAN;
        if (input_is_given(given, i) && !input_read(given, i, &value[i], complaint))
            return false;
    }
    fill(value, what);
    if (!isnormal(what->A) || !isnormal(what->theta / what->A) || !isfinite(what->a)) {
        snprintf(
            complaint, COMPLAINT_SIZE,
            "the moduli and the rounding are so large or small that results leave 1e-60 to 1e60");
        return false;
    }
    return has_equilibrium(given, what, complaint);
}

double case_shear_ratio(const contact_case *what)
{
    const double limit = what->f * what->P;
    return what->Q == 0 || limit == 0 ? 0 : fmax(-1, fmin(1, what->Q / limit));
}
