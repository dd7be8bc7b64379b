/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV files as the sheets of one spreadsheet. */
#ifndef CLI_CSV_SHEETS_H
#define CLI_CSV_SHEETS_H

#include "rows/records.h"

#include <stdbool.h>

enum { CSV_SHEETS_MAX = 10 };

/* Writes the files, whose list ends with NULL, a sheet each, named as the file. False, with the
 * reason said, where one cannot be read or written. */
bool csv_sheets_write(void *paths, records *rows, bool show_progress);

#endif
