/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_WORKBOOK_H
#define CLI_WORKBOOK_H

/* ---- csv_sheets ---- CSV files as the sheets of one spreadsheet. */

enum { CSV_SHEETS_MAX = 10 };

typedef struct {
    const char **path; /* a list that ends with NULL */
    char decimal_sign;
} csv_files;

/* Writes a sheet for each file. It is named as the file, or what is nearest to that, which is said.
 * Ends where a file cannot be read. */
struct records;
void csv_sheets_write(void *of_files, struct records *rows);

#endif
