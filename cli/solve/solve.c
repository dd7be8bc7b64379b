/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve.h"

#include "batch.h"
#include "input/csv_input.h"
#include "input/text_input.h"
#include "options/threads.h"
#include "text/message.h"
#include "model/results.h"

#include "contact/notices.h"
#include "contact/load_table.h"

#include <string.h>

enum { OPTION_INPUT_FILE = OPTION_AFTER_LOADS, OPTION_LAYOUT, OPTION_YIELD_FACTOR };

static const struct poptOption options[] = {
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, input_option_table, 0, "The contact:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, strength_option_table, 0, "Its strength:", NULL},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, load_option_table, 0, "Loads that lead to it:", NULL},
    {"input", 'i', POPT_ARG_STRING, NULL, OPTION_INPUT_FILE,
     "Solve every row of a CSV file; - is standard input", "FILE"},
    {"layout", '\0', POPT_ARG_STRING, NULL, OPTION_LAYOUT,
     "One contact as a list of quantities, or as a row (default list)", "list|row"},
    {"yield-factor", '\0', POPT_ARG_NONE, NULL, OPTION_YIELD_FACTOR,
     "Add how far the state under P and Q is from yield; needs k, takes longer", NULL},
    {NO_FORMULAS_OPTION},
    {THREADS_OPTION},
    {NULL, '\0', POPT_ARG_INCLUDE_TABLE, output_option_table, 0, "Common options:", NULL},
    POPT_TABLEEND,
};

static void describe_results(FILE *stream)
{
    fputs("\nAny consistent units: N and mm with MPa, or N and m with Pa; forces are per unit\n"
          "length. A FILE has columns named like the options (theta_deg, yield_stress); the\n"
          "options stand for columns that it lacks, other columns pass through, and a row\n"
          "that cannot be solved says why in the column error.\n\nResults:\n",
          stream);
    for (int i = 0; i < RESULT_COUNT; i++)
        fprintf(stream, "  %-20s %s\n", result_kinds[i].name, result_kinds[i].meaning);
    fputs("\nQ < f P and sigma are taken to have grown together from 0 under constant P and M;\n"
          "with --load or --history, results are those after the last load. left to tilt\n"
          "come with these, --M or --sigma. What holds only without M and sigma is empty.\n",
          stream);
}

/* ---- One contact ---- */

typedef struct {
    results found;
    bool row;
    results_wanted wanted;
} answer;

static void write_list(const answer *one, records *rows)
{
    static const char *const columns[] = {"quantity", "value", "meaning"};
    for (int i = 0; i < 3; i++)
        rows->format->name(rows, columns[i]);
    rows->format->end_header(rows);
    for (int i = 0; i < RESULT_COUNT; i++) {
        if (!results_include(one->wanted, i))
            continue;
        rows->format->value(rows, columns[0], cell_text(result_kinds[i].name));
        rows->format->value(rows, columns[1], one->found.value[i]);
        rows->format->value(rows, columns[2], cell_text(result_kinds[i].meaning));
        rows->format->end_row(rows);
    }
}

static void write_row(const answer *one, records *rows)
{
    for (int i = 0; i < RESULT_COUNT; i++)
        if (results_include(one->wanted, i))
            rows->format->name(rows, result_kinds[i].name);
    rows->format->end_header(rows);
    for (int i = 0; i < RESULT_COUNT; i++)
        if (results_include(one->wanted, i))
            rows->format->value(rows, result_kinds[i].name, one->found.value[i]);
    rows->format->end_row(rows);
}

static bool write_answer(void *of_answer, records *rows, bool show_progress)
{
    (void)show_progress;
    const answer *one = of_answer;
    if (one->row)
        records_describe(rows, result_kinds, RESULT_COUNT);
    rows->format->begin(rows);
    if (one->row)
        write_row(one, rows);
    else
        write_list(one, rows);
    rows->format->end(rows);
    return records_are_sound(rows);
}

static int answer_one(const contact_case *what, answer *one, const output_options *how)
{
    char complaint[COMPLAINT_SIZE];
    if (!results_compute(what, one->wanted, &one->found, complaint))
        return failure("%s", complaint);
    const int status = output_options_write(how, write_answer, one);
    if (status == STATUS_DONE)
        doubts_say(one->found.doubts, "");
    return status;
}

static int solve_one(const input_texts *texts, answer *one, const output_options *how)
{
    contact_case what;
    char complaint[COMPLAINT_SIZE];
    return case_read(texts, CASE_OF_SOLVE, &what, complaint) ? answer_one(&what, one, how)
                                                             : usage_error("%s", complaint);
}

/* ---- After a history ---- */

