/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report.h"

#include "document/document.h"
#include "figure/figure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 4, INPUT_DIGITS = 8, LOADS_SHOWN = 8 };

/* ---- Texts ---- */

static void put_count(output *out, const char *text, size_t count)
{
    for (const char *c = text; c < text + count && *c != '\0'; c++) {
        const char *entity = *c == '&' ? "&amp;" : *c == '<' ? "&lt;" : *c == '"' ? "&quot;" : NULL;
        if (entity != NULL)
            output_text(out, entity);
        else
            output_write(out, c, 1);
    }
}

static void put(output *out, const char *text)
{
    put_count(out, text, strlen(text));
}

/* Without remarks, and what is of the command line. */
static void put_meaning(output *out, const char *meaning)
{
    static const char *const ends[] = {";",        ", or --",      ", in place of --", " (default",
                                       " instead", ", in radians", ", whose",          ", 0 to "};
    size_t length = strlen(meaning);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        const char *end = strstr(meaning, ends[i]);
        if (end != NULL && (size_t)(end - meaning) < length)
            length = (size_t)(end - meaning);
    }
    put_count(out, meaning, length);
}

static void put_digits(output *out, double value, int digits)
{
    char text[NUMBER_SIZE];
    if (isnan(value))
        return;
    if (isinf(value)) {
        output_text(out, value > 0 ? "∞" : "−∞");
        return;
    }
    number_write(fabs(value), digits, '.', text);
    output_print(out, "%s%s", value < 0 ? "−" : "", text);
}

/* Puts the number of a result. */
static void put_number(output *out, double value)
{
    put_digits(out, value, DIGITS);
}

static void put_cell(output *out, cell value)
{
    if (value.text != NULL)
        put(out, value.text);
    else
        put_number(out, value.number);
}

static void put_unit(const report *from, output *out, const char *dimension)
{
    char label[UNIT_SIZE];
    report_unit(from, dimension, label);
    put(out, label);
}

/* ---- Head ---- */

static void put_name(const report *from, output *out)
{
    put(out, from->name);
}

static void put_made(const report *from, output *out)
{
    const char *units = from->line->value[OPTION_UNITS];
    output_print(out, "rwedge %s: ", rwedge_version());
    put(out, invocation());
    output_text(out, units != NULL ? "; units " : "; any consistent units");
    put(out, units != NULL ? units : "");
}

/* ---- Verdict ---- */

/* The hardest of the loads may yield where the last one does not. */
static bool yields_before(const report *from)
{
    return from->has_history && from->hardest.factor < 1 && strcmp(from->judged.colour, "red") != 0;
}

static void put_colour(const report *from, output *out)
{
    const bool is_doubtful = doubts_matter(from->doubts) && from->judged.colour[0] == 'g';
    output_text(out, yields_before(from) ? "red" : is_doubtful ? "amber" : from->judged.colour);
}

static void put_state(const report *from, output *out)
{
    if (yields_before(from))
        output_print(out, "YIELDS: the stress after load %zu is above the yield stress. ",
                     from->hardest.load);
    if (from->has_history)
        output_text(out, "After the last load: ");
    put(out, from->judged.text);
}

static void put_strength(const report *from, output *out)
{
    put(out, from->judged.strength);
}

static bool has_hardest(const report *from)
{
    return from->has_history && !isnan(from->hardest.factor);
}

static void put_hardest(const report *from, output *out)
{
    output_print(out, "Of all loads, load %zu is the hardest: a factor of ", from->hardest.load);
    put_number(out, from->hardest.factor);
    output_text(out, " on the stress, at x = ");
    put_number(out, from->hardest.x);
    output_text(out, ", y = ");
    put_number(out, from->hardest.y);
    output_text(out, ".");
}

/* ---- Inputs ---- */

/* A line of a name, its meaning, and what follows; ended by end_line(). */
static void begin_line(output *out, const char *meaning, const char *name)
{
    output_text(out, "<div><span>");
    put_meaning(out, meaning);
    output_print(out, " <span class=\"meaning\">%s</span></span><b>", name);
}

static void end_line(const report *from, output *out, const char *dimension)
{
    output_text(out, "</b><i>");
    put_unit(from, out, dimension);
    output_text(out, "</i></div>\n");
}

static void put_input(const report *from, output *out, int i)
{
    const input_kind *kind = &input_kinds[i];
    complaint why;
    double value;
    begin_line(out, kind->meaning, kind->column);
    if (i == INPUT_PROFILE)
        put(out, from->texts.text[i]);
    else if (input_read(&from->texts, i, &value, &why))
        put_digits(out, value, INPUT_DIGITS);
    end_line(from, out, kind->unit);
}

/* Where the constants of a shipped material are from; nothing of others. */
static void put_source(const shipped_material *shipped, output *out)
{
    if (shipped == NULL)
        return;
    const node *top = document_read_text(shipped->text, shipped->name);
    output_text(out, "<p class=\"meaning\">");
    put(out, node_part(top, "name")->text);
    output_text(out, ": ");
    put(out, node_part(top, "source")->text);
    output_text(out, "</p>\n");
}

