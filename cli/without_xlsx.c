/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All that a build without libxlsxwriter has of spreadsheets: it says that there are none. */
#include "rows/spreadsheet.h"
#include "sheet/xlsx.h"
#include "workbook/book.h"

const char *xlsx_missing(void)
{
    return "this build cannot write XLSX: it was made without libxlsxwriter "
           "(on Debian and Ubuntu the package libxlsxwriter-dev)";
}

/* Nobody gets as far as these. */
const record_format xlsx_format = {0};

bool book_write(output *out)
{
    (void)out;
    return false;
}
