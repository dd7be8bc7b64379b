/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 3, 4 and 5: the elastic limit, and where it yields. */
#ifndef CLI_FIGURES_STRENGTH_H
#define CLI_FIGURES_STRENGTH_H

#include "kind.h"

extern const figure figure_normal, figure_sliding, figure_yield_point;

#endif
