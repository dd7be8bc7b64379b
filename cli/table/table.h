/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge table: lookup tables. */
#ifndef CLI_TABLE_H
#define CLI_TABLE_H

#include "options/command.h"

extern const command table_command;

#endif
