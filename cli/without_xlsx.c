/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stands for all code of spreadsheets in a build without libxlsxwriter. It says that this build
 * writes none. */
#include "rows/rows.h"

const char *xlsx_missing(void)
{
    return "this build cannot write XLSX: it was made without libxlsxwriter "
           "(on Debian and Ubuntu the package libxlsxwriter-dev)";
}

/* The linker needs these. No command uses them, because it has said first that it cannot write. */
const record_format xlsx_format = {0};

void spreadsheet_next_sheet(records *rows)
{
    (void)rows;
}
