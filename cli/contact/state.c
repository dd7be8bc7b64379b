/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "state.h"

#include "notices.h"
#include "model/contact_case.h"
#include "model/doubts.h"
#include "text/message.h"
#include "options/variable.h"

#include <math.h>

static struct poptOption loads_option_table[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, load_option_table, 0, NULL, NULL},
    {"a-over-b", '\0', POPT_ARG_STRING, NULL, OPTION_A_OVER_B,
     "Natural units instead of bodies and loads: rounding over contact", "NUMBER"},
    {"q-over-fp", '\0', POPT_ARG_STRING, NULL, OPTION_Q_OVER_FP,
     "With --a-over-b: tangential force over its sliding value, 0 to 1 (default 0)", "NUMBER"},
    {"c-over-b", '\0', POPT_ARG_STRING, NULL, OPTION_C_OVER_B,
     "With --a-over-b: or the stick zone over the contact, 0 to 1", "NUMBER"},
    POPT_TABLEEND,
};

struct poptOption state_option_table[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, input_option_table, 0, "The contact:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, strength_option_table, 0,
     "Its strength, to be warned of yield:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, loads_option_table, 0,
     "Its loads, or natural units:", NULL},
    POPT_TABLEEND,
};

void state_describe(FILE *stream)
{
    fputs("\nAny consistent units, or natural ones with --a-over-b, which goes with --f, --nu1\n"
          "(default 0.3), --M, --sigma, and --q-over-fp or --c-over-b: lengths are in b,\n"
          "stresses in theta/A, slip in theta b, a moment in theta b^2/A; b is that without\n"
          "the moment. A history runs in straight steps from load to load; without one, Q\n"
          "and sigma grow from 0 under constant P and M. x > 0 is the side that the friction\n"
          "on the half-plane, with Q > 0, points to; y is the depth.\n",
          stream);
}

/* Powers of two with theta/A = 1: natural units are exact. */
static const double NATURAL_THETA = 0.5, NATURAL_A = 0.5, NATURAL_NU = 0.3;

static const table_variable c_over_b = {"c-over-b", "c_over_b", "c/b", 0, 1, "a number from 0 to 1",
                                        "0"};

/* ---- Natural units ---- */

static int refuse_dimensional(const arguments *given, const input_texts *texts)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        char name[INPUT_NAME_SIZE];
        if (texts->text[i] != NULL && i != INPUT_F && i != INPUT_NU1 && i != INPUT_M &&
            i != INPUT_SIGMA)
            return usage_error("%s %s: given together with --a-over-b; allowed: --f, --nu1, --M, "
                               "--sigma, --q-over-fp, --c-over-b",
                               input_name(texts, i, name), texts->text[i]);
    }
    if (given->value[OPTION_LOAD] != NULL || given->value[OPTION_HISTORY] != NULL)
        return usage_error(
            "--%s: given together with --a-over-b; allowed: --q-over-fp or --c-over-b",
            given->value[OPTION_LOAD] != NULL ? "load" : "history");
    return STATUS_DONE;
}

/* Reads an input that may be left out. */
static int read_input(const input_texts *texts, int input, double usual, double *value)
{
    char complaint[COMPLAINT_SIZE];
    *value = usual;
    if (texts->text[input] != NULL && !input_read(texts, input, value, complaint))
        return usage_error("%s", complaint);
    return STATUS_DONE;
}

static int read_shear_ratio(const arguments *given, double alpha, double *ratio)
{
    const char *q = given->value[OPTION_Q_OVER_FP], *c = given->value[OPTION_C_OVER_B];
    *ratio = 0;
    if (q != NULL && c != NULL)
        return usage_error(
            "--c-over-b %s: given together with --q-over-fp; allowed: one of the two", c);
    if (q != NULL)
        return variable_read_one(&variables[Q_OVER_FP], q, ratio);
    double width = 1;
    const int status = c != NULL ? variable_read_one(&c_over_b, c, &width) : STATUS_DONE;
    *ratio = rwedge_shear_ratio(alpha, width);
    return status;
}

static int create(double theta, double a, double A, double f, contact_state *state)
{
    const int32_t status = rwedge_contact_create(theta, a, A, f, &state->contact);
    state->a = a;
    return status == RWEDGE_OK ? STATUS_DONE : failure("the contact: %s", rwedge_strerror(status));
}

/* b is the half-width that P has without a moment. */
static int read_natural_load(const arguments *given, const input_texts *texts, double alpha,
                             double f, load *to)
{
    double ratio;
    to->P = rwedge_load(alpha);
    int status = read_input(texts, INPUT_M, 0, &to->M);
    if (status == STATUS_DONE)
        status = read_input(texts, INPUT_SIGMA, 0, &to->sigma);
    if (status == STATUS_DONE && given->value[OPTION_C_OVER_B] != NULL &&
        (to->M != 0 || to->sigma != 0))
        status = usage_error("--c-over-b %s: not with --M or --sigma, which move the stick zone; "
                             "allowed: --q-over-fp",
                             given->value[OPTION_C_OVER_B]);
    if (status == STATUS_DONE)
        status = read_shear_ratio(given, alpha, &ratio);
    if (status == STATUS_DONE)
        to->Q = ratio * f * to->P;
    return status;
}

