/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion for bash, zsh and fish, written from the tables of options that drive the parsing. */
#ifndef CLI_COMPLETION_H
#define CLI_COMPLETION_H

#include "command.h"

/* Prints the completion of a shell; `own` has the options that may stand in front of a command. */
void completion_print(const char *shell, const command *const commands[], int count,
                      const struct poptOption *own);

#endif
