/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A spreadsheet file under way, as the files of this room see it. No other room includes this. */
#ifndef CLI_PARTS_H
#define CLI_PARTS_H

#include "sheet.h"

#include <xlsxwriter.h>

enum { XLSX_STYLES = 25 };

struct xlsx {
    output *out;
    lxw_workbook *workbook;
    lxw_worksheet *current;
    lxw_format *style[XLSX_STYLES]; /* as styles.c has them */
    lxw_chart *chart; /* the last, NULL for lack of memory; its curves, and where it goes */
    int curves;
    xlsx_area chart_cell;
    lxw_chart_options chart_place;
    /* libxlsxwriter writes to a path, and seeks in the file. So it first writes a temporary
     * file. */
    spool spool;
    lxw_error error;
};

/* The arguments that a cell and an area are for the library. */
#define CELL_AT(row, column) (lxw_row_t)(row), (lxw_col_t)(column)
#define CELLS(area)                                                                                \
    (lxw_row_t)(area).row, (lxw_col_t)(area).column, (lxw_row_t)(area).last_row,                   \
        (lxw_col_t)(area).last_column

/* Remembers what went wrong first. Where memory is short, or its temporary folder is full, the
 * library leaves things out. Not all of its functions say so, but errno is set. */
void xlsx_keep(xlsx *book, lxw_error error);

/* Properties of the file chart. */
void xlsx_chart(xlsx *book, xlsx_area at, const char *const text[]);
void xlsx_curve(xlsx *book, const char *const text[]);

/* Adds the styles to a file that begins. False where memory is short. */
bool xlsx_make_styles(xlsx *book);

/* That of a name; NULL is plain. */
lxw_format *xlsx_style(const xlsx *book, const char *name);

#endif
