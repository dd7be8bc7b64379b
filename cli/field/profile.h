/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge profile: tractions, stress and slip along the surface. */
#ifndef CLI_PROFILE_H
#define CLI_PROFILE_H

#include "options/command.h"

extern const command profile_command;

#endif
