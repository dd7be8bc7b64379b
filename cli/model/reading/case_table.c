/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reading.h"

#include <math.h>

const char case_table_error[] = "error";

/* ---- Columns ---- */

/* A second body may be rigid in every row. */
static bool is_complete(const case_table *table, complaint *why)
{
    const char *present[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++)
        present[i] = header_has_input(&table->names, i) ? "(a column)" : NULL;
    if (header_has_input(&table->names, INPUT_E2))
        present[INPUT_E2] = "inf";
    const input_texts texts = header_texts(&table->names, &table->constants, present);
    if (case_is_complete(&texts, CASE_OF_SOLVE, why))
        return true;
    list_add(why->text, sizeof why->text, "", "%s",
             header_hint(table->names.name, table->names.count));
    return false;
}

static bool has_input(const case_table *table, int input)
{
    return input_is_given(&table->constants, input) || header_has_input(&table->names, input);
}

static bool is_free(const case_table *table, const char *name, complaint *why)
{
    if (!header_has(&table->names, name))
        return true;
    return complain(why, "column %s: a result has that name; allowed: any other", name);
}

/* A result that the table has as an input is not repeated; another column of its name would be
 * mistaken for it. */
bool case_table_begin(case_table *table, complaint *why)
{
    const header *names = &table->names;
    results_wanted wanted = table->wanted;
    if (!is_complete(table, why))
        return false;
    wanted.moment = wanted.moment || header_has_input(names, INPUT_TILT);
    wanted.edges = wanted.edges || wanted.moment || header_has_input(names, INPUT_M) ||
                   header_has_input(names, INPUT_SIGMA) || header_has_input(names, INPUT_PROFILE);
    wanted.coupling = has_input(table, INPUT_E2) && has_input(table, INPUT_F) &&
                      !table->constants.takes_as_similar;
    wanted.moment =
        wanted.moment || (wanted.coupling && table->constants.rotation == ROTATION_HELD);
    wanted.edges = wanted.edges || wanted.coupling;
    for (int i = 0; i < RESULT_COUNT; i++) {
        const bool is_input = (i == RESULT_ROUNDING && header_has_input(names, INPUT_A)) ||
                              (i == RESULT_RADIUS && header_has_input(names, INPUT_RADIUS)) ||
                              (i == RESULT_TILT && header_has_input(names, INPUT_TILT));
        table->shown[i] = !is_input && results_include(wanted, i);
        if (table->shown[i] && !is_free(table, result_kinds[i].name, why))
            return false;
    }
    return is_free(table, case_table_error, why);
}

/* ---- A row ---- */

static bool is_rigid(const input_texts *texts)
{
    complaint why;
    double E2;
    return input_is_given(texts, INPUT_E2) && input_read(texts, INPUT_E2, &E2, &why) && isinf(E2);
}

/* An empty cell is a gap in the data: a default would look like a result. Only a rigid body has
 * no Poisson's ratio. */
bool case_table_solve(const case_table *table, const char *const row[], size_t count,
                      results *answer, complaint *why)
{
    if (!header_fits(table->names.count, count, table->separator, why))
        return false;
    const char *text[INPUT_COUNT];
    for (int i = 0; i < INPUT_COUNT; i++)
        text[i] = header_has_input(&table->names, i) ? row[table->names.column[i]] : NULL;
    const input_texts texts = header_texts(&table->names, &table->constants, text);
    contact_case setup;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (header_has_input(&table->names, i) && !input_is_given(&texts, i) &&
            !(i == INPUT_NU2 && is_rigid(&texts)))
            return complain(why, "%s: the cell is empty", input_kinds[i].column);
    if (!header_texts_agree(&texts, &table->constants, why))
        return false;
    const bool solved = case_read(&texts, CASE_OF_SOLVE, &setup, why) &&
                        results_compute(&setup, table->wanted, answer, why);
    rwedge_contact_destroy(setup.contact);
    if (!solved)
        return false;
    if (texts.text[INPUT_F] == NULL)
        results_warn(answer, "no friction given");
    return true;
}
