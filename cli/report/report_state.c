/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report.h"

#include "document/document.h"

#include <math.h>
#include <string.h>

/* ---- The case ---- */

/* The name in its file, or that of the file. */
static const char *read_name(const arguments *line)
{
    const char *path = line->value[OPTION_CASE];
    if (path == NULL)
        return "Contact";
    const node *name = node_part(document_read(path), "name");
    const char *slash = strrchr(path, '/');
    return name != NULL && name->kind == NODE_TEXT ? name->text : slash != NULL ? slash + 1 : path;
}

static void read_state(const arguments *line, report *to)
{
    complaint why;
    contact_case *setup = &to->setup;
    if (!to->has_history) {
        if (!case_read(&to->texts, CASE_OF_SOLVE, setup, &why))
            usage_error("%s", why.text);
        return;
    }
    history_case(line, &to->texts, CASE_OF_HISTORY, '.', setup);
    const load now = loads_of(setup->contact);
    setup->P = now.P;
    setup->M = now.M;
    setup->Q = now.Q;
    setup->sigma = now.sigma;
    if (!(setup->P > 0))
        failure("the last load has P = 0, which separates the bodies; allowed: a last P above 0");
}

static void compute_state(report *to)
{
    complaint why;
    char length[UNIT_SIZE];
    const input_texts *texts = &to->texts;
    const bool is_held = to->setup.is_held, is_coupled = to->setup.is_coupled;
    to->wanted = (results_wanted){
        .yield_factor = !isnan(to->setup.k),
        .shakedown = !isnan(to->setup.k),
        .edges = to->has_history || is_held || is_coupled || input_is_given(texts, INPUT_M) ||
                 input_is_given(texts, INPUT_SIGMA) || input_is_given(texts, INPUT_PROFILE),
        .moment = is_held,
        .coupling = is_coupled};
    if (!results_compute(&to->setup, to->wanted, &to->answer, &why))
        failure("%s", why.text);
    to->doubts = to->answer.doubts;
    report_unit(to, "length", length);
    to->judged = verdict_of(&to->answer, '.', length);
}

/* ---- A history ---- */

static void note_factor(void *of_report, size_t loads, const rwedge_contact *contact)
{
    report *to = of_report;
    double factor, x, y;
    if (loads == 0 || rwedge_contact_yield_factor(contact, to->setup.nu1, to->setup.k, &factor, &x,
                                                  &y) != RWEDGE_OK)
        return;
    if (!(to->hardest.factor <= factor))
        to->hardest = (hardest_load){factor, x, y, loads};
}

/* The loads, once. */
static void find_hardest(report *to)
{
    contact_history once = to->history;
    once.steps = once.loads.count;
    to->hardest.factor = NAN;
    if (!isnan(to->setup.k))
        contact_history_go(&once, note_factor, to);
    yield_place_settle(&to->hardest.x, &to->hardest.y);
}

static void compute_history(const arguments *line, report *to)
{
    doubts more = {0};
    criteria_read(line, material_of(line), &to->texts, &to->asked);
    contact_history_read(line, &to->texts, '.', 3, 3, &to->history);
    criteria_read_strength(line, &to->history.setup, &to->asked);
    history_cycle(&to->history, &to->asked, &to->last, &more);
    doubts_add(&to->doubts, more);
    find_hardest(to);
    to->worst = (worst_table){.last = &to->last, .below = {NAN, 0, false}};
    to->places = stops_usual(&to->last);
    if (to->places.count == 0)
        return;
    status_check(last_cycle_measure(&to->last, to->places.count, to->places.place), "the places");
    worst_find(&to->places, &to->worst);
}

/* ---- All ---- */

void report_compute(const arguments *line, report *to)
{
    to->line = line;
    to->name = read_name(line);
    input_texts_from_options(line, &to->texts);
    input_options_check_hull(line);
    specimen_refuse(line, "in a report, whose results are of a half-plane");
    history_check(line);
    to->has_history = history_is_given(line);
    read_state(line, to);
    compute_state(to);
    if (to->has_history)
        compute_history(line, to);
}
