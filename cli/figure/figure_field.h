/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contours of von Mises' stress below the contact. */
#ifndef CLI_FIGURE_FIELD_H
#define CLI_FIGURE_FIELD_H

#include "kind.h"

extern const figure figure_field;

#endif
