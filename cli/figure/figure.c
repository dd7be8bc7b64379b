/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge figure: the paper's figures, and more, as pictures. */
#include "figure.h"

#include "fretting/fretting.h"

#include <math.h>
#include <string.h>

enum { FIGURE_COUNT = 22 };
static const figure *const figures[FIGURE_COUNT] = {
    &figure_pressure,       &figure_normal,  &figure_sliding,   &figure_yield_point,
    &figure_tension,        &figure_shear,   &figure_field,     &figure_loop,
    &figure_eccentric,      &figure_history, &figure_fretting,  &figure_measure,
    &figure_crack,          &figure_wear,    &figure_shakedown, &figure_unlike_limit,
    &figure_unlike_tension, &figure_contact, &figure_tractions, &figure_stress,
    &figure_tests,          &figure_measured};

enum {
    OPTION_FIGURE_VARIABLE = OPTION_AFTER_CRACK,
    OPTION_DATA = OPTION_FIGURE_VARIABLE + FIGURE_VARIABLES,
    OPTION_NO_TITLE,
    OPTION_MEASURE,
    OPTION_OVER
};

/* No command has more options. */
typedef char options_have_room[(int)OPTION_OVER < (int)OPTION_LIMIT ? 1 : -1];

/* The options of "rwedge history" but for friction and Poisson's ratio, which figures have
 * anyway. */
static struct poptOption history_figure_option_table[] = {
    {INCLUDED(shape_option_table), NULL, NULL},
    {INCLUDED(heights_option_table), NULL, NULL},
    {INCLUDED(history_option_table), NULL, NULL},
    {VALUE("at", OPTION_AT), "The point of figure history", "x,y"},
    {PLANE_STRESS_OPTION},
    {ROTATION_OPTION},
    {SIMILAR_OPTION},
    {MATERIAL_OPTION},
    {INCLUDED(reading_option_table), NULL, NULL},
    POPT_TABLEEND,
};

static const struct poptOption options[] = {
    {VALUE("a-over-b", OPTION_FIGURE_VARIABLE + A_OVER_B),
     "Rounding over contact half-width a/b; 0 is the sharp wedge, from 1 on it is Hertz' contact",
     "RANGE"},
    {VALUE("friction", OPTION_FIGURE_VARIABLE + FRICTION), "Coefficient of friction, or --f",
     "NUMBER"},
    {VALUE("nu", OPTION_FIGURE_VARIABLE + NU),
     "Poisson's ratio of the half-plane, 0 to 0.5, or --nu1", "NUMBER"},
    OTHER_NAME("f", OPTION_FIGURE_VARIABLE + FRICTION),
    OTHER_NAME("nu1", OPTION_FIGURE_VARIABLE + NU),
    {VALUE("q-over-fp", OPTION_FIGURE_VARIABLE + Q_OVER_FP),
     "Tangential force over its sliding value Q/(fP), 0 to 1", "RANGE"},
    {VALUE("c-over-b", OPTION_FIGURE_VARIABLE + C_OVER_B),
     "Half-width of the stick zone c/b, 0 to 1; 0 is full sliding", "RANGE"},
    {VALUE("sigma-over-max", OPTION_FIGURE_VARIABLE + SIGMA_OVER_MAX),
     "Bulk tension over the largest that slips one way, pi b sigma/(4 Q), -1 to 1", "RANGE"},
    {VALUE("beta-f", OPTION_FIGURE_VARIABLE + BETA_F),
     "Unlike bodies: Dundurs' beta of half-plane and wedge times f, -1 to 1; 0 are similar bodies",
     "RANGE"},
    {INCLUDED(history_figure_option_table),
     "A contact and its loads, for loop and the figures below without variables:", NULL},
    {VALUE("measure", OPTION_MEASURE),
     "Of figure measure: a column of \"rwedge fretting\" (default swt)", "COLUMN"},
    {VALUE("over", OPTION_OVER),
     "Along the surface, below its worst place, or as contours (default surface)",
     "surface|depth|field"},
    {INCLUDED(criteria_option_table), "Criteria, of figures measure and tests:", NULL},
    {INCLUDED(crack_option_table), "The crack, of figure crack:", NULL},
    {INCLUDED(series_option_table), "A series, of figure tests:", NULL},
    {FLAG("data", OPTION_DATA), "Write the numbers behind the figure instead of a picture", NULL},
    {FLAG("no-title", OPTION_NO_TITLE), "Leave the title out of the picture", NULL},
    {VALUE("format", OPTION_FORMAT),
     "How it is written (default: as FILE ends, or svg; with --data csv)",
     "svg|png|pdf, csv|tsv|json|xlsx"},
    {VALUE("digits", OPTION_DIGITS), "Significant digits of --data, 1 to 17 (default 17)", "N"},
    {FLAG("decimal-comma", OPTION_DECIMAL_COMMA),
     "With --data: write 1,5 for 1.5, with ';' between the columns of csv", NULL},
    {"output", 'o', POPT_ARG_STRING, NULL, OPTION_OUTPUT,
     "Write to FILE, whole or not at all (default: standard output)", "FILE"},
    {HELP_OPTION},
    POPT_TABLEEND,
};

