/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last cycle of a history of loads that a command was given. */
#ifndef CLI_HISTORY_CYCLE_H
#define CLI_HISTORY_CYCLE_H

#include "history/contact_history.h"
#include "model/cycle/last_cycle.h"
#include "model/doubts.h"

/* Goes through the history. Where doubts is not NULL it has those of the states after its loads. */
void history_cycle(const contact_history *history, const criteria *asked, last_cycle *cycle,
                   doubts *all);

#endif
