/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

static struct poptOption loads_option_table[] = {
    {INCLUDED(load_option_table), NULL, NULL},
    {VALUE("a-over-b", OPTION_A_OVER_B),
     "Natural units instead of bodies and loads: rounding over contact", "NUMBER"},
    {VALUE("q-over-fp", OPTION_Q_OVER_FP),
     "With --a-over-b: tangential force over its sliding value, 0 to 1 (default 0)", "NUMBER"},
    {VALUE("c-over-b", OPTION_C_OVER_B),
     "With --a-over-b: or the stick zone over the contact, 0 to 1", "NUMBER"},
    POPT_TABLEEND,
};

struct poptOption loaded_contact_option_table[] = {
    {INCLUDED(input_option_table), "The contact:", NULL},
    {INCLUDED(strength_option_table), "Its strength, to be warned of yield:", NULL},
    {INCLUDED(loads_option_table), "Its loads, or natural units:", NULL},
    POPT_TABLEEND,
};

void loaded_contact_describe(FILE *stream)
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

/* ---- Natural units ---- */

static void refuse_dimensional(const arguments *line, const input_texts *texts)
{
    for (int i = 0; i < INPUT_COUNT; i++)
        if (texts->text[i] != NULL && i != INPUT_F && i != INPUT_NU1 && i != INPUT_M &&
            i != INPUT_SIGMA)
            usage_error("%s %s: given together with --a-over-b; allowed: --f, --nu1, --M, --sigma, "
                        "--q-over-fp, --c-over-b",
                        input_name(texts, i), texts->text[i]);
    if (line->value[OPTION_LOAD] != NULL || line->value[OPTION_HISTORY] != NULL)
        usage_error("--%s: given together with --a-over-b; allowed: --q-over-fp or --c-over-b",
                    line->value[OPTION_LOAD] != NULL ? "load" : "history");
}

/* Reads an input that may be left out. */
static double read_input(const input_texts *texts, int input, double usual)
{
    complaint why;
    double value = usual;
    if (input_is_given(texts, input) && !input_read(texts, input, &value, &why))
        usage_error("%s", why.text);
    return value;
}

/* b is the half-width that P has without a moment. */
static load read_natural_load(const arguments *line, const input_texts *texts, double alpha,
                              double f)
{
    const char *q = line->value[OPTION_Q_OVER_FP], *c = line->value[OPTION_C_OVER_B];
    load to = {.P = rwedge_load(alpha),
               .M = read_input(texts, INPUT_M, 0),
               .sigma = read_input(texts, INPUT_SIGMA, 0)};
    if (c != NULL && (to.M != 0 || to.sigma != 0))
        usage_error("--c-over-b %s: not with --M or --sigma, which move the stick zone; "
                    "allowed: --q-over-fp",
                    c);
    if (q != NULL && c != NULL)
        usage_error("--c-over-b %s: given together with --q-over-fp; allowed: one of the two", c);
    const double ratio =
        q != NULL
            ? variable_read_one(&variables[Q_OVER_FP], q)
            : rwedge_shear_ratio(alpha, c != NULL ? variable_read_one(&variables[C_OVER_B], c) : 1);
    to.Q = ratio * f * to.P;
    return to;
}

static void read_natural(const arguments *line, const input_texts *texts, loaded_contact *loaded)
{
    contact_case *setup = &loaded->setup;
    refuse_dimensional(line, texts);
    history_check(line);
    if (line->value[OPTION_ROTATION] != NULL || line->value[OPTION_SIMILAR] != NULL)
        usage_error("--%s: is of two bodies, not with --a-over-b",
                    line->value[OPTION_ROTATION] != NULL ? "rotation" : "similar");
    const double alpha = variable_read_one(&variables[A_OVER_B], line->value[OPTION_A_OVER_B]);
    const double f = read_input(texts, INPUT_F, 0), nu = read_input(texts, INPUT_NU1, NATURAL_NU);
    *setup = (contact_case){.shape = pad_wedge(NATURAL_THETA, alpha),
                            .A = NATURAL_A,
                            .f = f,
                            .nu1 = nu,
                            .nu2 = nu,
                            .tolerance = case_tolerance(texts, false)};
    const load to = read_natural_load(line, texts, alpha, f);
    status_check(case_contact(setup, &setup->contact), "the contact");
    const int32_t status = loads_apply_monotonic(to, setup->contact);
    if (status != RWEDGE_OK) {
        const load_fault fault = loads_fault(status, to, f, setup->contact);
        const bool named = fault.input < INPUT_COUNT && texts->text[fault.input] != NULL;
        usage_error("%s%s%s: %s", named ? input_name(texts, fault.input) : "the loads",
                    named ? " " : "", named ? texts->text[fault.input] : "", fault.why.text);
    }
    if (to.M == 0) /* else it is 1 to rounding */
        loaded->length_unit = rwedge_contact_half_width(setup->contact);
    loaded->slip_unit = NATURAL_THETA * loaded->length_unit;
    doubts_say(doubts_of_error(setup->contact), "");
}

/* ---- Dimensional ---- */

static void read_dimensional(const arguments *line, char decimal_sign, const input_texts *texts,
                             contact_case *setup)
{
    complaint why;
    for (int i = OPTION_Q_OVER_FP; i <= OPTION_C_OVER_B; i++)
        if (line->value[i] != NULL)
            usage_error("--%s %s: needs --a-over-b; allowed with bodies and loads: --Q",
                        i == OPTION_C_OVER_B ? "c-over-b" : "q-over-fp", line->value[i]);
    history_check(line);
    if (history_is_given(line))
        history_case(line, texts, CASE_LOADS_APART, decimal_sign, setup);
    else if (!case_read(texts, CASE_WITH_LOADS, setup, &why))
        usage_error("%s", why.text);
    status_check(setup->status, "the loads cannot be applied");
    doubts_say(doubts_of_state(setup, setup->contact), "");
}

void loaded_contact_read(const arguments *line, char decimal_sign, loaded_contact *loaded)
{
    input_texts texts;
    zone *touches = &loaded->touches;
    *loaded = (loaded_contact){.length_unit = 1, .slip_unit = 1};
    input_texts_from_options(line, &texts);
    input_options_check_hull(line);
    if (line->value[OPTION_A_OVER_B] != NULL)
        read_natural(line, &texts, loaded);
    else
        read_dimensional(line, decimal_sign, &texts, &loaded->setup);
    const rwedge_contact *contact = loaded->setup.contact;
    rwedge_contact_edges(contact, &touches->left, &touches->right);
    loaded->b = rwedge_contact_half_width(contact) / loaded->length_unit;
    loaded->left = touches->left / loaded->length_unit;
    loaded->right = touches->right / loaded->length_unit;
}
