/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_WORKBOOK_H
#define CLI_WORKBOOK_H

#include "sheet/sheet.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- cells ---- The cells of a case: inputs, results, working cells (data/cells.tsv). Each has
 * the name that it has in the calculator. A row of the sheet Batch has the same formulas, with the
 * cells of the row instead of the names. */

/* The inputs come first, then the results, the last two of them texts, then the working cells. */
enum { INPUT_CELLS = 13, SHOWN_CELLS = 38, FIRST_REMARK = SHOWN_CELLS - 2 };

/* Texts, "" where there is none. */
typedef struct {
    const char *name, *label;
    const char *formula; /* with calls of templates */
    const char *column;  /* in Batch, as in "solve"; of three working cells: their common name */
    const char *unit, *hint;
    const char *wrong, *must; /* of an input: the condition that it is not what it must be */
    const char *needed;       /* it must be given */
    const char *examples;     /* of the calculator, then of Batch */
} case_cell;

extern case_cell *case_cells;
extern int case_cell_count;

/* What a call stands for (data/templates.tsv): $1 to $4 are its arguments, $1{+21} the first with
 * +21 in place of #. A call without a text is written in C. The last has no name. */
typedef struct {
    const char *name, *text;
} formula_template;
extern formula_template *formula_templates;

/* Fills both from their tables. */
void cells_read(void);

/* The cell of a column of Batch, "safety"; -1 where it has none of that name. */
int cell_of_column(const char *column);

/* The lines of the files in data/, which the build makes of them; NULL after the last. */
extern const char *const cells_lines[], *const templates_lines[], *const sheets_lines[];

/* The fields of the next line that is no remark, "" where it has none. False after the last. */
enum { FIELDS = 10 };
bool workbook_line(const char *const **next, const char *field[FIELDS]);

/* ---- formula ---- Formulas in which calls of templates are expanded. */

/* The cells of a case in Batch follow its name. */
static inline int batch_column(int number)
{
    return 1 + number;
}

/* The formula with "=" in front, valid until the next. It has the number instead of ~; in a row of
 * Batch, which counts from 1, the cells of that row instead of the names of a case's; 0 for
 * names. */
const char *formula_of(const char *formula, int number, int row);

/* The condition that what is typed into an input is sound: on a row of Batch, or by its name. */
void check_typing(xlsx *book, xlsx_area area, int number, int row);

/* ---- shown ---- The numbers that the file shows until a spreadsheet computes: those of "rwedge
 * solve". */

/* What inputs and results show; NAN is an empty text. Working cells show nothing: they have no
 * value before a spreadsheet computes. */
typedef struct {
    double number[SHOWN_CELLS];
    char branch[12];                  /* the text of yield_branch */
    char strength[400], figures[200]; /* of the calculator */
} case_values;

/* Of an example: 0 is the calculator's, 1 to 3 are those of Batch, others have no inputs and show
 * nothing. */
enum { EXAMPLES = 4 };
void shown_values(int example, case_values *shown);

double shown_number(const case_values *values, const char *column);

/* A cell of a case with its formula: in a row of Batch, or, for 0, under its name. */
void case_formula(xlsx *book, int row, int column, int number, const case_values *values,
                  const char *style, int batch_row);

/* ---- yield_table ---- The table of (A sqrt(J2)/theta)^2, the largest in the half-plane, for each
 * of the two branches of yield: on the surface, and below it; and the curves of the charts. */

typedef struct yield_table yield_table;

/* The curves are those of the case. */
yield_table *yield_table_make(const case_values *values);

/* The numbers of a name, NAN for an empty cell, row by row; how many. */
const double *yield_table_numbers(const yield_table *table, const char *name, int *rows,
                                  int *columns);

/* ---- sheets ---- The workbook as a file, with the sheets as data/sheets.tsv has them. */

void book_write(output *out);

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
