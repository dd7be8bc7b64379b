/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

static void note(const contact_case *setup, const rwedge_contact *contact, doubts *all)
{
    if (all != NULL)
        doubts_add(all, doubts_of_state(setup, contact));
}

/* Loads before the first cycle that the contact may yield under. */
static void note_before(const contact_history *history, doubts *all)
{
    char complaint[COMPLAINT_SIZE];
    rwedge_contact *contact;
    if (case_contact(&history->setup, &contact) != RWEDGE_OK)
        return;
    for (size_t i = 0; i < history->before.count; i++)
        if (load_history_apply(&history->before, i, history->setup.f, contact, complaint))
            note(&history->setup, contact, all);
    rwedge_contact_destroy(contact);
}

void history_cycle(const contact_history *history, const criteria *asked, last_cycle *cycle,
                   doubts *all)
{
    const size_t steps = history->steps, rows = history->loads.count;
    const size_t first = steps > rows ? steps - rows : 0;
    note_before(history, all);
    rwedge_contact *contact = contact_history_begin(history);
    for (size_t step = 0; step < steps; step++) {
        if (step == first)
            last_cycle_begin(&history->setup, asked, contact, steps - first, cycle);
        contact_history_go_on(history, step, contact);
        if (step < first)
            continue;
        last_cycle_add(contact, cycle);
        note(&history->setup, contact, all);
    }
    rwedge_contact_destroy(contact);
    last_cycle_end(cycle);
}
