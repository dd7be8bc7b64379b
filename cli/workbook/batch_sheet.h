/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheet with a case a row. */
#ifndef CLI_BATCH_SHEET_H
#define CLI_BATCH_SHEET_H

#include "sheet/xlsx.h"

enum { BATCH_ROWS = 200 };

void sheet_batch(xlsx *book);

#endif
