/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hysteresis loops of a cycle of Q. */
#ifndef CLI_FIGURE_LOOP_H
#define CLI_FIGURE_LOOP_H

#include "kind.h"

extern const figure figure_loop;

#endif
