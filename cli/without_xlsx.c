/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All that a build without libxlsxwriter has of spreadsheets: it says that there are none. */
#include "rows/spreadsheet.h"
#include "sheet/xlsx.h"
#include "workbook/book.h"

bool xlsx_available(void)
{
    return false;
}

/* Nobody gets as far as these. */
const record_format xlsx_format = {0};

bool book_write(output *out)
{
    (void)out;
    return false;
}