static int go_through(const load_source *from, char decimal_sign, contact_case *what,
                      rwedge_contact *contact)
{
    const int status = load_source_apply(from, decimal_sign, what->f, contact);
    if (status != STATUS_DONE)
        return status;
    rwedge_contact_loads(contact, &what->P, &what->M, &what->Q, &what->sigma);
    what->after = contact;
    return what->P > 0 ? STATUS_DONE
                       : failure("%s: the last load has P = 0, which separates the bodies; "
                                 "allowed: a last P above 0",
                                 from->file != NULL ? from->file : "--load");
}

static int solve_history(const input_texts *texts, const load_source *from, answer *one,
                         const output_options *how)
{
    contact_case what;
    char complaint[COMPLAINT_SIZE];
    int status = load_source_check(from, texts);
    if (status == STATUS_DONE && !case_read(texts, CASE_OF_COURSE, &what, complaint))
        status = usage_error("%s", complaint);
    if (status != STATUS_DONE)
        return status;
    rwedge_contact *contact;
    const int32_t made = case_contact(&what, &contact);
    status = made == RWEDGE_OK ? go_through(from, how->decimal_sign, &what, contact)
                               : failure("the contact: %s", rwedge_strerror(made));
    if (status == STATUS_DONE)
        status = answer_one(&what, one, how);
    rwedge_contact_destroy(contact);
    return status;
}

/* ---- The command ---- */

static int read_layout(const arguments *given, bool *row)
{
    const char *text = given->value[OPTION_LAYOUT];
    *row = text != NULL && strcmp(text, "row") == 0;
    if (text != NULL && !*row && strcmp(text, "list") != 0)
        return usage_error("--layout %s: unknown layout; allowed: list, row", text);
    if (text != NULL && !*row && given->value[OPTION_INPUT_FILE] != NULL)
        return usage_error(
            "--layout list: a file has a row for each contact; allowed with --input: row");
    return STATUS_DONE;
}

static int read_yield_factor(const arguments *given, const input_texts *texts, bool *wanted)
{
    *wanted = given->value[OPTION_YIELD_FACTOR] != NULL;
    const bool strength =
        input_is_given(texts, INPUT_K) || input_is_given(texts, INPUT_YIELD_STRESS);
    if (*wanted && !strength && given->value[OPTION_INPUT_FILE] == NULL)
        return usage_error("--yield-factor: needs --k or --yield-stress");
    return STATUS_DONE;
}

/* A file of contacts, or one of loads. */
static int check_files(const batch *many, const load_source *from)
{
    if (many->path != NULL && load_source_is_given(from))
        return usage_error("--%s: given together with --input; allowed: one of the two",
                           from->file != NULL ? "history" : "load");
    if (many->encoding == NULL)
        return STATUS_DONE;
    if (many->path == NULL && from->file == NULL)
        return usage_error("--encoding %s: needs --input or --history", many->encoding);
    return text_input_check(many->encoding);
}

static int solve_given(const batch *many, const load_source *from, answer *one,
                       const output_options *how)
{
    if (many->path != NULL)
        return batch_run(many, how);
    return load_source_is_given(from) ? solve_history(&many->constants, from, one, how)
                                      : solve_one(&many->constants, one, how);
}

static int solve(const arguments *given)
{
    output_options how;
    answer one;
    batch many = {.path = given->value[OPTION_INPUT_FILE],
                  .encoding = given->value[OPTION_ENCODING]};
    const load_source from = load_source_of(given);
    input_texts_from_options(given, &many.constants);
    int status = arguments_no_operand(given);
    if (status == STATUS_DONE)
        status = output_options_read(given, &how);
    if (status == STATUS_DONE)
        status = output_options_spare(&how, many.path != NULL ? many.path : from.file);
    if (status == STATUS_DONE)
        status = check_files(&many, &from);
    if (status == STATUS_DONE)
        status = threads_read(given, &many.threads);
    if (status == STATUS_DONE && given->value[OPTION_THREADS] != NULL && many.path == NULL)
        status = usage_error("--threads %s: needs --input", given->value[OPTION_THREADS]);
    if (status == STATUS_DONE)
        status = read_layout(given, &one.row);
    if (status == STATUS_DONE)
        status = read_yield_factor(given, &many.constants, &one.wanted.yield_factor);
    if (status != STATUS_DONE)
        return status;
    one.wanted.edges = load_source_is_given(&from) || input_is_given(&many.constants, INPUT_M) ||
                       input_is_given(&many.constants, INPUT_SIGMA);
    many.wanted = one.wanted;
    return solve_given(&many, &from, &one, &how);
}

static const syntax grammar = {options, "[OPTION...]", describe_results, OPTION_LOAD};

const command solve_command = {
    "solve",  "rwedge solve", "one contact, or a file of them: sizes, pressures, tension, strength",
    &grammar, NULL,           solve};
