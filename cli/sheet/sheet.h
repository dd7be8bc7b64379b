/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SHEET_H
#define CLI_SHEET_H

#include "system/system.h"

#include <stdbool.h>

/* ---- xlsx ---- Spreadsheet files, by libxlsxwriter, which this room alone sees: the file, its
 * sheets and their cells. What goes wrong on the way is remembered, and said at the end. */

typedef struct xlsx xlsx;

typedef enum {
    XLSX_PLAIN, /* text, or a number as the program likes it */
    XLSX_TITLE,
    XLSX_HEADING,
    XLSX_HEADER,  /* of a table's column: bold, a line below, wrapped */
    XLSX_UPRIGHT, /* the same, read from below: the column may be narrow */
    XLSX_NOTE,    /* small print */
    XLSX_WRAPPED, /* a paragraph */
    XLSX_INPUT,   /* a cell to type into */
    XLSX_BARE,    /* the same without a frame: xlsx_colour_when() shows where it is */
    XLSX_RESULT,  /* about six significant digits */
    XLSX_SIGNED,  /* the same where it may be below 0 */
    XLSX_UNIT,    /* a text after a number */
    XLSX_NUMBER,  /* up to six decimals */
    XLSX_SMALL,   /* up to eight */
    XLSX_LARGE,   /* up to three */
    XLSX_FIXED_4, /* four decimals */
    XLSX_FIXED_6,
    XLSX_POWER,   /* six digits and an exponent */
    XLSX_VERDICT, /* a text in a frame over several cells, wrapped */
    XLSX_STRONG,  /* a result that matters */
    XLSX_STYLE_COUNT
} xlsx_style;

enum { XLSX_ROWS_MAX = 1048576, XLSX_COLUMNS_MAX = 16384, XLSX_TEXT_MAX = 32767 };

/* NULL; or why this build cannot write such files. */
const char *xlsx_missing(void);

/* With in_order, cells come row by row from the left, and take no memory. NULL, with the problem,
 * where it cannot be begun. */
xlsx *xlsx_begin(const char *title, bool in_order, const char **problem);

/* Adds a sheet; what follows goes there, until the next or xlsx_turn_to(). */
void xlsx_sheet(xlsx *book, const char *name);
void xlsx_turn_to(xlsx *book, int sheet);

/* Rows and columns count from 0. A number that is not finite is an empty cell. */
void xlsx_number(xlsx *book, int row, int column, double value, xlsx_style style);

/* A text that XML cannot hold spoils the file, and is said at the end. */
void xlsx_text(xlsx *book, int row, int column, const char *text, xlsx_style style);

/* A formula, in English with commas, and the value that it has: programs that do not compute
 * show that. */
void xlsx_formula(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);
void xlsx_text_formula(xlsx *book, int row, int column, const char *formula, const char *value,
                       xlsx_style style);

/* Gives cells of this sheet a name. Spreadsheets do not tell capitals from small letters in
 * names. */
void xlsx_name(xlsx *book, const char *name, int row, int column);
void xlsx_name_range(xlsx *book, const char *name, int row, int column, int rows, int columns);

void xlsx_width(xlsx *book, int first_column, int last_column, double characters);
/* the height of a row; programs do not all find it themselves */
void xlsx_lines(xlsx *book, int row, int lines);
void xlsx_freeze(xlsx *book, int rows, int columns);

void xlsx_hide_sheet(xlsx *book);
void xlsx_hide_columns(xlsx *book, int first_column, int last_column);
/* Cells but those of XLSX_INPUT cannot be typed into; there is no password. */
void xlsx_protect(xlsx *book);
/* Names that begin like this do not show in lists of names; those named so far. */
void xlsx_hide_names(xlsx *book, const char *beginning);

typedef struct {
    int row, column, rows, columns;
} xlsx_area;

/* Makes one cell of an area. */
void xlsx_merge(xlsx *book, xlsx_area area, xlsx_style style);

/* The area has the colour where the formula, written for its first cell, is true. */
typedef enum {
    XLSX_GREEN,
    XLSX_AMBER,
    XLSX_RED,
    XLSX_YELLOW, /* as XLSX_INPUT and XLSX_RESULT */
    XLSX_BLUE,
    XLSX_COLOUR_COUNT
} xlsx_colour;
void xlsx_colour_when(xlsx *book, xlsx_area area, const char *formula, xlsx_colour colour);

/* What is typed into the area must make the formula true, or is refused with the message; the hint
 * shows where the cell is selected. */
typedef struct {
    const char *formula, *title, *hint, *message;
} xlsx_rule;
void xlsx_validate(xlsx *book, xlsx_area area, const xlsx_rule *rule);

/* What is printed, one page wide: the cells up to this one; one page high, or as many as it takes,
 * with the header on each. */
typedef struct {
    int last_row, last_column;
    int header_row; /* -1: one page */
    bool landscape;
    const char *area; /* the cells instead, as a formula; or NULL */
} xlsx_page;
void xlsx_print(xlsx *book, xlsx_page page);

/* Ends the file and writes it to the output. NULL, or why it could not be made; output_finish()
 * reports failures of the output. */
const char *xlsx_finish(xlsx *book, output *out);

/* ---- chart ---- Charts of points with straight lines between them. */

enum { XLSX_SERIES_MAX = 24 };
typedef enum {
    XLSX_LINE,
    XLSX_THICK_LINE,
    XLSX_DASHED_LINE,
    XLSX_MARK,
    XLSX_OUTLINE,    /* black */
    XLSX_BAR_GROUND, /* wide lines */
    XLSX_BAR_GOOD,
    XLSX_BAR_BAD,
    XLSX_LABEL /* the name, at an invisible point */
} xlsx_drawing;
typedef struct {
    const char *name;  /* in the legend, or a cell that has it, "='Sheet'!$A$1"; NULL for none */
    const char *x, *y; /* ranges, "='Sheet'!$A$1:$A$9" */
    xlsx_drawing drawing;
} xlsx_series;
typedef struct {
    const char *title, *x_title, *y_title; /* NULL for none */
    double x_min, x_max, x_step, y_min, y_max;
    int width, height; /* pixels */
    int right, down;   /* pixels from the corner of the cell */
    bool bare;         /* no axes, no legend */
    const char
        *x_format; /* of the numbers along x: a bare picture has them too; NULL for the usual */
    xlsx_series series[XLSX_SERIES_MAX];
    int series_count;
} xlsx_chart;
void xlsx_draw(xlsx *book, int row, int column, const xlsx_chart *chart);

#endif
