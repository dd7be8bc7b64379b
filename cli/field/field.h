/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge field: stresses on a grid below the surface. */
#ifndef CLI_FIELD_H
#define CLI_FIELD_H

#include "options/command.h"

extern const command field_command;

#endif
