/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What main() and the shells' completion know of a command. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include "arguments.h"

typedef struct {
    const char *name, *whole_name, *summary;
    const syntax *grammar;
    /* the words that may follow, NULL after the last; NULL where none may */
    const char *(*operand)(int i);
    int (*run)(const arguments *line); /* returns the exit status */
} command;

#endif
