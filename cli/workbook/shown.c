/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

#include "model/results/results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Read as the tool reads it: the columns of Batch have the names of inputs. */
static contact_case case_of(const double input[INPUT_CELLS])
{
    char number[INPUT_CELLS][NUMBER_SIZE], complaint[COMPLAINT_SIZE];
    input_texts texts = {.tolerance = 0};
    contact_case setup;
    for (int i = 0; i < INPUT_CELLS; i++) {
        int k = 0;
        while (strcmp(input_kinds[k].column, case_cells[i].column) != 0)
            k++;
        number_write(input[i], NUMBER_DIGITS, '.', number[i]);
        texts.text[k] = isnan(input[i]) ? NULL : number[i];
    }
    if (!case_read(&texts, CASE_OF_SOLVE, &setup, complaint))
        failure("the workbook's example: %s", complaint);
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

/* The table has the place to two digits. */
static void write_sentences(results *answer, case_values *shown)
{
    for (int i = RESULT_YIELD_X; i <= RESULT_YIELD_Y; i++)
        answer->value[i].number = number_rounded(answer->value[i].number, 2);
    const verdict all = verdict_of(answer, (verdict_style){'.', "mm"});
    snprintf(shown->strength, sizeof shown->strength, "%s", all.strength);
    snprintf(
        shown->figures, sizeof shown->figures,
        "b = %.4g mm, half-width of the contact;  p0 = %.4g MPa, peak pressure;  c/b = %.4g of "
        "the contact sticks",
        shown_number(shown, "b"), shown_number(shown, "p0"), shown_number(shown, "c_over_b"));
}

void shown_nothing(case_values *shown)
{
    for (int i = 0; i < SHOWN_CELLS; i++)
        shown->number[i] = NAN;
    shown->branch[0] = '\0';
}

void shown_values(const double input[INPUT_CELLS], case_values *shown)
{
    const contact_case setup = case_of(input);
    char complaint[COMPLAINT_SIZE];
    results answer;
    if (!results_compute(&setup, (results_wanted){false, false}, &answer, complaint))
        failure("the workbook's example: %s", complaint);
    shown_nothing(shown);
    for (int i = 0; i < INPUT_CELLS; i++)
        shown->number[i] = input[i];
    for (int i = INPUT_CELLS; i < FIRST_REMARK; i++)
        shown->number[i] = result_of(&answer, case_cells[i].column);
    shown->number[cell_of_column("p_mean")] = setup.P / (2 * shown_number(shown, "b"));
    shown->number[cell_of_column("safety_strength")] =
        shown_number(shown, "P_over_bk") / shown_number(shown, "load_over_bk");
    const char *branch = answer.value[RESULT_YIELD_BRANCH].text;
    snprintf(shown->branch, sizeof shown->branch, "%s", branch);
    write_sentences(&answer, shown);
}
