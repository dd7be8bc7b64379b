/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge table: lookup tables. */
#include "table.h"

#include <string.h>

#include <rwedge.h>

/* ---- The rows, long or as a grid ---- */

typedef struct {
    double value[VARIABLE_COUNT];
    int32_t status;
    cell row[COLUMNS_MAX];
} computed;

typedef struct {
    const table *table;
    range axis[VARIABLE_COUNT]; /* one value where the table does not depend on it */
    bool grid;
    int quantity; /* that a grid shows */
    int threads;
    computed *ahead; /* by the threads, from index first on */
    int64_t first;
} plan;

/* The variables, the one that runs fastest first: of rows; and of a grid, which has one Poisson's
 * ratio, or has it across, and one pair of bodies. */
static const int orders[2][VARIABLE_COUNT] = {{Q_OVER_FP, FRICTION, BETA_F, A_OVER_B, NU},
                                              {NU, BETA_F, Q_OVER_FP, FRICTION, A_OVER_B}};

static void refuse(const table *chosen, const double value[], int32_t status)
{
    char where[160] = "";
    for (int k = VARIABLE_COUNT - 1; k >= 0; k--) {
        char text[NUMBER_SIZE];
        const int variable = orders[false][k];
        number_write(value[variable], NUMBER_DIGITS, '.', text);
        if (chosen->has[variable])
            list_add(where, sizeof where, ", ", "%s = %s", variables[variable].column, text);
    }
    progress_erase();
    if (status == RWEDGE_EDOMAIN && chosen->allowed != NULL)
        failure("%s at %s: allowed: %s", chosen->name, where, chosen->allowed);
    failure("%s at %s: %s", chosen->name, where, rwedge_strerror(status));
}

/* ---- Results ---- */

/* The combination of an index. */
static void compute(void *of_plan, int64_t i)
{
    const plan *job = of_plan;
    computed *to = &job->ahead[i];
    int64_t index = job->first + i;
    for (int k = 0; k < VARIABLE_COUNT; k++) {
        const int variable = orders[job->grid][k];
        const range *values = &job->axis[variable];
        to->value[variable] = range_value(values, index % values->count);
        index /= values->count;
    }
    to->status = job->table->row(to->value, to->row);
}

/* ---- Layouts ---- */

static void write_long_header(const plan *job, records *rows)
{
    for (int k = 0; k < VARIABLE_COUNT; k++)
        if (job->table->has[k])
            records_name(rows, variables[k].column);
    for (int k = 0; job->table->quantity[k] != NULL; k++)
        records_name(rows, job->table->quantity[k]);
    records_end_header(rows);
}

static void write_long(const plan *job, records *rows, const computed *result, int64_t i)
{
    (void)i;
    for (int k = 0; k < VARIABLE_COUNT; k++)
        if (job->table->has[k])
            records_value(rows, cell_number(result->value[k]));
    for (int k = 0; job->table->quantity[k] != NULL; k++)
        records_value(rows, result->row[k]);
    records_end_row(rows);
}

/* The names of a grid's columns are numbers, and never rounded: they stay apart, and read back. */
static void write_grid_header(const plan *job, records *rows)
{
    const range *across = &job->axis[job->table->across];
    records_name(rows, job->table->quantity[job->quantity]);
    for (int64_t i = 0; i < across->count && records_go_on(rows); i++) {
        char name[NUMBER_SIZE];
        number_write(range_value(across, i), NUMBER_DIGITS, rows->how->decimal_sign, name);
        records_name(rows, name);
    }
    records_end_header(rows);
}

/* The result of index i: those of a row stand across, behind a/b. */
static void write_in_grid(const plan *job, records *rows, const computed *result, int64_t i)
{
    const int64_t across = job->axis[job->table->across].count;
    if (i % across == 0)
        records_value(rows, cell_number(result->value[A_OVER_B]));
    records_value(rows, result->row[job->quantity]);
    if ((i + 1) % across == 0)
        records_end_row(rows);
}

static void plan_write(void *plan_to_write, records *rows)
{
    enum { AHEAD = 128 }; /* results for each thread: they take longer than to begin it */
    plan *job = plan_to_write;
    const int64_t size = range_product(VARIABLE_COUNT, job->axis),
                  most = AHEAD * (int64_t)job->threads;
    job->ahead = memory_zeroed((size_t)most, sizeof *job->ahead);
    progress_start(rows->show_progress, size, job->grid ? "values" : "rows");
    records_describe(rows, table_columns, COLUMN_KINDS);
    (job->grid ? write_grid_header : write_long_header)(job, rows);
    for (job->first = 0; job->first < size && records_go_on(rows); job->first += most) {
        const int64_t end = size - job->first < most ? size : job->first + most;
        threads_run(job->threads, end - job->first, compute, job);
        for (int64_t i = job->first; i < end && records_go_on(rows); i++) {
            const computed *result = &job->ahead[i - job->first];
            if (result->status != RWEDGE_OK)
                refuse(job->table, result->value, result->status);
            (job->grid ? write_in_grid : write_long)(job, rows, result, i);
            progress_step();
        }
    }
}

