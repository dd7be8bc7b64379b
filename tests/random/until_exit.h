/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tool ends its process after a mistake, and leaves memory and files to the system. Here the
 * process goes on: exit() comes back, and what was left is taken back. */
#ifndef UNTIL_EXIT_H
#define UNTIL_EXIT_H

enum { NO_EXIT = -1 };

/* Calls a part of the tool. The status that it called exit() with, or NO_EXIT where it returned. */
int until_exit(void (*part)(void *context), void *context);

#endif