static void describe_figures(FILE *stream)
{
    fputs("\nFigures, with the variables they have and their defaults:\n", stream);
    for (int i = 0; i < FIGURE_COUNT; i++) {
        const char *before = "      ";
        fprintf(stream, "  %-9s %s\n", figures[i]->name, figures[i]->summary);
        for (int k = 0; k < FIGURE_VARIABLES; k++) {
            const char *usual = figures[i]->use[k].usual;
            if (usual == NULL)
                continue;
            fprintf(stream, "%s--%s%s%s", before, variables[k].option, usual[0] != '\0' ? " " : "",
                    usual);
            before = ", ";
        }
        if (before[0] == ',')
            fputc('\n', stream);
    }
    fputs("\nA RANGE is START:STOP:STEP, a comma list, or one number. gnuplot draws the\n"
          "pictures, 85 mm wide in PDF and PNG: it must be on PATH (package gnuplot-nox);\n"
          "--data does without. Beside --history, --load gives loads that are applied once,\n"
          "before the first cycle.\n",
          stream);
}

static const figure *choose_figure(const arguments *line)
{
    char allowed[200] = "";
    for (int i = 0; i < FIGURE_COUNT; i++)
        list_add(allowed, sizeof allowed, ", ", "%s", figures[i]->name);
    if (line->operand == NULL || line->operand[0] == NULL)
        usage_error("which figure must follow; allowed: %s", allowed);
    int i = 0;
    while (i < FIGURE_COUNT && strcmp(line->operand[0], figures[i]->name) != 0)
        i++;
    if (i == FIGURE_COUNT)
        usage_error("%s: unknown figure; allowed: %s", line->operand[0], allowed);
    if (line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one figure, and options%s", line->operand[1],
                    figures[i]->has_history || figures[i] == &figure_loop
                        ? "; --history gives a file of loads"
                        : "");
    return figures[i];
}

static void read_variable(const figure *chosen, int i, const char *text, range *values)
{
    const int most = chosen->use[i].most;
    if (text == NULL && chosen->use[i].usual[0] == '\0')
        return;
    variable_read(&variables[i], text != NULL ? text : chosen->use[i].usual, values);
    if (values->count > most && most == 1)
        usage_error("--%s %s: must be one number", variables[i].option, text);
    if (values->count > most)
        usage_error("--%s %s: must not have more than %d values, a curve each", variables[i].option,
                    text, most);
}

