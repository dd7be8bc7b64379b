/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheets of the workbook. */
#ifndef CLI_WORKBOOK_SHEETS_H
#define CLI_WORKBOOK_SHEETS_H

#include "workbook_model.h"
#include "xlsx.h"

enum {
    SHEET_CALCULATOR,
    SHEET_ELASTIC_LIMIT,
    SHEET_MAX_TENSION,
    SHEET_CONTACT_LAW,
    SHEET_CRITICAL_FRICTION,
    SHEET_ABOUT
};

/* Names of the tables that the calculator's formulas use; the rest of the names are defined
 * where they are written. */
#define NAME_SURFACE "rwt_surface"
#define NAME_BELOW "rwt_below"

/* Ranges that the charts draw, on the sheets of tables. */
#define TENSION_TIPS "='Maximum tension'!$A$5:$A$105"
#define TENSION_VALUES "='Maximum tension'!$B$5:$B$105"

/* Each fills its sheet, which has been turned to. False where the library could not compute a
 * value. */
void sheet_calculator(xlsx *book, const limit_table *table);
void sheet_working(xlsx *book, const limit_table *table, const workbook_inputs *in,
                   const workbook_results *out);
void sheet_charts(xlsx *book, int row, int column);
bool sheet_elastic_limit(xlsx *book, const limit_table *table);
void sheet_max_tension(xlsx *book);
void sheet_contact_law(xlsx *book);
bool sheet_critical_friction(xlsx *book);
void sheet_about(xlsx *book);

/* Where the calculator's working cells begin, right of what is printed, and what its charts draw
 * of them. */
enum {
    WORKING_STEPS = 38,
    WORKING_COLUMN = 18,
    WORKING_ROW = 5,
    TIPS_COLUMN = WORKING_COLUMN + 10,
    FRICTIONS_COLUMN = TIPS_COLUMN + 11
};

/* A chart's height. */
enum { CHART_ROWS = 17 };

/* A formula or a text put together. */
#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
const char *
compose(char text[], const char *format, ...);
enum { FORMULA_SIZE = 1200 };

/* A formula and its value, to ten digits; an empty text where there is no such number. */
void formula_cell(xlsx *book, int row, int column, const char *formula, double value,
                  xlsx_style style);

#endif
