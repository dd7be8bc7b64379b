/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "model/results/results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EXAMPLE_SIZE = 32 };

/* Read as the tool reads it: the columns of Batch have the names of inputs. */
static contact_case case_of(char text[INPUT_CELLS][EXAMPLE_SIZE])
{
    complaint why;
    input_texts texts = {.tolerance = 0};
    contact_case setup;
    for (int i = 0; i < INPUT_CELLS; i++) {
        int k = 0;
        while (strcmp(input_kinds[k].column, case_cells[i].column) != 0)
            k++;
        texts.text[k] = text[i][0] != '\0' ? text[i] : NULL;
    }
    if (!case_read(&texts, CASE_OF_SOLVE, &setup, &why))
        failure("the workbook's example: %s", why.text);
    return setup;
}

/* The columns of Batch have the names of results; NAN where there is none. */
static double result_of(const results *answer, const char *column)
{
    for (int i = 0; i < RESULT_COUNT; i++)
        if (strcmp(result_kinds[i].name, column) == 0)
            return answer->value[i].number;
    return NAN;
}

double shown_number(const case_values *values, const char *column)
{
    return values->number[cell_of_column(column)];
}

/* Those of "solve", and two that it has not. The table has the place to two digits. */
static void take_results(const contact_case *setup, results *answer, case_values *shown)
{
    for (int i = INPUT_CELLS; i < FIRST_REMARK; i++)
        shown->number[i] = result_of(answer, case_cells[i].column);
    shown->number[cell_of_column("p_mean")] = setup->P / (2 * shown_number(shown, "b"));
    shown->number[cell_of_column("safety_strength")] =
        shown_number(shown, "P_over_bk") / shown_number(shown, "load_over_bk");
    snprintf(shown->branch, sizeof shown->branch, "%s", answer->value[RESULT_YIELD_BRANCH].text);
    for (int i = RESULT_YIELD_X; i <= RESULT_YIELD_Y; i++)
        answer->value[i].number = number_rounded(answer->value[i].number, 2);
    const verdict all = verdict_of(answer, '.', "mm");
    snprintf(shown->strength, sizeof shown->strength, "%s", all.strength);
    snprintf(
        shown->figures, sizeof shown->figures,
        "b = %.4g mm, half-width of the contact;  p0 = %.4g MPa, peak pressure;  c/b = %.4g of "
        "the contact sticks",
        shown_number(shown, "b"), shown_number(shown, "p0"), shown_number(shown, "c_over_b"));
}

void shown_values(int example, case_values *shown)
{
    char text[INPUT_CELLS][EXAMPLE_SIZE];
    complaint why;
    results answer;
    *shown = (case_values){.branch = ""};
    for (int i = 0; i < SHOWN_CELLS; i++)
        shown->number[i] = NAN;
    if (example >= EXAMPLES)
        return;
    for (int i = 0; i < INPUT_CELLS; i++) {
        const char *list = case_cells[i].examples; /* its parts are between commas */
        for (int k = 0; k < example; k++)
            list += strcspn(list, ",") + 1;
        snprintf(text[i], EXAMPLE_SIZE, "%.*s", (int)strcspn(list, ","), list);
        number_read(text[i], &shown->number[i]);
    }
    const contact_case setup = case_of(text);
    if (!results_compute(&setup, (results_wanted){false, false}, &answer, &why))
        failure("the workbook's example: %s", why.text);
    rwedge_contact_destroy(setup.contact);
    take_results(&setup, &answer, shown);
}

/* ---- Cells ---- */

void case_formula(xlsx *book, int row, int column, int number, const case_values *values,
                  const char *style, int batch_row)
{
    const bool is_branch = strcmp(case_cells[number].column, "yield_branch") == 0;
    xlsx_formula(book, row, column, formula_of(case_cells[number].formula, 0, batch_row),
                 is_branch ? cell_text(values->branch)
                           : cell_number(number < SHOWN_CELLS ? values->number[number] : NAN),
                 style);
}
