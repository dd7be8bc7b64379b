/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge table: lookup tables. */
#include "table.h"

#include "text/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <rwedge.h>

enum {
    OPTION_VARIABLE = OPTION_OWN,
    OPTION_LAYOUT = OPTION_VARIABLE + VARIABLE_COUNT,
    OPTION_QUANTITY,
    OPTION_PAD
};

static const struct poptOption options[] = {
    {VALUE("a-over-b", OPTION_VARIABLE + A_OVER_B),
     "Rounding over contact half-width a/b; 0 is the sharp wedge, from 1 on it is Hertz' contact",
     "RANGE"},
    {VALUE("pad", OPTION_PAD),
     "Of a flat pad, whose a is half of the flat; elastic-limit and contact-law (default wedge)",
     "wedge|flat"},
    {VALUE("friction", OPTION_VARIABLE + FRICTION), "Coefficient of friction, or --f", "RANGE"},
    {VALUE("nu", OPTION_VARIABLE + NU), "Poisson's ratio of the half-plane, 0 to 0.5, or --nu1",
     "RANGE"},
    OTHER_NAME("f", OPTION_VARIABLE + FRICTION),
    OTHER_NAME("nu1", OPTION_VARIABLE + NU),
    {VALUE("q-over-fp", OPTION_VARIABLE + Q_OVER_FP),
     "Tangential force over its sliding value Q/(fP), 0 to 1", "RANGE"},
    {VALUE("layout", OPTION_LAYOUT),
     "A row for each combination, or a/b down and the second variable across (default long)",
     "long|grid"},
    {VALUE("quantity", OPTION_QUANTITY), "The column that a grid shows", "COLUMN"},
    {THREADS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void list_columns(const table *chosen, FILE *stream)
{
    int width = fprintf(stream, "    columns:");
    for (int i = 0; i < chosen->column_count; i++) {
        if (width + (int)strlen(chosen->column[i]) > 76)
            width = fprintf(stream, "\n            ") - 1;
        width += fprintf(stream, " %s", chosen->column[i]);
    }
}

static void describe_table(const table *chosen, FILE *stream)
{
    fprintf(stream, "\n  %s%s: %s\n", chosen->name, chosen->ratio != NULL ? " --pad flat" : "",
            chosen->summary);
    list_columns(chosen, stream);
    fprintf(stream, "\n    options:");
    for (int i = chosen->axis_count - 1; i >= 0; i--)
        fprintf(stream, " --%s", variables[chosen->axis[i]].option);
    fprintf(stream, "\n");
}

static void describe_tables(FILE *stream)
{
    fputs("\nA RANGE is START:STOP:STEP, with STOP included when it is hit, a comma list, or\n"
          "one number. By default:\n",
          stream);
    for (int i = 0; i < VARIABLE_COUNT; i++)
        fprintf(stream, "  --%-10s %s\n", variables[i].option, variables[i].usual);
    fprintf(stream, "With --pad flat, --%s %s\n", flat_over_b.option, flat_over_b.usual);
    fputs("\nTables, their columns, and the variables they have:\n", stream);
    for (int i = 0; i < TABLE_COUNT; i++)
        describe_table(&tables[i], stream);
    fputs("\nLengths are in b, the contact half-width, pressures in theta/A, of a flat pad in\n"
          "b/(A R). A cell without a value is empty.\n",
          stream);
}

static void choose_table(const arguments *line, plan *job)
{
    char allowed[160] = "";
    for (int i = 0; i < WEDGE_TABLES; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", tables[i].name);
    if (line->operand == NULL || line->operand[0] == NULL)
        usage_error("the name of a table must follow; allowed: %s", allowed);
    job->table = table_named(line->operand[0]);
    if (job->table == NULL)
        usage_error("%s: unknown table; allowed: %s", line->operand[0], allowed);
    if (line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one table, and options", line->operand[1]);
}

static void choose_pad(const arguments *line, plan *job)
{
    const char *text = line->value[OPTION_PAD];
    if (text == NULL || strcmp(text, "wedge") == 0)
        return;
    if (strcmp(text, "flat") != 0)
        usage_error("--pad %s: unknown pad; allowed: wedge, flat", text);
    const table *of_flat = table_of_flat(job->table->name);
    if (of_flat == NULL)
        usage_error("--pad flat: not for %s; allowed: elastic-limit, contact-law",
                    job->table->name);
    job->table = of_flat;
}

static void refuse_variable(const table *chosen, int variable, const char *text)
{
    char allowed[160] = "";
    for (int i = chosen->axis_count - 1; i >= 0; i--)
        list_add(allowed, sizeof allowed, ", ", "--%s", variables[chosen->axis[i]].option);
    usage_error("--%s %s: %s does not depend on it; allowed: %s", variables[variable].option, text,
                chosen->name, allowed);
}

static void read_variables(const arguments *line, plan *job)
{
    for (int i = 0; i < VARIABLE_COUNT; i++) {
        const char *text = line->value[OPTION_VARIABLE + i];
        if (table_depends_on(job->table, i))
            variable_read(table_variable_of(job->table, i), text, &job->axis[i]);
        else if (text != NULL)
            refuse_variable(job->table, i, text);
    }
}

/* The variable with the most values is the one to name. */
static void check_size(const arguments *line, const plan *job)
{
    if (plan_size(job) <= RANGE_VALUES_MAX)
        return;
    int widest = A_OVER_B;
    for (int i = 0; i < VARIABLE_COUNT; i++)
        if (job->axis[i].count > job->axis[widest].count)
            widest = i;
    const char *text = line->value[OPTION_VARIABLE + widest];
    usage_error("--%s %s: must not give the table more than 1000000000 rows in all",
                variables[widest].option,
                text != NULL ? text : table_variable_of(job->table, widest)->usual);
}

static void check_grid(const arguments *line, const plan *job)
{
    if (job->table->across == VARIABLE_COUNT)
        usage_error("--layout grid: %s has one variable, and nothing to go across; allowed: long",
                    job->table->name);
    if (job->table->across != NU && table_depends_on(job->table, NU) && job->axis[NU].count > 1)
        usage_error(
            "--nu %s: a grid has one Poisson's ratio; allowed: one number, or --layout long",
            line->value[OPTION_VARIABLE + NU]);
}

static void read_layout(const arguments *line, plan *job)
{
    const char *text = line->value[OPTION_LAYOUT];
    job->grid = text != NULL && strcmp(text, "grid") == 0;
    if (text != NULL && !job->grid && strcmp(text, "long") != 0)
        usage_error("--layout %s: unknown layout; allowed: long, grid", text);
    if (job->grid)
        check_grid(line, job);
}

static void read_quantity(const arguments *line, plan *job)
{
    const char *text = line->value[OPTION_QUANTITY];
    char allowed[160] = "";
    job->quantity = job->table->quantity;
    if (text == NULL)
        return;
    if (!job->grid)
        usage_error("--quantity %s: it chooses what a grid shows; allowed with: --layout grid",
                    text);
    for (int i = job->table->quantity; i < job->table->column_count; i++) {
        list_add(allowed, sizeof allowed, ", ", "%s", job->table->column[i]);
        job->quantity = i;
        if (strcmp(text, job->table->column[i]) == 0)
            return;
    }
    usage_error("--quantity %s: not a quantity of %s; allowed: %s", text, job->table->name,
                allowed);
}

static int write_table(const arguments *line)
{
    plan job = {0};
    output_options how;
    choose_table(line, &job);
    choose_pad(line, &job);
    read_variables(line, &job);
    read_layout(line, &job);
    read_quantity(line, &job);
    job.threads = threads_read(line);
    check_size(line, &job);
    output_options_read(line, &how);
    output_options_write(&how, plan_write, &job);
    return STATUS_DONE;
}

static const char *table_name(int i)
{
    return i < WEDGE_TABLES ? tables[i].name : NULL;
}

static const syntax grammar = {options, "TABLE [OPTION...]", describe_tables, 0};

const command table_command = {
    "table",  "rwedge table", "lookup tables: elastic limit, maximum tension, contact law, ...",
    &grammar, table_name,     write_table};
