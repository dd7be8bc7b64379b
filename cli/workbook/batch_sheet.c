/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Inputs left, results right, named as "solve --input" names its columns; then the working cells,
 * which are hidden. A row refers to itself and to the tables alone: it may be copied. */
#include "workbook.h"

enum { HEADER_ROW, FIRST_ROW };

/* The last row that has an input, beside the hidden names. */
static void write_used(xlsx *book)
{
    const int column = batch_column(case_cell_count);
    xlsx_formula(book, HEADER_ROW, column,
                 "=MAX(1,SUMPRODUCT(MAX((Batch!$B$2:$N$10000<>\"\")*ROW(Batch!$B$2:$N$10000))))",
                 cell_number(FIRST_ROW + EXAMPLES - 1), "plain");
    xlsx_name(book, "rwt_used", (xlsx_area){HEADER_ROW, column, HEADER_ROW, column});
}

void sheet_batch(xlsx *book)
{
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
    write_used(book);
    /* what is typed or pasted is checked: typing at once, pasting by the column "error" */
    for (int i = 0; i < INPUT_CELLS; i++)
        check_typing(book, (xlsx_area){FIRST_ROW, batch_column(i), BATCH_ROWS, batch_column(i)}, i,
                     FIRST_ROW + 1);
    xlsx_hide_columns(book, batch_column(SHOWN_CELLS), batch_column(case_cell_count));
}