static void put_inputs(const report *from, output *out)
{
    const char *body1 = from->line->value[OPTION_MATERIAL];
    if (body1 != NULL) {
        begin_line(out, "Material of body 1", "");
        put(out, body1[0] == '{' ? "constants of the case" : body1);
        end_line(from, out, "none");
        put_source(shipped_material_named(body1), out);
    }
    for (int i = 0; i < INPUT_COUNT; i++)
        if (input_is_given(&from->texts, i))
            put_input(from, out, i);
}

static bool has_history(const report *from)
{
    return from->has_history;
}

static void put_loads_caption(const report *from, output *out)
{
    const size_t count = from->history.loads.count;
    output_print(out, "%zu load%s", count, count == 1 ? "" : "s");
    if (count > LOADS_SHOWN)
        output_print(out, ", of which the first %d are shown", LOADS_SHOWN);
}

static void put_loads(const report *from, output *out)
{
    const load_history *loads = &from->history.loads;
    output_text(out, "<tr><th>load</th><th>P</th><th>M</th><th>Q</th><th>sigma</th></tr>\n");
    for (size_t i = 0; i < loads->count && i < LOADS_SHOWN; i++) {
        const load *one = &loads->load[i];
        const double number[] = {one->P, one->M, one->Q, one->sigma};
        output_print(out, "<tr><td>%zu</td>", i + 1);
        for (int k = 0; k < 4; k++) {
            output_text(out, "<td>");
            put_digits(out, number[k], INPUT_DIGITS);
            output_text(out, "</td>");
        }
        output_text(out, "</tr>\n");
    }
}

/* ---- Results ---- */

static bool is_shown(const report *from, int i)
{
    const cell *value = &from->answer.value[i];
    const bool is_empty = value->text != NULL ? value->text[0] == '\0' : isnan(value->number);
    return results_include(from->wanted, i) && i != RESULT_WARNINGS && !is_empty;
}

static void put_results(const report *from, output *out)
{
    for (int i = 0; i < RESULT_COUNT; i++) {
        if (!is_shown(from, i))
            continue;
        begin_line(out, result_kinds[i].meaning, result_kinds[i].name);
        put_cell(out, from->answer.value[i]);
        end_line(from, out, result_kinds[i].unit);
    }
}

/* ---- Pictures ---- */

static bool has_pictures(const report *from)
{
    return from->shows_pictures;
}

static void put_picture(const report *from, const figure *kind, output *out)
{
    char length[UNIT_SIZE], stress[UNIT_SIZE];
    figure_case inputs = {.kind = kind,
                          .format = "svg",
                          .is_part = true,
                          .state = &from->setup,
                          .length_unit = length,
                          .stress_unit = stress};
    dataset rows = {.column = kind->column};
    report_unit(from, "length", length);
    report_unit(from, "stress", stress);
    kind->compute(&inputs, &rows);
    gnuplot_draw(&inputs, &rows, out);
    free(rows.row);
}

static void put_picture_contact(const report *from, output *out)
{
    put_picture(from, &figure_contact, out);
}

static void put_picture_tractions(const report *from, output *out)
{
    put_picture(from, &figure_tractions, out);
}

static void put_picture_stress(const report *from, output *out)
{
    put_picture(from, &figure_stress, out);
}

/* ---- The cycle ---- */

static void put_cycle_caption(const report *from, output *out)
{
    output_print(
        out,
        "Where each measure is largest along the surface, in the last of %lld passes of the "
        "loads",
        (long long)from->history.cycles);
}

static void put_measure(const report *from, output *out, int i)
{
    const measure_kind *kind = measure_kind_of(i);
    const worst_row *row = &from->worst.row[i];
    const int criterion = measure_criterion(i);
    criterion_verdict judged = {NAN, NAN, NAN, NAN};
    measured_place at = {.x = row->x, .y = row->y};
    if (criterion >= 0) {
        status_check(last_cycle_measure(&from->last, 1, &at), "the worst place");
        judged = criterion_verdict_at(&from->asked, &at, criterion);
    }
    const double number[] = {judged.allowable, judged.safety, judged.life};
    output_text(out, "<tr><td>");
    put(out, kind->title);
    output_print(out, " <span class=\"meaning\">%s</span></td><td>", kind->column);
    put_number(out, row->value);
    output_text(out, "</td><td class=\"unit\">");
    put_unit(from, out, kind->unit);
    output_text(out, "</td><td>");
    put_number(out, row->x);
    for (int k = 0; k < 3; k++) {
        output_text(out, "</td><td>");
        put_number(out, number[k]);
    }
    output_text(out, "</td></tr>\n");
}

