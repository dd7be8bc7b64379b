/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A spreadsheet file under way, as the files of this room see it. No other room includes this. */
#ifndef CLI_PARTS_H
#define CLI_PARTS_H

#include "sheet.h"

#include <xlsxwriter.h>

enum { SHEETS_MAX = 12, NAME_MAX_LENGTH = 40 };

struct xlsx {
    lxw_workbook *workbook;
    lxw_worksheet *sheet[SHEETS_MAX], *current;
    char sheet_name[SHEETS_MAX][NAME_MAX_LENGTH];
    int sheet_count, current_index;
    lxw_format *style[XLSX_STYLE_COUNT], *colour[XLSX_COLOUR_COUNT];
    /* libxlsxwriter writes to a path, and seeks in the file. So it first writes a temporary
     * file. */
    spool spool;
    lxw_error error;
};

/* Remembers what went wrong first. Where memory is short, or its temporary folder is full, the
 * library leaves things out. Not all of its functions say so, but errno is set. */
void xlsx_keep(xlsx *book, lxw_error error);

/* Adds the styles and the colours to a file that begins. False where memory is short. */
bool xlsx_make_styles(xlsx *book);

#endif
