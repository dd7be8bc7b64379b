/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SHEET_H
#define CLI_SHEET_H

#include "number/number.h"
#include "system/system.h"

#include <stdbool.h>

/* ---- xlsx ---- Spreadsheet files, by libxlsxwriter, which this room alone sees: the file, its
 * sheets and their cells. What goes wrong on the way is remembered, and said at the end. */

typedef struct xlsx xlsx;

enum { XLSX_ROWS_MAX = 1048576, XLSX_COLUMNS_MAX = 16384, XLSX_TEXT_MAX = 32767 };

/* Cells of a sheet. Rows and columns count from 0. */
typedef struct {
    int row, column, last_row, last_column;
} xlsx_area;

/* "B2", "A1:C9" */
xlsx_area xlsx_area_of(const char *cells);

/* "$AB" */
enum { XLSX_COLUMN_SIZE = 8 };
void xlsx_column_name(int column, char name[XLSX_COLUMN_SIZE]);

/* NULL; or why this build cannot write such files. */
const char *xlsx_missing(void);

/* For the output. With in_order, cells come row by row from the left, and take no memory. */
xlsx *xlsx_begin(output *out, const char *title, bool in_order);

/* What follows goes to the sheet of this name, which is added where there is none. */
void xlsx_sheet(xlsx *book, const char *name);

/* Cells, each in a style of styles.c, by its name. A number that is not finite is an empty cell. */
void xlsx_number(xlsx *book, int row, int column, double value, const char *style);

/* A text that XML cannot hold spoils the file, and is said at the end. */
void xlsx_text(xlsx *book, int row, int column, const char *text, const char *style);

/* In so many, a last bit that differs between math libraries does not show. */
enum { XLSX_DIGITS = 10 };

/* A formula, in English with commas, and the value that it has: programs that do not compute
 * show that. A number is rounded to these digits; one that is not finite is an empty text. */
void xlsx_formula(xlsx *book, int row, int column, const char *formula, cell value,
                  const char *style);

/* Gives cells of this sheet a name. Spreadsheets do not tell capitals from small letters in
 * names. */
void xlsx_name(xlsx *book, const char *name, xlsx_area area);

void xlsx_width(xlsx *book, int first_column, int last_column, double characters);
/* the height of a row; programs do not all find it themselves */
void xlsx_lines(xlsx *book, int row, int lines);
void xlsx_freeze(xlsx *book, int rows, int columns);

void xlsx_hide_columns(xlsx *book, int first_column, int last_column);
/* Names that begin like this do not show in lists of names; those named so far. */
void xlsx_hide_names(xlsx *book, const char *beginning);

/* What is printed, one page wide: these cells; one page high, or, with so many rows as headers on
 * each, as many pages as it takes. */
void xlsx_print(xlsx *book, xlsx_area area, int headers, bool landscape);

/* Ends the file and writes it to the output, or ends the command where it could not be made;
 * output_finish() reports failures of the output. */
void xlsx_finish(xlsx *book);

/* ---- properties ---- What cells and sheets have besides their contents, by names and texts, ""
 * where there is none. The first text is the place as the user of this room wrote it. Then, for
 *
 * width, lines:  characters of a column, lines of a row.
 * freeze, hide:  what is above and left of the cell does not scroll; the sheet does not show.
 * merge:         the style of the one cell that the area becomes.
 * protect:       but cells of the style "input" none can be typed into; there is no password.
 * print:         as xlsx_print(): headers, and a text for landscape; a place with "=" is a formula.
 * colour:        the style that the area has where the formula, which follows, is true; it is
 *                written for the first cell.
 * rule:          the formula that what is typed must make true, a title, the hint that shows where
 *                the cell is selected, the message with which it is refused.
 * chart:         points with straight lines between them. Its width and height in pixels, and how
 *                far it is right of and below the corner of the cell; a title, with which there is
 *                a legend; least, most and step of x, and of y, 0 for the program's; their titles,
 *                with which there are lines across; the format of x.
 * curve:         the next one of the chart. Its place is a drawing: line, thick, dashed, outline
 *                (black), bar_ground, bar_good, bar_bad (wide lines), mark, or label, the name at
 *                an invisible point. Then the name, or the cell that has it; the ranges of x and y,
 *                "='Sheet'!$A$1:$A$9". */
void xlsx_property(xlsx *book, const char *name, xlsx_area at, const char *const text[]);

#endif
