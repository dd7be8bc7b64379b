/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_WORKBOOK_H
#define CLI_WORKBOOK_H

#include "sheet/sheet.h"
#include "text/text.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- yield_table ---- The table of (A sqrt(J2)/theta)^2, the largest in the half-plane, for each
 * of the two branches of yield: on the surface, and below it. */

enum { TIPS = 51, NUS = 16, FRICTIONS = 21, FRICTIONS_BELOW = 17, TABLE_COLUMNS = NUS * FRICTIONS };

/* Where it yields, at every other tip: x/(a f) on the surface; x/(a f) and y/a below it. */
enum { PLACE_STEP = 2, PLACE_TIPS = TIPS / PLACE_STEP + 1 };
enum { SURFACE_X, BELOW_X, BELOW_Y, PLACES };

#define WORKBOOK_TIP_MIN 0.003

typedef struct {
    double t[TIPS]; /* ln(tan(phi0/2)), sin(phi0) = a/b; equally spaced, up to 0 */
    double nu[NUS], f[FRICTIONS];
    double surface[TIPS][NUS][FRICTIONS];
    double below[TIPS][NUS][FRICTIONS]; /* 0 where there is no maximum below the surface */
    double place[PLACES][PLACE_TIPS][NUS][FRICTIONS]; /* 0 where the branch does not decide */
} yield_table;

/* To ten digits, as the sheets have numbers: a last bit that differs between math libraries does
 * not show. The second is for a value of the library; it ends the command where that is not
 * finite. */
double workbook_rounded(double value);
double workbook_computed(double value);

void yield_table_fill(yield_table *table);

/* AP/(theta a) of the smallest tip of the table. */
double workbook_end_of_table(void);

/* ---- cells ---- The cells of a case: inputs, results, working cells (data/cells.tsv). Each has
 * the name that it has in the calculator. A row of the sheet Batch has the same formulas, with the
 * cells of the row instead of the names. */

/* The inputs come first, then the results, the last two of them texts, then the working cells. */
enum { INPUT_CELLS = 13, SHOWN_CELLS = 38, FIRST_REMARK = SHOWN_CELLS - 2 };

/* Texts, "" where there is none. */
typedef struct {
    const char *name, *label;
    const char *formula;     /* with calls of templates */
    const char *column;      /* in Batch, as in "solve" */
    const char *unit, *sign; /* "signed" where it may be below 0 */
    const char *hint;
    const char *wrong, *must; /* of an input: the condition that it is not what it must be */
    const char *needed;       /* it must be given */
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

/* The cell of a column of Batch, "safety". */
int cell_of_column(const char *column);

/* The lines of the files in data/, which the build makes of them; NULL after the last. */
extern const char *const about_lines[], *const cells_lines[], *const templates_lines[];

/* The next line that is no remark; NULL after the last. */
const char *workbook_line(const char *const **next);

/* What inputs and results show; NAN is an empty text. Working cells show nothing: they have no
 * value before a spreadsheet computes. */
typedef struct {
    double number[SHOWN_CELLS];
    char branch[12];                  /* the text of yield_branch */
    char strength[400], figures[200]; /* of the calculator */
} case_values;

double shown_number(const case_values *values, const char *column);

/* ---- formula ---- Cells with a formula, in which calls of templates are expanded. */

/* Formulas and texts stay as long as the command. A copy, and one that is put together: */
char *text_copy(const char *text);
const char *compose(const char *format, ...) PRINTF_LIKE(1, 2);

/* "A", "Z", "AA" ... */
const char *column_letters(int column);

/* Where a row has the cells of a case. */
typedef int column_finder(int cell);

/* The formula, a template, with the names of the calculator. */
const char *formula_named(const char *formula);

/* The formula, a template, in a row: the names of a case's cells are replaced by those of the
 * row. */
const char *formula_in_row(const char *formula, int row, column_finder *column_of);

/* The condition, a template, that what is typed into an input is sound, and the message where it is
 * not. */
const char *input_check(int cell);
const char *input_message(int cell);

/* The formula, a template, with a number instead of rwt_i. */
const char *formula_at(const char *formula, int number);

/* A formula and its value, to ten digits; an empty text where there is no such number. */
void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);