static void read_case(const arguments *line, figure_case *inputs)
{
    const figure *chosen = inputs->kind;
    char allowed[160] = "";
    for (int i = 0; i < FIGURE_VARIABLES; i++)
        if (chosen->use[i].usual != NULL)
            list_add(allowed, sizeof allowed, ", ", "--%s", variables[i].option);
    for (int i = 0; i < FIGURE_VARIABLES; i++) {
        const char *text = line->value[OPTION_FIGURE_VARIABLE + i];
        const bool is_of_contact = chosen->has_history && (i == FRICTION || i == NU);
        if (chosen->use[i].usual != NULL)
            read_variable(chosen, i, text, &inputs->value[i]);
        else if (text != NULL && !is_of_contact)
            usage_error("--%s %s: figure %s does not depend on it; allowed: %s",
                        variables[i].option, text, chosen->name,
                        allowed[0] != '\0' ? allowed : "none of the variables");
    }
    if (inputs->value[C_OVER_B].count > 0 && inputs->value[Q_OVER_FP].count > 0)
        usage_error(
            "--c-over-b %s: not with --q-over-fp, which says the same; allowed: one of the two",
            line->value[OPTION_FIGURE_VARIABLE + C_OVER_B]);
}

/* ---- A contact and its loads ---- */

static bool any_is_given(const arguments *line, int first, int end)
{
    for (int i = first; i < end; i++)
        if (line->value[i] != NULL)
            return true;
    return false;
}

/* Without a table of loads there is nothing for its options to say. */
static void refuse_others(const arguments *line, const figure *chosen)
{
    const bool has_tests = chosen == &figure_tests, has_crack = chosen == &figure_crack;
    const bool has_measure = chosen == &figure_measure;
    if (!chosen->has_history && !has_tests && !chosen->has_loop &&
        any_is_given(line, OPTION_INPUT, OPTION_AFTER_PLACES))
        usage_error(
            "figure %s: a contact and its loads are for history, fretting, measure, "
            "crack, wear, contact, tractions, stress, tests, measured, and loop with --history or "
            "--load",
            chosen->name);
    if (!has_measure && !has_tests &&
        any_is_given(line, OPTION_AFTER_PLACES, OPTION_AFTER_CRITERIA))
        usage_error("figure %s: criteria and measures are for figure measure", chosen->name);
    if (!has_measure && (line->value[OPTION_MEASURE] != NULL || line->value[OPTION_OVER] != NULL))
        usage_error("figure %s: criteria and measures are for figure measure", chosen->name);
    if (!has_tests && any_is_given(line, OPTION_TESTS, OPTION_ANGLE))
        usage_error("figure %s: a series is for figure tests", chosen->name);
    if (!has_crack &&
        (any_is_given(line, OPTION_EDGE, OPTION_AFTER_CRACK) || line->value[OPTION_X] != NULL ||
         (line->value[OPTION_ANGLE] != NULL && !has_tests)))
        usage_error("figure %s: a crack is for figure crack", chosen->name);
}

/* ---- A measure ---- */

/* The measure of --measure, which must be one of those that are computed. */
static int read_measure(const char *text, const criteria *asked)
{
    char allowed[600] = "";
    int column = text == NULL ? measure_column(RWEDGE_MEASURE_SWT, PART_VALUE) : -1;
    for (int i = 0; i < measure_count(); i++) {
        const measure_kind *kind = measure_kind_of(i);
        if (!column_is_wanted(asked, i) ||
            (kind->part != PART_VALUE && kind->part != PART_MULTIPLE))
            continue;
        list_add(allowed, sizeof allowed, ", ", "%s", kind->column);
        if (text != NULL && strcmp(text, kind->column) == 0)
            column = i;
    }
    if (column < 0)
        usage_error("--measure %s: must be one of: %s; or a criterion whose constants are given",
                    text, allowed);
    return column;
}

