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

/* What a program opens to read its standard input as a file; "-", the usual word for it, where it
 * has no name. */
extern const char program_input_name[];

/* Runs words[0], looked for on PATH, with the three files as its standard streams. These
 * variables, "NAME=value", become part of the environment. Lists end with NULL. 0; or errno where
 * it could not be run. */
int program_run(const char *const words[], const char *const variables[], FILE *const streams[3],
                program_end *end);

#endif
