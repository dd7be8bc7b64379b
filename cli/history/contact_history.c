/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>

struct poptOption history_option_table[] = {
    {INCLUDED(load_option_table), NULL, NULL},
    {VALUE("cycles", OPTION_CYCLES),
     "Go through the loads N times, one after the other (default: see below)", "N"},
    {FLAG("until", OPTION_UNTIL),
     "Where a load cannot be applied, go as far as the loads before it", NULL},
    {FLAG("clip", OPTION_CLIP), "Let |Q| above f P slide, and P below 0 separate the bodies", NULL},
    {VALUE("turning-points", OPTION_TURNING_POINTS),
     "Keep loads at which Q, M, sigma turn by more than TOL of their range, P of the largest",
     "TOL"},
    {VALUE("specimen-thickness", OPTION_SPECIMEN_THICKNESS),
     "Body 1 is so thick, on a base without friction; P is constant", "LENGTH"},
    {FLAG("opposite", OPTION_OPPOSITE), "Beside the thickness: it lies between two opposite pads",
     NULL},
    POPT_TABLEEND,
};

enum { CYCLES_MAX = 1000000 };

int64_t contact_history_cycles(const arguments *line, int64_t usual)
{
    const char *text = line->value[OPTION_CYCLES];
    int64_t cycles = usual;
    if (text != NULL && !number_read_whole(text, 1, CYCLES_MAX, &cycles))
        usage_error("--cycles %s: must be a whole number from 1 to %d", text, CYCLES_MAX);
    return cycles;
}

size_t contact_history_row(const contact_history *history, size_t step)
{
    return step % history->loads.count;
}

static bool presses(const load_history *loads)
{
    for (size_t i = 0; i < loads->count; i++)
        if (loads->load[i].P > 0)
            return true;
    return false;
}

/* What noise in a log does is mended by an option. */
static void name_clip(const load_history *loads, size_t row, double f, complaint *why)
{
    const load refused = loads->load[row];
    if (refused.P < 0 && presses(loads))
        list_add(why->text, sizeof why->text, "; ", "--clip separates the bodies there");
    if (refused.P >= 0 && f > 0 && !refused.is_driven && fabs(refused.Q) > f * refused.P)
        list_add(why->text, sizeof why->text, "; ", "--clip lets it slide");
}

/* Where there are several cycles, a word says in which a load is refused. */
static void end_before(const contact_history *history, size_t step, complaint *why)
{
    char word[40] = "", place[LOAD_PLACE_SIZE];
    const size_t row = contact_history_row(history, step);
    name_clip(&history->loads, row, history->setup.f, why);
    if (step >= history->loads.count)
        snprintf(word, sizeof word, ", cycle %zu", step / history->loads.count + 1);
    if (!history->is_until || step == 0)
        load_history_fail(&history->loads, row, word, why);
    notice("%s%s: %s; the results end before it", load_history_place(&history->loads, row, place),
           word, why->text);
}

size_t contact_history_go(const contact_history *history, load_visitor *visit, void *context)
{
    const load_history *loads = &history->loads;
    complaint why = {""};
    rwedge_contact *contact;
    size_t step = 0;
    status_check(rwedge_contact_copy(history->setup.contact, &contact), "the contact");
    progress_start(history->shows_progress, (int64_t)history->steps, "loads");
    visit(context, 0, contact);
    while (step < history->steps &&
           loads_apply_next(loads->load[contact_history_row(history, step)], &history->setup.shape,
                            history->setup.f, contact, &why)) {
        visit(context, ++step, contact);
        progress_step();
    }
    progress_erase();
    rwedge_contact_destroy(contact);
    if (why.text[0] != '\0')
        end_before(history, step, &why);
    return step;
}

void contact_history_read(const arguments *line, const input_texts *texts, char decimal_sign,
                          int64_t cycles, int64_t cycles_of_two, contact_history *history)
{
    const char *word = line->operand != NULL ? line->operand[0] : NULL;
    complaint why;
    *history = (contact_history){0};
    input_options_check_hull(line);
    if (word != NULL && line->operand[1] != NULL)
        usage_error("%s: unexpected; allowed: one file of loads", line->operand[1]);
    if (word != NULL && line->value[OPTION_HISTORY] != NULL)
        usage_error("%s: given together with --history; allowed: one of the two", word);
    if (!history_is_given(line))
        usage_error("a file of loads must follow, with the columns P and Q, perhaps M "
                    "or tilt, sigma; or --load P,Q for each");
    history_check(line);
    contact_history_cycles(line, cycles);
    if (!case_read(texts, CASE_OF_HISTORY, &history->setup, &why))
        usage_error("%s", why.text);
    status_check(history->setup.status, "the contact");
    load_history_read(line, decimal_sign, &history->loads);
    loads_filter(line, history->setup.f, &history->loads);
    load_history_check(&history->loads, &history->setup);
    load_history before;
    const bool has_before = history_file(line) != NULL && line->value[OPTION_LOAD] != NULL;
    if (has_before)
        load_history_read_list(line, &before);
    specimen_take(line, &history->loads, has_before ? &before : NULL, &history->setup);
    if (has_before) {
        load_history_check(&before, &history->setup);
        load_history_apply_all(&before, &history->setup, &history->doubts_before);
    }
    history->cycles =
        contact_history_cycles(line, history->loads.count == 2 ? cycles_of_two : cycles);
    history->steps = history->loads.count * (size_t)history->cycles;
    history->is_until = line->value[OPTION_UNTIL] != NULL;
    history->shows_progress = line->value[OPTION_QUIET] == NULL && stream_is_terminal(stderr);
}