/* To be called when the contact is read. */
static void read_measure_and_place(const arguments *line, figure_case *inputs)
{
    static const char *const ways[OVER_COUNT] = {"surface", "depth", "field"};
    const char *over = line->value[OPTION_OVER];
    criteria_read_strength(line, &inputs->history.setup, &inputs->asked);
    inputs->measure = read_measure(line->value[OPTION_MEASURE], &inputs->asked);
    while (over != NULL && inputs->over < OVER_COUNT && strcmp(over, ways[inputs->over]) != 0)
        inputs->over++;
    if (inputs->over == OVER_COUNT)
        usage_error("--over %s: must be surface, depth or field", over);
    if (measure_kind_of(inputs->measure)->is_of_friction && inputs->over != OVER_SURFACE)
        usage_error("--over %s: %s is of the surface alone", over,
                    measure_kind_of(inputs->measure)->column);
}

/* Goes through the cycle, because it has the edges. */
static void read_crack(const arguments *line, figure_case *inputs)
{
    const criteria usual = criteria_usual(&inputs->history.setup);
    if (line->value[OPTION_ANGLE_RANGE] != NULL)
        usage_error("--angle-range %s: figure crack has one angle; allowed: --angle",
                    line->value[OPTION_ANGLE_RANGE]);
    crack_law_read(line, &inputs->constants, &inputs->crack.crack.law);
    history_cycle(&inputs->history, &usual, &inputs->last, NULL);
    crack_read(line, &inputs->last, &inputs->crack);
    if (inputs->crack.crack.lengths < 2)
        usage_error("--lengths %s: must have two values at least", line->value[OPTION_LENGTHS]);
}

static void read_history(const arguments *line, char decimal_sign, figure_case *inputs)
{
    const figure *chosen = inputs->kind;
    const bool has_measure = chosen == &figure_measure, has_crack = chosen == &figure_crack;
    const contact_case *setup = &inputs->history.setup;
    arguments bodies = *line;
    input_texts texts;
    /* friction and Poisson's ratio are variables of other figures */
    bodies.value[OPTION_INPUT + INPUT_F] = line->value[OPTION_FIGURE_VARIABLE + FRICTION];
    bodies.value[OPTION_INPUT + INPUT_NU1] = line->value[OPTION_FIGURE_VARIABLE + NU];
    bodies.operand = NULL;
    input_texts_from_options(&bodies, &texts);
    inputs->constants = *material_of(&bodies);
    if (has_measure)
        criteria_read(&bodies, &inputs->constants, &texts, &inputs->asked);
    read_case(line, inputs);
    if (chosen == &figure_history && line->value[OPTION_AT] == NULL)
        usage_error("--at: missing; figure history needs a point x,y");
    places_read(&bodies, decimal_sign, &inputs->at);
    if (inputs->at.count > 1)
        usage_error("--at %s: must be one point", line->value[OPTION_AT]);
    if (!history_is_given(&bodies))
        usage_error(
            "figure %s: loads are missing; needed: --history, a file with the columns P and "
            "Q, perhaps M or tilt, sigma; or --load P,Q for each",
            chosen->name);
    contact_history_read(&bodies, &texts, decimal_sign, chosen->cycles,
                         chosen->cycles > 2 ? chosen->cycles : 2, &inputs->history);
    for (size_t i = 0; i < inputs->history.loads.count; i++)
        inputs->half_width =
            fmax(inputs->half_width,
                 pad_half_width(&setup->shape, setup->A, inputs->history.loads.load[i].P));
    if (has_measure)
        read_measure_and_place(&bodies, inputs);
    if (has_crack)
        read_crack(&bodies, inputs);
}

static void read_tests(const arguments *line, const output_options *how, figure_case *inputs)
{
    static series_table table; /* it must not move */
    arguments bodies = *line;
    bodies.value[OPTION_INPUT + INPUT_F] = line->value[OPTION_FIGURE_VARIABLE + FRICTION];
    bodies.value[OPTION_INPUT + INPUT_NU1] = line->value[OPTION_FIGURE_VARIABLE + NU];
    bodies.operand = NULL;
    if (line->value[OPTION_TESTS] == NULL)
        usage_error("--input: missing; figure tests needs a series of tests");
    series_table_read(&bodies, how, how->decimal_sign, &table);
    series_table_say(&table);
    inputs->tests = &table;
}

