/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What main() and the shells' completion know of a command. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include "arguments.h"

typedef struct {
    const char *name, *whole_name, *summary;
    const struct poptOption *options;
    const char *(*operand)(int i);           /* the words that may follow, NULL after the last; NULL where none may */
    int (*run)(int argc, const char **argv); /* argv[0] is the whole name; returns the exit status */
} command;

#endif
