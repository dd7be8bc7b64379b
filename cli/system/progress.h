/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far long work has come, on stderr: "rwedge table: 12345 of 650000 rows", once it has taken
 * half a second. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

/* Shown only where stderr is a terminal, and stdout, when it takes the rows, is not. */
bool progress_wanted(bool rows_to_stdout);

/* total is the number of units, or this where it is not known. */
#define PROGRESS_NO_TOTAL INT64_C(-1)
void progress_start(bool wanted, int64_t total, const char *unit);

/* To be called for every row. It is cheap: it looks at the clock every few rows only. */
void progress_step(void);

/* Removes the line from the terminal. Safe in a signal handler. */
void progress_erase(void);

#endif