/* The log stands for the loads, and tells the friction. */
static void read_loop(const arguments *line, char decimal_sign, figure_case *inputs)
{
    arguments bodies = *line;
    contact_case *setup = &inputs->history.setup;
    load_history *log = &inputs->history.loads;
    input_texts texts;
    complaint why;
    bodies.value[OPTION_INPUT + INPUT_NU1] = line->value[OPTION_FIGURE_VARIABLE + NU];
    bodies.operand = NULL;
    if (line->value[OPTION_HISTORY] == NULL)
        usage_error("--history: missing; figure measured needs a log with P, Q and displacement");
    if (line->value[OPTION_FIGURE_VARIABLE + FRICTION] != NULL)
        usage_error("--f %s: the log tells the friction",
                    line->value[OPTION_FIGURE_VARIABLE + FRICTION]);
    input_texts_from_options(&bodies, &texts);
    if (!case_read(&texts, CASE_LOADS_APART, setup, &why))
        usage_error("%s", why.text);
    load_history_read_measured(&bodies, decimal_sign, log);
    if (!log_fit_find(setup->contact, log->count, log->load, &inputs->fit, &why))
        failure("%s: %s", log->name, why.text);
}

static const char *read_picture_format(const arguments *line, output_options *how)
{
    static const char *const formats[] = {"svg", "png", "pdf", NULL};
    if (line->value[OPTION_DIGITS] != NULL)
        usage_error("--digits %s: not for a picture; allowed with: --data",
                    line->value[OPTION_DIGITS]);
    if (line->value[OPTION_DECIMAL_COMMA] != NULL)
        usage_error("--decimal-comma: not for a picture; allowed with: --data");
    output_options_read_of(line, formats, "; with --data: csv, tsv, json, xlsx", how);
    return how->format_name;
}

/* ---- What is written ---- */

/* A rows_writer: a picture goes where rows would. */
static void write_figure(void *of_case, records *rows)
{
    figure_case *inputs = of_case;
    dataset numbers = {.column = inputs->kind->column, .text_column = inputs->kind->text_column};
    inputs->kind->compute(inputs, &numbers);
    inputs->error = numbers.error;
    if (inputs->format == NULL)
        dataset_write(&numbers, rows);
    else
        gnuplot_draw(inputs, &numbers, rows->out);
}

static int write_command(const arguments *line)
{
    figure_case inputs = {.kind = choose_figure(line),
                          .no_title = line->value[OPTION_NO_TITLE] != NULL};
    output_options how;
    if (inputs.kind == &figure_loop &&
        (line->value[OPTION_HISTORY] != NULL || line->value[OPTION_LOAD] != NULL))
        inputs.kind = &figure_any_loop;
    if (line->value[OPTION_DATA] != NULL)
        output_options_read(line, &how);
    else
        inputs.format = read_picture_format(line, &how);
    refuse_others(line, inputs.kind);
    if (inputs.kind->has_history)
        read_history(line, how.decimal_sign, &inputs);
    else if (inputs.kind->has_tests)
        read_tests(line, &how, &inputs);
    else if (inputs.kind->has_loop)
        read_loop(line, how.decimal_sign, &inputs);
    else
        read_case(line, &inputs);
    output_options_spare_files(line, &how);
    output_options_write(&how, write_figure, &inputs);
    doubts_say((doubts){.error = inputs.error}, "");
    return STATUS_DONE;
}

static const char *figure_name(int i)
{
    return i < FIGURE_COUNT ? figures[i]->name : NULL;
}

const command figure_command = {
    .name = "figure",
    .summary = "figures 2 to 7 of the paper, and more, as SVG, PNG or PDF",
    .grammar = {options, "FIGURE [OPTION...]", describe_figures, OPTION_LOAD},
    .operand = figure_name,
    .run = write_command};
