/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes inputs and results doubtful, said on stderr. */
#ifndef CLI_NOTICES_H
#define CLI_NOTICES_H

#include "model/doubts.h"

/* A line for each, after a word on where, or "". */
void doubts_say(doubts all, const char *where);

/* A line, unless it is "". */
void notice_if_any(const char *text);

#endif