/* ---- The command ---- */

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
     "Of a flat pad, whose a is half of the flat; not for all tables (default wedge)",
     "wedge|flat"},
    {VALUE("friction", OPTION_VARIABLE + FRICTION), "Coefficient of friction, or --f", "RANGE"},
    {VALUE("nu", OPTION_VARIABLE + NU), "Poisson's ratio of the half-plane, 0 to 0.5, or --nu1",
     "RANGE"},
    OTHER_NAME("f", OPTION_VARIABLE + FRICTION),
    OTHER_NAME("nu1", OPTION_VARIABLE + NU),
    {VALUE("q-over-fp", OPTION_VARIABLE + Q_OVER_FP),
     "Tangential force over its sliding value Q/(fP), 0 to 1", "RANGE"},
    {VALUE("beta-f", OPTION_VARIABLE + BETA_F),
     "Of unlike bodies, the wedge held: Dundurs' beta times f; for elastic-limit, max-tension",
     "RANGE"},
    {VALUE("layout", OPTION_LAYOUT),
     "A row for each combination, or a/b down and the second variable across (default long)",
     "long|grid"},
    {VALUE("quantity", OPTION_QUANTITY), "The column that a grid shows", "COLUMN"},
    {THREADS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe_table(const table *chosen, FILE *stream)
{
    fprintf(stream, "\n  %s%s: %s\n", chosen->name,
            chosen->ratio != NULL ? " --pad flat"
            : chosen->has[BETA_F] ? " --beta-f"
                                  : "",
            chosen->summary);
    int width = fprintf(stream, "    columns:");
    for (int i = 0; i < VARIABLE_COUNT; i++)
        if (chosen->has[i])
            width += fprintf(stream, " %s", variables[i].column);
    for (int i = 0; chosen->quantity[i] != NULL; i++) {
        if (width + (int)strlen(chosen->quantity[i]) > 76)
            width = fprintf(stream, "\n            ") - 1;
        width += fprintf(stream, " %s", chosen->quantity[i]);
    }
    fprintf(stream, "\n    options:");
    for (int k = 0; k < VARIABLE_COUNT; k++)
        if (chosen->has[orders[false][k]])
            fprintf(stream, " --%s", variables[orders[false][k]].option);
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
    const char *pad = line->value[OPTION_PAD];
    const bool is_flat = pad != NULL && strcmp(pad, "flat") == 0;
    char allowed[160] = "";
    for (int i = 0; i < WEDGE_TABLES; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", tables[i].name);
    if (line->operand == NULL || line->operand[0] == NULL)
        usage_error("the name of a table must follow; allowed: %s", allowed);
    if (table_named(line->operand[0], false, false) == NULL)
        usage_error("%s: unknown table; allowed: %s", line->operand[0], allowed);
    if (line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one table, and options", line->operand[1]);
    if (pad != NULL && !is_flat && strcmp(pad, "wedge") != 0)
        usage_error("--pad %s: unknown pad; allowed: wedge, flat", pad);
    const char *beta_f = line->value[OPTION_VARIABLE + BETA_F];
    job->table = table_named(line->operand[0], is_flat, beta_f != NULL);
    if (job->table == NULL && beta_f != NULL)
        usage_error("--beta-f %s: not for %s%s; allowed: elastic-limit, max-tension", beta_f,
                    line->operand[0], is_flat ? " --pad flat" : "");
    if (job->table == NULL)
        usage_error("--pad flat: not for %s; allowed: elastic-limit, contact-law, shakedown-limit",
                    line->operand[0]);
}

static void read_variables(const arguments *line, plan *job)
{
    char allowed[160] = "";
    for (int k = 0; k < VARIABLE_COUNT; k++)
        if (job->table->has[orders[false][k]])
            list_add(allowed, sizeof allowed, ", ", "--%s", variables[orders[false][k]].option);
    for (int i = 0; i < VARIABLE_COUNT; i++) {
        const char *text = line->value[OPTION_VARIABLE + i];
        job->axis[i].count = 1;
        if (job->table->has[i])
            variable_read(table_variable_of(job->table, i), text, &job->axis[i]);
        else if (text != NULL)
            usage_error("--%s %s: %s does not depend on it; allowed: %s", variables[i].option, text,
                        job->table->name, allowed);
    }
}

/* The variable with the most values is the one to name. */
static void check_size(const arguments *line, const plan *job)
{
    if (range_product(VARIABLE_COUNT, job->axis) <= RANGE_VALUES_MAX)
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

static void read_layout(const arguments *line, plan *job)
{
    const char *text = line->value[OPTION_LAYOUT];
    job->grid = text != NULL && strcmp(text, "grid") == 0;
    if (text != NULL && !job->grid && strcmp(text, "long") != 0)
        usage_error("--layout %s: unknown layout; allowed: long, grid", text);
    if (job->grid && job->table->across == VARIABLE_COUNT)
        usage_error("--layout grid: %s has one variable, and nothing to go across; allowed: long",
                    job->table->name);
    if (job->grid && job->table->across != NU && job->axis[NU].count > 1)
        usage_error(
            "--nu %s: a grid has one Poisson's ratio; allowed: one number, or --layout long",
            line->value[OPTION_VARIABLE + NU]);
    if (job->grid && job->axis[BETA_F].count > 1)
        usage_error("--beta-f %s: a grid has one of it; allowed: one number, or --layout long",
                    line->value[OPTION_VARIABLE + BETA_F]);
}

static void read_quantity(const arguments *line, plan *job)
{
    const char *text = line->value[OPTION_QUANTITY];
    char allowed[160] = "";
    if (text == NULL)
        return;
    if (!job->grid)
        usage_error("--quantity %s: it chooses what a grid shows; allowed with: --layout grid",
                    text);
    for (int i = 0; job->table->quantity[i] != NULL; i++) {
        list_add(allowed, sizeof allowed, ", ", "%s", job->table->quantity[i]);
        job->quantity = i;
        if (strcmp(text, job->table->quantity[i]) == 0)
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

const command table_command = {
    .name = "table",
    .summary = "lookup tables: elastic limit, maximum tension, contact law, ...",
    .grammar = {options, "TABLE [OPTION...]", describe_tables},
    .operand = table_name,
    .run = write_table};
