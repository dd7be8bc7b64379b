/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tool says on stderr, one line at a time, and the exit status that goes with it. */
#ifndef CLI_MESSAGE_H
#define CLI_MESSAGE_H

#include "printf_like.h"

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

/* Who speaks from now on, "rwedge table": it opens every message. The text is kept, not copied. */
void message_speaker_is(const char *speaker);
const char *message_speaker(void);

/* One line on stderr each; what they return is the status to leave with. A line names the option
 * or the file, its value, and what is allowed or what went wrong. */
int usage_error(const char *format, ...) PRINTF_LIKE(1, 2);
int failure(const char *format, ...) PRINTF_LIKE(1, 2);

/* A line that is no failure: what the user should know of a result. */
void notice(const char *format, ...) PRINTF_LIKE(1, 2);

#endif
