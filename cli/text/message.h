/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tool says on stderr, one line at a time. A mistake ends the command: what must be
 * cleaned up is cleaned up by atexit(), and memory is the system's to take back. */
#ifndef CLI_MESSAGE_H
#define CLI_MESSAGE_H

#include "printf_like.h"

#ifdef __GNUC__
#define NO_RETURN __attribute__((noreturn))
#else
#define NO_RETURN
#endif

enum { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

/* The name with which every message begins from now on, such as "rwedge table". The text is kept,
 * not copied. */
void message_speaker_is(const char *speaker);
const char *message_speaker(void);

/* One line on stderr, and exit() with STATUS_USAGE or STATUS_FAILED. They do not return. The line
 * names the option or the file, its value, and what is allowed or what went wrong. To be called by
 * the first thread alone, and not at exit. */
NO_RETURN int usage_error(const char *format, ...) PRINTF_LIKE(1, 2);
NO_RETURN int failure(const char *format, ...) PRINTF_LIKE(1, 2);

/* A line on stderr that is no failure: something that the user should know about a result. */
void notice(const char *format, ...) PRINTF_LIKE(1, 2);

#endif
