/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The option --threads, whatever the command. */
#ifndef CLI_THREADS_H
#define CLI_THREADS_H

#include "arguments.h"

/* An entry of a table. */
#define THREADS_OPTION                                                                             \
    "threads", '\0', POPT_ARG_STRING, NULL, OPTION_THREADS,                                        \
        "Threads that compute; the rows are the same for any N (default: one for each processor)", \
        "N"

/* Reads it; where it is not given there is one thread for each processor. */
int threads_read(const arguments *line);

#endif
