/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge fretting". */
#ifndef CLI_FRETTING_H
#define CLI_FRETTING_H

#include "options/command.h"

extern const command fretting_command;

#endif
