/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge solve: sizes, pressures, tension and strength of one contact, or of a file of them. */
#ifndef CLI_SOLVE_H
#define CLI_SOLVE_H

#include "options/command.h"

extern const command solve_command;

#endif
