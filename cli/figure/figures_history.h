/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures of a contact that goes through a table of loads: "history", "fretting", and the loop of
 * any history. */
#ifndef CLI_FIGURES_HISTORY_H
#define CLI_FIGURES_HISTORY_H

#include "kind.h"

extern const figure figure_history, figure_fretting, figure_measure, figure_any_loop;

#endif
