/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>

struct poptOption history_option_table[] = {
    {INCLUDED(load_option_table), NULL, NULL},
    {VALUE("cycles", OPTION_CYCLES),
     "Go through the loads N times, one after the other (default: see below)", "N"},
    {FLAG("until", OPTION_UNTIL),
     "Where a load cannot be applied, go as far as the loads before it", NULL},
    POPT_TABLEEND,
};

enum { CYCLES_MAX = 1000000 };

static int64_t read_cycles(const arguments *line, int64_t usual)
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

load contact_history_load(const contact_history *history, size_t step)
{
    return history->loads.load[contact_history_row(history, step)];
}

rwedge_contact *contact_history_begin(const contact_history *history)
{
    rwedge_contact *contact;
    status_check(rwedge_contact_copy(history->setup.contact, &contact), "the contact");
    return contact;
}

void contact_history_go_on(const contact_history *history, size_t step, rwedge_contact *contact)
{
    status_check(loads_apply(contact_history_load(history, step), contact), "the loads");
}

/* Where there are several cycles, the word says in which a load is refused. */
static void try_loads(contact_history *history, bool until)
{
    char word[40] = "", place[LOAD_PLACE_SIZE];
    const size_t wanted = history->loads.count * (size_t)history->cycles;
    complaint why = {""};
    rwedge_contact *contact = contact_history_begin(history);
    while (history->steps < wanted &&
           loads_apply_next(contact_history_load(history, history->steps), history->setup.f,
                            contact, &why)) {
        history->steps++;
        history->error = fmax(history->error, rwedge_contact_error(contact));
    }
    if (why.text[0] == '\0')
        return;
    const size_t step = history->steps, row = contact_history_row(history, step);
    if (step >= history->loads.count)
        snprintf(word, sizeof word, ", cycle %zu", step / history->loads.count + 1);
    if (!until || step == 0)
        load_history_fail(&history->loads, row, word, &why);
    notice("%s%s: %s; the results end before it", load_history_place(&history->loads, row, place),
           word, why.text);
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
        usage_error("a file of loads must follow, with the columns P and Q, perhaps M, "
                    "sigma; or --load P,Q for each");
    history_check(line);
    read_cycles(line, cycles);
    if (!case_read(texts, CASE_OF_HISTORY, &history->setup, &why))
        usage_error("%s", why.text);
    status_check(history->setup.status, "the contact");
    load_history_read(line, decimal_sign, &history->loads);
    if (history_file(line) != NULL && line->value[OPTION_LOAD] != NULL) {
        load_history before;
        load_history_read_list(line, &before);
        load_history_apply_all(&before, &history->setup, &history->doubts_before);
    }
    history->cycles = read_cycles(line, history->loads.count == 2 ? cycles_of_two : cycles);
    try_loads(history, line->value[OPTION_UNTIL] != NULL);
}
