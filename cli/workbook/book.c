/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "workbook.h"

void book_write(output *out)
{
    const char *problem;
    cells_read();
    xlsx *book = xlsx_begin("rwedge: contact of a rounded wedge", false, &problem);
    if (book != NULL) {
        sheets_write(book);
        problem = xlsx_finish(book, out);
    }
    if (problem != NULL)
        failure("%s: %s", out->name, problem);
}
