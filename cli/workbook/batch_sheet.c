/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inputs left, results right, named as "solve --input" names its columns; then the working cells,
 * which are hidden. A row refers to itself and to the tables alone: it may be copied. */
#include "workbook.h"

enum { HEADER_ROW, FIRST_ROW };

void sheet_batch(xlsx *book)
{
    const int last = batch_column(case_cell_count);
    case_values values;
    xlsx_text(book, HEADER_ROW, 0, "case", "header");
    for (int i = 0; i < case_cell_count; i++)
        xlsx_text(book, HEADER_ROW, batch_column(i),
                  i < SHOWN_CELLS ? case_cells[i].column : case_cells[i].name,
                  i < FIRST_REMARK ? "upright" : "header");
    for (int row = FIRST_ROW; row < FIRST_ROW + BATCH_ROWS; row++) {
        shown_values(1 + row - FIRST_ROW, &values);
        xlsx_text(book, row, 0, "", "bare");
        for (int i = 0; i < INPUT_CELLS; i++)
            xlsx_number(book, row, batch_column(i), values.number[i], "bare");
        for (int i = INPUT_CELLS; i < case_cell_count; i++)
            case_formula(book, row, batch_column(i), i, &values, "plain", row + 1);
    }
    /* the last row that has an input, beside the hidden names */
    xlsx_formula(book, HEADER_ROW, last,
                 "=MAX(1,SUMPRODUCT(MAX((Batch!$B$2:$N$10000<>\"\")*ROW(Batch!$B$2:$N$10000))))",
                 cell_number(FIRST_ROW + EXAMPLES - 1), "plain");
    xlsx_name(book, "rwt_used", (xlsx_area){HEADER_ROW, last, HEADER_ROW, last});
    /* what is typed or pasted is checked: typing at once, pasting by the column "error" */
    for (int i = 0; i < INPUT_CELLS; i++)
        check_typing(book, (xlsx_area){FIRST_ROW, batch_column(i), BATCH_ROWS, batch_column(i)}, i,
                     FIRST_ROW + 1);
    xlsx_hide_columns(book, batch_column(SHOWN_CELLS), last);
}
