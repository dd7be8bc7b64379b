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

/* Each is defined in the file of its name. */
extern const command solve_command, table_command, profile_command, field_command, history_command,
    fretting_command, figure_command, workbook_command;

#endif
