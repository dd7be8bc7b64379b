/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shear traction and stick zone where a bulk tension grows with Q. */
#ifndef CLI_FIGURE_ECCENTRIC_H
#define CLI_FIGURE_ECCENTRIC_H

#include "kind.h"

extern const figure figure_eccentric;

#endif
