/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The option --threads, whatever the command. */
#ifndef CLI_THREADS_H
#define CLI_THREADS_H

/* Reads its text; NULL, where it is not given, is one thread for each processor. STATUS_DONE, or
 * what to leave with. */
int threads_read(const char *text, int *threads);

#endif
