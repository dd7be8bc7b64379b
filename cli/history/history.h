/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_HISTORY_H
#define CLI_HISTORY_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- contact_history ---- A contact and the loads it goes through, once or again and again. */

enum { OPTION_CYCLES = OPTION_AFTER_LOADS, OPTION_UNTIL, OPTION_AFTER_HISTORY };

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE, after that of the inputs. */
extern struct poptOption history_option_table[];

typedef struct {
    contact_case setup; /* the contact is that before the first cycle */
    doubts doubts_before;
    load_history loads;
    int64_t cycles; /* how often the table is gone through */
    size_t steps;   /* how many loads are applied: all, or with --until those before the first that
                       cannot be */
    double error;   /* the largest rwedge_contact_error() after any of them */
} contact_history;

/* Reads the options, and a file that stands in place of --history, and tries every load: a load
 * that cannot be applied ends the command, unless --until is given. Beside a file, --load gives
 * loads before the first cycle. The cycles are those where --cycles is not given, and where there
 * are two loads, to and fro. */
void contact_history_read(const arguments *line, const input_texts *texts, char decimal_sign,
                          int64_t cycles, int64_t cycles_of_two, contact_history *history);

/* The row of the table that the load of this step stands in. */
size_t contact_history_row(const contact_history *history, size_t step);
load contact_history_load(const contact_history *history, size_t step);

/* A copy of the contact before its first cycle. */
rwedge_contact *contact_history_begin(const contact_history *history);

/* Applies the load of a step, which has been tried. */
void contact_history_go_on(const contact_history *history, size_t step, rwedge_contact *contact);

/* ---- places ---- The points of body 1 that are looked at: a list, a file of them, or a grid. */

enum {
    OPTION_AT = OPTION_AFTER_HISTORY,
    OPTION_POINTS,
    OPTION_X,
    OPTION_DEPTH,
    OPTION_AFTER_PLACES
};

extern struct poptOption place_option_table[];

typedef struct {
    double *x, *y;
    size_t count;   /* 0 where no option gives any */
    size_t columns; /* of a grid, whose points are row by row, x fastest; 0 for other places */
} places;

/* Reads --at or --points; or --x with --depth, which is 0 by default. */
void places_read(const arguments *line, char decimal_sign, places *to);

/* Reads --depth alone: 0 by default. */
void places_read_depth(const arguments *line, range *depth);

/* ---- point_rows ---- The stresses at points after each load, as rows. */

/* The columns of the result, but for those of the file that pass through in front. */
enum { POINT_COLUMNS = 11 };
extern const char *const point_columns[POINT_COLUMNS];

typedef struct {
    const contact_history *history;
    const places *at;
} point_rows;

/* A row for each load and point, the points of the first load first. */
void point_rows_write(const point_rows *points, records *rows);

/* The stress at one of the points; NAN where it is infinite. */
tensor point_rows_stress(const point_rows *points, const rwedge_contact *contact, size_t i);

/* Columns of a file of loads that are no loads: they go in front of the results. */
void passed_names(const load_history *loads, records *rows);
void passed_cells(const load_history *loads, size_t row, records *rows);

/* Refuses a column that has the name of this result. */
void passed_check(const load_history *loads, const char *result);

#endif