static void put_cycle(const report *from, output *out)
{
    output_text(out, "<tr><th>measure</th><th>largest</th><th></th><th>at x</th><th>allowable</th>"
                     "<th>safety</th><th>life, passes</th></tr>\n");
    for (int i = 0; i < measure_count() && from->places.count > 0; i++)
        if (!isnan(from->worst.row[i].value))
            put_measure(from, out, i);
}

static void put_shakedown(const report *from, output *out)
{
    double lower, upper, x, y;
    if (isnan(from->setup.k) || from->last.cycle == NULL ||
        rwedge_cycle_shakedown(from->last.cycle, from->asked.nu, from->setup.k, &lower, &upper, &x,
                               &y) != RWEDGE_OK)
        return;
    output_text(out, "Shakedown: with all stresses times ");
    put_number(out, lower);
    output_text(out, " the cycle is sure to be elastic after some yield at first; above ");
    put_number(out, upper);
    output_text(out, " times it goes on yielding.");
}

/* ---- What was assumed, and which errors are told ---- */

static void item(void *to, const char *text)
{
    output *out = to;
    output_text(out, "<li>");
    put(out, text);
    output_text(out, "</li>\n");
}

static void put_assumed(const report *from, output *out)
{
    char *const *value = from->line->value;
    const case_said said = {.has_history = from->has_history,
                            .has_E2 = input_is_given(&from->texts, INPUT_E2),
                            .has_f = input_is_given(&from->texts, INPUT_F),
                            .fits = value[OPTION_FIT] != NULL,
                            .takes_hull = value[OPTION_HULL] != NULL,
                            .has_units = value[OPTION_UNITS] != NULL,
                            .has_width = value[OPTION_WIDTH] != NULL};
    assumptions_tell(&from->setup, &said, item, out);
}

static void put_errors(const report *from, output *out)
{
    const bool lacks_slip = from->has_history && !from->last.slip_known;
    errors_tell(&from->setup, from->doubts, lacks_slip, item, out);
}

/* ---- Equations ---- */

static bool has_equations(const report *from)
{
    return from->shows_equations;
}

static void put_equations(const report *from, output *out)
{
    equation all[EQUATIONS_MAX];
    const int count = equations_of(&from->setup, &from->answer, all);
    char number[NUMBER_SIZE];
    for (int i = 0; i < count; i++) {
        number_write(all[i].value, 6, '.', number);
        output_print(out, "<p><b>%s</b> = %s = <code>%s</code> = <b>%s</b> ", all[i].name,
                     all[i].symbols, all[i].numbers, number);
        put_unit(from, out, all[i].unit);
        output_text(out, "</p>\n");
    }
}

/* ---- The template ---- */

/* A name writes itself, or says whether what stands below it is there. */
static const struct {
    const char *name;
    void (*put)(const report *from, output *out);
    bool (*is_there)(const report *from);
} parts[] = {
    {"name", put_name, NULL},
    {"made", put_made, NULL},
    {"colour", put_colour, NULL},
    {"state", put_state, NULL},
    {"strength", put_strength, NULL},
    {"hardest", put_hardest, has_hardest},
    {"inputs", put_inputs, NULL},
    {"history", NULL, has_history},
    {"loads_caption", put_loads_caption, NULL},
    {"loads", put_loads, NULL},
    {"results", put_results, NULL},
    {"pictures", NULL, has_pictures},
    {"picture_contact", put_picture_contact, NULL},
    {"picture_tractions", put_picture_tractions, NULL},
    {"picture_stress", put_picture_stress, NULL},
    {"cycle_caption", put_cycle_caption, NULL},
    {"cycle", put_cycle, NULL},
    {"shakedown", put_shakedown, NULL},
    {"assumed", put_assumed, NULL},
    {"errors", put_errors, NULL},
    {"equations", put_equations, has_equations},
};
enum { PARTS = sizeof parts / sizeof parts[0] };

/* The part of a name that ends with "}}". */
static int part_named(const char *name)
{
    for (int i = 0; i < PARTS; i++)
        if (strncmp(name, parts[i].name, strlen(parts[i].name)) == 0 &&
            strncmp(name + strlen(parts[i].name), "}}", 2) == 0)
            return i;
    failure("the page has no part %.30s", name);
}

static void write_line(const report *from, const char *text, output *out)
{
    const char *name;
    while ((name = strstr(text, "{{")) != NULL) {
        output_write(out, text, (size_t)(name - text));
        parts[part_named(name + 2)].put(from, out);
        text = strstr(name, "}}") + 2;
    }
    output_print(out, "%s\n", text);
}

void report_write(const report *from, output *out)
{
    static const char condition[] = "{{if ", end[] = "{{end}}";
    bool is_there = true;
    for (const char *const *text = page_lines; *text != NULL; text++)
        if (strncmp(*text, condition, sizeof condition - 1) == 0)
            is_there = parts[part_named(*text + sizeof condition - 1)].is_there(from);
        else if (strcmp(*text, end) == 0)
            is_there = true;
        else if (is_there)
            write_line(from, *text, out);
}
