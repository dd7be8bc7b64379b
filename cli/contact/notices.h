/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What makes results doubtful, said on stderr. */
#ifndef CLI_NOTICES_H
#define CLI_NOTICES_H

#include <stdint.h>

/* A line for each bit of model/doubts.h, after a word on where, or "". */
void doubts_say(int32_t doubts, const char *where);

#endif
