/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_HISTORY_H
#define CLI_HISTORY_H

#include "rows/rows.h"
#include "setup/setup.h"

/* ---- contact_history ---- A contact and the loads it goes through, once or again and again. */

enum {
    OPTION_CYCLES = OPTION_AFTER_LOADS,
    OPTION_UNTIL,
    OPTION_CLIP,
    OPTION_TURNING_POINTS,
    OPTION_SPECIMEN_THICKNESS,
    OPTION_OPPOSITE,
    OPTION_AFTER_HISTORY
};

/* A command's own table includes it, by POPT_ARG_INCLUDE_TABLE, after that of the inputs. */
extern struct poptOption history_option_table[];

typedef struct {
    contact_case setup; /* the contact is that before the first cycle */
    doubts doubts_before;
    load_history loads;
    int64_t cycles; /* how often the table is gone through */
    size_t steps;   /* how many loads that are */
    bool is_until;  /* a load that cannot be applied ends the history, not the command */
    bool shows_progress;
} contact_history;

/* Reads --cycles. */
int64_t contact_history_cycles(const arguments *line, int64_t usual);

/* Reads the options, and a file that stands in place of --history. Beside a file, --load gives
 * loads before the first cycle, which are applied. The cycles are those where --cycles is not
 * given, and where there are two loads, to and fro. */
void contact_history_read(const arguments *line, const input_texts *texts, char decimal_sign,
                          int64_t cycles, int64_t cycles_of_two, contact_history *history);

/* The row of the table that the load of this step stands in, the first step 0. */
size_t contact_history_row(const contact_history *history, size_t step);

/* Sees the contact after so many loads; 0 is before the first cycle. */
typedef void load_visitor(void *context, size_t loads, const rwedge_contact *contact);

/* Applies each load once, and shows the contact before the first and after each. A load that cannot
 * be applied ends the command, or with --until the history. Returns how many were applied. */
size_t contact_history_go(const contact_history *history, load_visitor *visit, void *context);

/* ---- specimen ---- A specimen of finite thickness in place of the half-plane. */

/* Gives it to the contact of a case, which has no loads yet, and says how well that holds. Two
 * lists of loads, the second may be NULL: all have one P. */
void specimen_take(const arguments *line, const load_history *loads, const load_history *before,
                   contact_case *setup);

/* Refuses it where the half-plane stays, after words such as "in a report". */
void specimen_refuse(const arguments *line, const char *where);

/* ---- load_filters ---- A log as it was measured, made fit. */

/* Leaves the loads that --clip, under this friction, and --turning-points leave. What was done is
 * said. */
void loads_filter(const arguments *line, double f, load_history *loads);

/* ---- log_cycles ---- The cycles of a log, by what goes to and fro in it. */

typedef double load_part(const load *at);

/* The displacement; what tells the cycles of loads: that, where a rig drives them, else Q, or sigma
 * where Q stays. */
load_part load_displacement;
load_part *load_part_of_cycles(size_t count, const load row[]);

/* The rows at which cycles begin: the part rises through the middle of its range. The last is where
 * the last whole one ends. To be freed. */
typedef struct {
    size_t *at;
    size_t count; /* one more than the whole cycles, or 0 */
} log_cycles;

log_cycles log_cycles_find(size_t count, const load row[], load_part *part);

/* ---- cycle_rows ---- What a contact undergoes in each whole cycle of a log. */

enum { CYCLE_COLUMNS = 9 };
extern const column_kind cycle_columns[CYCLE_COLUMNS];

/* Goes through the loads; a row for each cycle, then their mean. */
typedef struct cycle_table cycle_table;
cycle_table *cycle_table_compute(const contact_history *history); /* to be freed */
void cycle_table_write(void *of_table, records *rows);
void cycle_table_free(cycle_table *table);

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

/* Goes through the loads, which can be applied. A row for each load and point, the points of the
 * first load first. */
void point_rows_write(const contact_history *history, const places *at, records *rows);

/* Columns of a file of loads that are no loads: they go in front of the results. */
void passed_names(const load_history *loads, records *rows);
void passed_cells(const load_history *loads, size_t row, records *rows);

/* Refuses a column that has the name of this result. */
void passed_check(const load_history *loads, const char *result);

#endif
