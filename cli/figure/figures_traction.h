/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figs. 2, 6 and 7: pressure, maximum tension, shear tractions. */
#ifndef CLI_FIGURES_TRACTION_H
#define CLI_FIGURES_TRACTION_H

#include "kind.h"

extern const figure figure_pressure, figure_tension, figure_shear;

#endif
