/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about a pasted table of cases, a row each. */
#include "page.h"

#include "model/results/results.h"

/* The form gives what the columns do not, not even the other way, the radius for a, or another
 * pad. */
static void leave_to_columns(const header *names, input_texts *constants)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        const int other = input_alternative(i);
        if (header_has_input(names, i) || (other >= 0 && header_has_input(names, other)))
            constants->text[i] = NULL;
    }
    if (header_has_input(names, INPUT_E2) || header_has_input(names, INPUT_NU2))
        constants->text[INPUT_E2] = constants->text[INPUT_NU2] = NULL;
    if (header_has_input(names, INPUT_FLAT))
        constants->text[INPUT_THETA] = constants->text[INPUT_THETA_DEG] = constants->text[INPUT_A] =
            constants->text[INPUT_PROFILE] = NULL;
    if (header_has_input(names, INPUT_THETA) || header_has_input(names, INPUT_THETA_DEG))
        constants->text[INPUT_FLAT] = constants->text[INPUT_PROFILE] = NULL;
}

/* A table of cases, and what the form gives for its columns. */
typedef struct {
    input_texts form;
    char decimal_sign;
    case_table table;
} pasted_cases;

/* The form stands for no column that is nearly named: nothing is given but the columns. */
static bool find_columns(void *of_cases, header *names, complaint *why)
{
    pasted_cases *cases = of_cases;
    case_table *table = &cases->table;
    if (!header_find(0, INPUT_COUNT, NULL, names, why))
        return false;
    *table = (case_table){.constants = cases->form, .names = *names};
    leave_to_columns(&table->names, &table->constants);
    for (int i = 0; i < INPUT_COUNT; i++)
        table->constants.is_cell[i] = header_has_input(&table->names, i);
    table->constants.cell_decimal_sign = cases->decimal_sign;
    table->constants.how_comma = "if that is chosen above";
    table->constants.where_else = "columns, or the case of the form";
    return case_table_begin(table, why);
}

static void write_head(const case_table *table)
{
    for (size_t i = 0; i < table->names.count; i++)
        json_add("{'columns':[%t]}", table->names.name[i]);
    for (int i = 0; i < RESULT_COUNT; i++)
        if (table->shown[i])
            json_add("{'results':[%t]}", result_kinds[i].name);
    for (int i = 0; i < INPUT_COUNT; i++)
        if (input_is_given(&table->constants, i))
            json_add("{'constants':{%t:%t}}", input_kinds[i].column, table->constants.text[i]);
}

static void write_row(const case_table *table, const csv_row *row)
{
    results answer;
    complaint why = {"misplaced quotes"};
    char digits[NUMBER_SIZE];
    const bool solved =
        !row->malformed && case_table_solve(table, row->cell, row->count, &answer, &why);
    json_add("{'rows':[{'colour':%t,'error':%t,'cells':[",
             solved ? verdict_of(&answer, '.', "").colour : "red", solved ? "" : why.text);
    for (size_t i = 0; i < table->names.count; i++)
        json_add("%t", i < row->count ? row->cell[i] : "");
    json_add("],'values':[");
    for (int i = 0; i < RESULT_COUNT && solved; i++) {
        const cell *value = &answer.value[i];
        if (table->shown[i])
            json_add("%t", value->text != NULL ? value->text : json_digits(value->number, digits));
    }
    json_add("]}]}");
}

/* The rows below the names; or the problem, where they cannot be read on. */
static void write_rows(table_input *rows, case_table *table)
{
    csv_input *in = rows->in;
    complaint unused;
    while (table_next(rows)) {
        write_row(table, &in->row);
        if (in->row.count == table->names.count)
            header_note_unused(&table->names, in->row.cell);
    }
    unused = rows->remark;
    header_write_unused(&table->names, unused.text, sizeof unused.text);
    json_add("{'unused':%t}", unused.text);
    if (in->problem.text[0] != '\0')
        json_refuse("", "%s", pasted_problem(rows));
}

/* Answers pasted rows, with the case of the form for the columns that they lack: columns, results,
 * constants, rows with their colour and fault, columns that are not used. */
EXPORTED const char *page_rows(const char *text, char *fields, int decimal_sign)
{
    static table_input rows;
    static pasted_cases cases;
    const table_wanted wanted = {.find = find_columns, .context = &cases, .takes_malformed = true};
    json_begin();
    cases = (pasted_cases){.form = field_texts(fields), .decimal_sign = (char)decimal_sign};
    if (field_is_of_pad()) /* rows are of the half-plane */
        cases.form.text[INPUT_K] = cases.form.text[INPUT_YIELD_STRESS] = NULL;
    const reading how = {.decimal_sign = (char)decimal_sign, .units = field_units()};
    pasted_offer(text);
    if (table_open("", &how, &wanted, &rows)) {
        write_head(&cases.table);
        write_rows(&rows, &cases.table);
    } else
        json_refuse("", "%s", pasted_problem(&rows));
    table_close(&rows);
    return json_end();
}
