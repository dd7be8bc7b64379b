/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge solve: sizes, pressures, tension and strength of one contact, or of a file of them. */
#include "solve.h"

#include "setup/setup.h"

#include <string.h>

enum {
    OPTION_INPUT_FILE = OPTION_AFTER_LOADS,
    OPTION_LAYOUT,
    OPTION_YIELD_FACTOR,
    OPTION_SHAKEDOWN,
    OPTION_STRENGTH_OF,
    OPTION_VERDICT,
    OPTION_FOR,
    OPTION_SAFETY
};

static const struct poptOption options[] = {
    CONTACT_OPTIONS,
    {INCLUDED(load_option_table), "Loads that lead to it:", NULL},
    {"input", 'i', POPT_ARG_STRING, NULL, OPTION_INPUT_FILE,
     "Solve every row of a CSV file; - is standard input", "FILE"},
    {VALUE("layout", OPTION_LAYOUT),
     "One contact as a list of quantities, or as a row (default list)", "list|row"},
    {FLAG("yield-factor", OPTION_YIELD_FACTOR),
     "Add how far the state under P and Q is from yield; needs k, takes longer", NULL},
    {FLAG("shakedown", OPTION_SHAKEDOWN),
     "Add P_shakedown to the rows of a file too; needs k, takes longer", NULL},
    {VALUE("strength-of", OPTION_STRENGTH_OF),
     "The body whose stresses and yield are computed, which k is of (default 1)", "1|2"},
    {FLAG("verdict", OPTION_VERDICT),
     "Say on standard error what the results come to, of one contact; takes longer", NULL},
    {VALUE("for", OPTION_FOR),
     "Find this input, which is not given, so that the contact has the safety", "radius|a|P|f"},
    {VALUE("safety", OPTION_SAFETY), "P_yield/P, in full sliding, for --for", "NUMBER"},
    {NO_FORMULAS_OPTION},
    {THREADS_OPTION},
    {INCLUDED(output_option_table), "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe_results(FILE *stream)
{
    fputs("\nAny consistent units: N and mm with MPa, or N and m with Pa; forces are per unit\n"
          "length. A FILE has columns named like the options (theta_deg, yield_stress); the\n"
          "options stand for columns that it lacks, other columns pass through, and a row\n"
          "that cannot be solved says why in the column error.\n\nResults:\n",
          stream);
    columns_describe(result_kinds, RESULT_COUNT, 20, stream);
    fputs("\nQ < f P and sigma are taken to have grown together from 0 under constant P and M;\n"
          "with --load or --history, results are those after the last load. left to tilt\n"
          "come with these, --M or --sigma. What holds only without M and sigma is empty.\n",
          stream);
}

/* ---- One contact ---- */

typedef struct {
    results answer;
    bool as_row, says_verdict, is_mirrored;
    results_wanted wanted;
    int looked_for; /* an input, or INPUT_COUNT */
    double safety, answer_for;
} job;

typedef struct {
    const char *name, *meaning;
    cell value;
} shown;

static void write_row(const shown all[], int count, records *rows)
{
    records_describe(rows, result_kinds, RESULT_COUNT);
    for (int i = 0; i < count; i++)
        records_name(rows, all[i].name);
    records_end_header(rows);
    for (int i = 0; i < count; i++)
        records_value(rows, all[i].value);
    records_end_row(rows);
}

static void write_list(const shown all[], int count, records *rows)
{
    static const char *const columns[] = {"quantity", "value", "meaning"};
    records_header(rows, 3, columns);
    for (int i = 0; i < count; i++)
        records_row(rows, 3,
                    (cell[]){cell_text(all[i].name), all[i].value, cell_text(all[i].meaning)});
}

/* What was looked for comes first, unless it is a result anyway. */
static void write_rows(void *of_job, records *rows)
{
    const job *task = of_job;
    const input_kind *found = &input_kinds[task->looked_for];
    shown all[RESULT_COUNT + 1];
    int count = 0;
    if (task->looked_for == INPUT_P || task->looked_for == INPUT_F)
        all[count++] = (shown){found->option, found->meaning, cell_number(task->answer_for)};
    for (int i = 0; i < RESULT_COUNT; i++)
        if (results_include(task->wanted, i))
            all[count++] =
                (shown){result_kinds[i].name, result_kinds[i].meaning, task->answer.value[i]};
    (task->as_row ? write_row : write_list)(all, count, rows);
}

/* ---- The strength of body 2 ---- */

/* Whether it is asked; body 2 is body 1 of the texts then. */
static bool take_strength(const arguments *line, input_texts *texts)
{
    const char *body = line->value[OPTION_STRENGTH_OF];
    complaint why;
    if (body == NULL || strcmp(body, "1") == 0)
        return false;
    if (strcmp(body, "2") != 0)
        usage_error("--strength-of %s: must be 1 or 2", body);
    if (line->value[OPTION_MATERIAL] != NULL)
        usage_error("--strength-of 2: not with --material, which is of body 1; allowed: the "
                    "constants of both bodies");
    if (line->value[OPTION_INPUT_FILE] != NULL || history_is_given(line) ||
        line->value[OPTION_FOR] != NULL)
        usage_error("--strength-of 2: is of one contact and its load, not with --input, --load, "
                    "--history and --for");
    if (!other_body_take(texts, &why))
        usage_error("--strength-of 2: %s", why.text);
    return true;
}

/* ---- The case ---- */

/* The input that is looked for is found; or all are given; or the loads come from a history. */
static void read_case(const arguments *line, const input_texts *texts, job *task, char decimal_sign,
                      contact_case *setup)
{
    const char *file = history_file(line);
    complaint why;
    if (task->looked_for != INPUT_COUNT) {
        if (!inverse_find(texts, task->looked_for, task->safety, setup, &task->answer_for, &why))
            failure("%s", why.text);
    } else if (!history_is_given(line)) {
        if (!case_read(texts, CASE_OF_SOLVE, setup, &why))
            usage_error("%s", why.text);
    } else {
        history_case(line, texts, CASE_OF_HISTORY, decimal_sign, setup);
        rwedge_contact_loads(setup->contact, &setup->P, &setup->M, &setup->Q, &setup->sigma);
        if (!(setup->P > 0))
            failure("%s: the last load has P = 0, which separates the bodies; allowed: a last P "
                    "above 0",
                    file != NULL ? file : "--load");
    }
}

static void solve_one(const arguments *line, const input_texts *texts, job *task,
                      const output_options *how)
{
    contact_case setup;
    complaint why;
    read_case(line, texts, task, how->decimal_sign, &setup);
    task->wanted.moment = setup.is_held;
    task->wanted.coupling = setup.is_coupled;
    task->wanted.edges = task->wanted.edges || setup.is_held || setup.is_coupled;
    results_wanted wanted = task->wanted;
    wanted.yield_factor = wanted.yield_factor || task->says_verdict;
    if (!results_compute(&setup, wanted, &task->answer, &why))
        failure("%s", why.text);
    if (task->is_mirrored)
        other_body_mirror(&task->answer);
    output_options_write(how, write_rows, task);
    doubts_say(task->answer.doubts, "");
    fit_say(&setup);
    if (task->says_verdict)
        notice("%s", verdict_of(&task->answer, how->decimal_sign, "").strength);
}

/* ---- The command ---- */

static void read_task(const arguments *line, const input_texts *texts, const char *file, job *task)
{
    const char *layout = line->value[OPTION_LAYOUT];
    const bool has_strength =
        input_is_given(texts, INPUT_K) || input_is_given(texts, INPUT_YIELD_STRESS);
    task->as_row = layout != NULL && strcmp(layout, "row") == 0;
    if (layout != NULL && !task->as_row && strcmp(layout, "list") != 0)
        usage_error("--layout %s: unknown layout; allowed: list, row", layout);
    if (layout != NULL && !task->as_row && file != NULL)
        usage_error("--layout list: a file has a row for each contact; allowed with --input: row");
    task->wanted.yield_factor = line->value[OPTION_YIELD_FACTOR] != NULL;
    if (task->wanted.yield_factor && !has_strength && file == NULL)
        usage_error("--yield-factor: needs --k or --yield-stress");
    task->wanted.shakedown = file == NULL || line->value[OPTION_SHAKEDOWN] != NULL;
    if (line->value[OPTION_SHAKEDOWN] != NULL && !has_strength && file == NULL)
        usage_error("--shakedown: needs --k or --yield-stress");
    task->wanted.edges = history_is_given(line) || input_is_given(texts, INPUT_M) ||
                         input_is_given(texts, INPUT_SIGMA) ||
                         input_is_given(texts, INPUT_PROFILE) || input_is_given(texts, INPUT_TILT);
    task->wanted.moment = input_is_given(texts, INPUT_TILT);
    task->says_verdict = line->value[OPTION_VERDICT] != NULL;
}

/* Reads --for and --safety: the input to be found must not be given, and there is one contact. */
static void read_inverse(const arguments *line, const input_texts *texts, job *task)
{
    const char *name = line->value[OPTION_FOR], *safety = line->value[OPTION_SAFETY];
    task->looked_for = name == NULL ? INPUT_COUNT : inverse_input(name);
    if (name == NULL && safety != NULL)
        usage_error("--safety %s: needs --for", safety);
    if (name == NULL)
        return;
    if (task->looked_for == INPUT_COUNT)
        usage_error("--for %s: is no input that can be found; allowed: %s", name, inverse_names);
    if (safety == NULL)
        usage_error("--for %s: needs --safety", name);
    if (!number_read(safety, &task->safety) || !(task->safety > 0))
        usage_error("--safety %s: must be a number above 0", safety);
    const int other = input_alternative(task->looked_for);
    if (input_is_given(texts, task->looked_for) || (other >= 0 && input_is_given(texts, other)))
        usage_error("--for %s: it is given too; allowed: one of the two", name);
}

/* A file of contacts, or one of loads. */
static void check_files(const arguments *line, const char *file)
{
    const char *encoding = line->value[OPTION_ENCODING];
    if (file != NULL && history_is_given(line))
        usage_error("--%s: given together with --input; allowed: one of the two",
                    history_file(line) != NULL ? "history" : "load");
    if (file != NULL && line->value[OPTION_COMPLIANCE] != NULL)
        usage_error("--compliance %s: is of one contact, not with --input",
                    line->value[OPTION_COMPLIANCE]);
    if (encoding != NULL && file == NULL && history_file(line) == NULL &&
        line->value[OPTION_INPUT + INPUT_PROFILE] == NULL)
        usage_error("--encoding %s: needs --input, --history or --profile", encoding);
}

static int solve(const arguments *line)
{
    output_options how;
    job task;
    input_texts texts;
    const char *file = line->value[OPTION_INPUT_FILE];
    input_texts_from_options(line, &texts);
    task.is_mirrored = take_strength(line, &texts);
    arguments_no_operand(line);
    output_options_read(line, &how);
    check_files(line, file);
    threads_read(line);
    if (line->value[OPTION_THREADS] != NULL && file == NULL)
        usage_error("--threads %s: needs --input", line->value[OPTION_THREADS]);
    read_task(line, &texts, file, &task);
    read_inverse(line, &texts, &task);
    if (task.says_verdict && file != NULL)
        usage_error("--verdict: is of one contact, not with --input");
    if (task.looked_for != INPUT_COUNT && (file != NULL || history_is_given(line)))
        usage_error("--for %s: is of one contact and its loads, not with --input, --load and "
                    "--history",
                    line->value[OPTION_FOR]);
    if (file != NULL)
        return batch_run(line, file, &texts, task.wanted, &how);
    input_options_check_hull(line);
    history_check(line);
    solve_one(line, &texts, &task, &how);
    return STATUS_DONE;
}

const command solve_command = {
    .name = "solve",
    .summary = "one contact, or a file of them: sizes, pressures, tension, strength",
    .grammar = {options, "[OPTION...]", describe_results, OPTION_LOAD},
    .run = solve};
