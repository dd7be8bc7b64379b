/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge figure: the paper's figures, and two more, as pictures. */
#ifndef CLI_FIGURE_H
#define CLI_FIGURE_H

#include "options/command.h"

extern const command figure_command;

#endif
