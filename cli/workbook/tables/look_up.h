/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheet that shows how to interpolate a table. */
#ifndef CLI_LOOK_UP_H
#define CLI_LOOK_UP_H

#include "sheet/xlsx.h"

void sheet_look_up(xlsx *book);

#endif
