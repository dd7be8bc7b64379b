/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge history". */
#ifndef CLI_HISTORY_H
#define CLI_HISTORY_H

#include "options/command.h"

extern const command history_command;

#endif
