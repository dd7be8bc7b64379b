/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Another program, run to its end. */
#ifndef CLI_PROGRAM_H
#define CLI_PROGRAM_H

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    bool by_signal;
    int number; /* of the signal, or the exit status */
} program_end;

/* Runs words[0], looked for on PATH, with the three files as its standard streams. These
 * variables, "NAME=value", become part of the environment. Lists end with NULL. 0; or errno where
 * it could not be run. */
int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end);

#endif
