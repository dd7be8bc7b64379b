/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SHEET_H
#define CLI_SHEET_H

#include "number/number.h"
#include "system/system.h"

#include <stdbool.h>

/* ---- xlsx ---- Spreadsheet files: the file, its sheets and their cells. What goes wrong on the
 * way is remembered, and said at the end. */

typedef struct xlsx xlsx;

enum { XLSX_ROWS_MAX = 1048576, XLSX_COLUMNS_MAX = 16384, XLSX_TEXT_MAX = 32767 };

/* How a cell looks; the last four are numbers with so many decimals. */
typedef enum {
    XLSX_PLAIN,
    XLSX_TITLE,
    XLSX_HEADING,
    XLSX_HEADER, /* of a column */
    XLSX_UNIT,   /* a text after a number */
    XLSX_LARGE,
    XLSX_MIDDLE,
    XLSX_SMALL,
    XLSX_POWER, /* of ten */
    XLSX_STYLES
} xlsx_style;

/* NULL; or why this build cannot write such files. */
const char *xlsx_missing(void);

/* Begins a workbook that goes to the output. Cells come row by row from the left, and take no
 * memory. */
xlsx *xlsx_begin(output *out, const char *title);

/* What follows goes to the sheet of this name, which is added where there is none. */
void xlsx_sheet(xlsx *book, const char *name);

/* Cells, whose rows and columns count from 0. */
void xlsx_number(xlsx *book, int row, int column, double value, xlsx_style style);
/* A text that XML cannot hold spoils the file, and is said at the end. */
void xlsx_text(xlsx *book, int row, int column, const char *text, xlsx_style style);

void xlsx_width(xlsx *book, int column, double characters);
/* What is above and left of the cell does not scroll. */
void xlsx_freeze(xlsx *book, int row, int column);

/* What is printed, one page wide: the cells up to the last; one page high, or, with the first row
 * on each, as many pages as it takes. */
typedef enum { XLSX_ONE_PAGE, XLSX_PAGES } xlsx_pages;
void xlsx_print(xlsx *book, int last_row, int last_column, xlsx_pages pages, bool landscape);

/* Ends the file and writes it to the output, or ends the command where it could not be made;
 * output_finish() reports failures of the output. */
void xlsx_finish(xlsx *book);

#endif