static int apply_natural(const input_texts *texts, double f, load to, contact_state *state)
{
    const int32_t status = loads_apply_monotonic(to, state->contact);
    if (status == RWEDGE_OK)
        return STATUS_DONE;
    char name[INPUT_NAME_SIZE];
    const load_fault fault = loads_fault(status, to, f, state->contact);
    const bool named = fault.input < INPUT_COUNT && texts->text[fault.input] != NULL;
    return usage_error("%s%s%s: %s", named ? input_name(texts, fault.input, name) : "the loads",
                       named ? " " : "", named ? texts->text[fault.input] : "", fault.why);
}

/* Without a moment the half-width is 1 to rounding, and the edges are at 1 exactly. */
static void measure_natural(bool centred, contact_state *state)
{
    const zone contact = state_contact_zone(state);
    const double b = rwedge_contact_half_width(state->contact);
    state->b = centred ? 1 : b;
    state->left = centred ? -1 : contact.left;
    state->right = centred ? 1 : contact.right;
    state->length_unit = centred ? b : 1;
    state->slip_unit = NATURAL_THETA * state->length_unit;
}

static int read_natural(const arguments *given, const input_texts *texts, contact_state *state)
{
    double alpha, f;
    load to;
    int status = refuse_dimensional(given, texts);
    if (status == STATUS_DONE)
        status = variable_read_one(&variables[A_OVER_B], given->value[OPTION_A_OVER_B], &alpha);
    if (status == STATUS_DONE)
        status = read_input(texts, INPUT_F, 0, &f);
    if (status == STATUS_DONE)
        status = read_input(texts, INPUT_NU1, NATURAL_NU, &state->nu);
    if (status == STATUS_DONE)
        status = read_natural_load(given, texts, alpha, f, &to);
    if (status == STATUS_DONE)
        status = create(NATURAL_THETA, alpha, NATURAL_A, f, state);
    if (status == STATUS_DONE)
        status = apply_natural(texts, f, to, state);
    if (status == STATUS_DONE)
        measure_natural(to.M == 0, state);
    return status;
}

/* ---- Dimensional ---- */

static int apply_case(const contact_case *what, contact_state *state)
{
    const int32_t status = loads_apply_monotonic(case_load(what), state->contact);
    return status == RWEDGE_OK
               ? STATUS_DONE
               : failure("the loads cannot be applied: %s", rwedge_strerror(status));
}

static int refuse_natural(const arguments *given)
{
    for (int i = OPTION_Q_OVER_FP; i <= OPTION_C_OVER_B; i++)
        if (given->value[i] != NULL)
            return usage_error("--%s %s: needs --a-over-b; allowed with bodies and loads: --Q",
                               i == OPTION_C_OVER_B ? "c-over-b" : "q-over-fp", given->value[i]);
    return STATUS_DONE;
}

/* P_yield/P, where there is a strength and a load. */
static double safety_of(const contact_case *what, double b)
{
    return rwedge_yield_load(what->theta, what->a, what->A, what->f, what->nu1, what->k) /
           rwedge_normal_load(what->theta, what->a, what->A, b);
}

static int read_dimensional(const arguments *given, char decimal_sign, const input_texts *texts,
                            contact_state *state)
{
    contact_case what;
    char complaint[COMPLAINT_SIZE];
    const load_source from = load_source_of(given);
    const bool has_history = load_source_is_given(&from);
    int status = load_source_check(&from, texts);
    if (status == STATUS_DONE)
        status = refuse_natural(given);
    if (status == STATUS_DONE &&
        !case_read(texts, has_history ? CASE_LOADS_APART : CASE_WITH_LOADS, &what, complaint))
        status = usage_error("%s", complaint);
    if (status == STATUS_DONE)
        status = create(what.theta, what.a, what.A, what.f, state);
    if (status == STATUS_DONE)
        status = has_history ? load_source_apply(&from, decimal_sign, what.f, state->contact)
                             : apply_case(&what, state);
    if (status != STATUS_DONE)
        return status;
    state->nu = what.nu1;
    const zone contact = state_contact_zone(state);
    state->b = rwedge_contact_half_width(state->contact);
    state->left = contact.left;
    state->right = contact.right;
    state->length_unit = state->slip_unit = 1;
    doubts_say(doubts_of(&what, state->b, safety_of(&what, state->b)), "");
    return STATUS_DONE;
}

int state_read(const arguments *given, char decimal_sign, contact_state *state)
{
    input_texts texts;
    *state = (contact_state){0};
    input_texts_from_options(given, &texts);
    const load_source from = load_source_of(given);
    const int status = load_source_check_encoding(&from);
    if (status != STATUS_DONE)
        return status;
    if (given->value[OPTION_A_OVER_B] != NULL)
        return read_natural(given, &texts, state);
    return read_dimensional(given, decimal_sign, &texts, state);
}

zone state_contact_zone(const contact_state *state)
{
    zone found = {0, 0};
    rwedge_contact_edges(state->contact, &found.left, &found.right);
    return found;
}

zone state_stick_zone(const contact_state *state)
{
    zone found = {0, 0};
    rwedge_contact_stick_zone(state->contact, &found.left, &found.right);
    return found;
}

void state_free(contact_state *state)
{
    rwedge_contact_destroy(state->contact);
}

bool state_is_apex(const contact_state *state, double x, double y)
{
    return state->a == 0 && state->b > 0 && x == 0 && y == 0;
}