/* A cell of a case with its formula: under its name; or in a row. */
void named_cell(xlsx *book, int row, int column, int cell, const case_values *values,
                xlsx_style style);
void cell_in_row(xlsx *book, int row, int cell, column_finder *column_of,
                 const case_values *values);

/* The names of three cells side by side, in the row that has the calculator's. */
void name_triples(xlsx *book, int row, column_finder *column_of);

/* ---- shown ---- The numbers that the file shows until a spreadsheet computes: those of "rwedge
 * solve". */

/* Of sound inputs without a load that slides; NAN where an input is not given. */
void shown_values(const double input[INPUT_CELLS], case_values *shown);

/* The same of a row without inputs: nothing. */
void shown_nothing(case_values *shown);

/* ---- table_sheets ---- The sheets of tables. */

/* Ranges that the charts draw. */
#define TENSION_TIPS "='Maximum tension'!$A$5:$A$105"
#define TENSION_VALUES "='Maximum tension'!$B$5:$B$105"

enum { BRANCH_TIPS = 29 };

/* Each fills the sheet that has been turned to. */
void sheet_elastic_limit(xlsx *book);
void sheet_max_tension(xlsx *book);
void sheet_contact_law(xlsx *book);
void sheet_critical_friction(xlsx *book);
void sheet_look_up(xlsx *book); /* how to interpolate a table */

/* ---- working ---- The hidden sheet: the calculator's working cells in a row, the table of yield,
 * what the charts draw. */

/* Where the charts find their curves and marks: columns of the rows from CURVE_ROW on. */
enum {
    CURVE_ROW = 10,
    CURVE_TIP = 8,
    CURVE_TIP_LIMIT,
    CURVE_FRICTION,
    CURVE_FRICTION_LIMIT,
    CURVE_MARK_TIP,
    CURVE_MARK_FRICTION,
    CURVE_MARK_LIMIT,
    CURVE_MARK_TENSION,
    CURVES_END
};
#define WORKING_SHEET "Working"

/* The calculator's sketch: lines, and names at single points. Its columns follow CURVES_END, x and
 * y of each part. */
enum { SKETCH_PARTS = 18, SKETCH_POINTS = 9 };
typedef struct {
    const char *name;
    int points;
    double x[SKETCH_POINTS], y[SKETCH_POINTS];
} sketch_part;
extern const sketch_part sketch[SKETCH_PARTS];

/* The names of the curves, below each other in the column after the sketch's. LibreOffice loses
 * names that are in no cell when a sheet is inserted in front. */
enum {
    LEGEND_NORMAL,
    LEGEND_DEPTH,
    LEGEND_TIP_CURVE,
    LEGEND_CASE,
    LEGEND_FRICTION_CURVE,
    LEGEND_TENSION,
    LEGEND_FAMILY, /* a/b = 1 to 0.1 */
    LEGEND_END = LEGEND_FAMILY + 10,
    LEGEND_COLUMN = CURVES_END + 2 * SKETCH_PARTS
};

/* The bar of the verdict: places in one column, heights of its parts in the next three. */
enum {
    BAR_COLUMN = LEGEND_COLUMN + 1,
    BAR_FROM_0 = 0,
    BAR_FROM_FACTOR,
    BAR_LIMIT = 3,
    BAR_MOST = 3
};

void sheet_working(xlsx *book, const yield_table *table, const case_values *values);

/* ---- charts ---- The calculator's pictures: a sketch, and Figs. 3, 4 and 6 of the paper, with its
 * case in them. */

/* The height of the figures. */
enum { FIGURE_ROWS = 22 };

/* The contact with the letters in it, as the inputs name them. */
void draw_sketch(xlsx *book, int row, int column);

/* The factor of the verdict as a bar, with a line where it yields. */
void draw_bar(xlsx *book, int row, int column);

/* The figures stand side by side, from the first column on. */
void draw_figures(xlsx *book, int row);

/* ---- calculator ---- The calculator: inputs, checks, results. */

/* Fills the sheet that has been turned to; and the values of its case, which the sheet of working
 * cells needs. */
void sheet_calculator(xlsx *book, case_values *values);

/* ---- batch_sheet ---- The sheet with a case a row. */

enum { BATCH_ROWS = 200 };

void sheet_batch(xlsx *book);

/* ---- book ---- The workbook as a file. */

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
