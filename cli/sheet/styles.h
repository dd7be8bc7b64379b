/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How cells look. */
#ifndef CLI_STYLES_H
#define CLI_STYLES_H

#include "xlsx.h"

/* Adds the styles and the colours to a file that begins. False where memory is short. */
bool xlsx_make_styles(xlsx *book);

#endif
