/* SPDX-License-Identifier: GPL-3.0-or-later */
/* XLSX. */
#ifndef CLI_SPREADSHEET_H
#define CLI_SPREADSHEET_H

#include "records.h"

/* What follows, a header first, goes to the next of several sheets. */
void spreadsheet_next_sheet(records *rows);

#endif
