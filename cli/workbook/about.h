/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheet "About". */
#ifndef CLI_ABOUT_H
#define CLI_ABOUT_H

#include "sheet/xlsx.h"

void sheet_about(xlsx *book);

#endif
