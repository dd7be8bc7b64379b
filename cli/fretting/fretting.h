/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_FRETTING_H
#define CLI_FRETTING_H

#include "history/history.h"
#include "model/cycle/cycle.h"
#include "model/series/series.h"

/* ---- surface ---- The last cycle of a history of loads that a command was given, and the places
 * at which it is measured. */

/* Goes through the history. Where doubts is not NULL it has those of the states after its loads. */
void history_cycle(const contact_history *history, const criteria *asked, last_cycle *cycle,
                   doubts *all);

/* The places of --x or, where it is not given, from one side of the contact to the other, at each
 * of the depths; of --at or --points as they are. There is room for a worst place of each
 * measure. */
void surface_places(const arguments *line, char decimal_sign, const last_cycle *cycle,
                    measured *result);

/* ---- criteria_options ---- Options of criteria of fatigue: which are asked for, and their
 * constants. */

/* OPTION_CONSTANT + i is that of a material's constant, where it has one. */
enum {
    OPTION_CONSTANT = OPTION_AFTER_PLACES,
    OPTION_CRITERIA = OPTION_CONSTANT + MATERIAL_MAX,
    OPTION_ARCHARD,
    OPTION_AFTER_CRITERIA
};

/* Makes the table of the library's criteria, before any command is read. */
void criteria_options_prepare(void);
extern struct poptOption criteria_option_table[];

/* Reads the options. */
void criteria_read(const arguments *line, const material *constants, const input_texts *texts,
                   criteria *asked);

/* To be called when the contact is read: takes the constants of what is asked for. */
void criteria_read_strength(const arguments *line, const contact_case *setup, criteria *asked);

/* ---- worn_columns ---- The end of wear of a cycle of Q alone, as columns. */

typedef struct {
    const rwedge_contact *before;
    double Q_a; /* half of the range of Q */
    double left, right, worn_left, worn_right, area, depth;
} full_wear;

enum { FULL_WEAR_COLUMNS = 4 };
extern const char *const full_wear_columns[FULL_WEAR_COLUMNS];

/* What is wrong with the cycle ends the command. */
void full_wear_find(const last_cycle *last, full_wear *wear);

/* The columns of a place. */
void full_wear_write(const full_wear *wear, double x, double y, records *rows);

/* ---- worst ---- Where each column of "rwedge fretting" is worst, also between the places: a line,
 * or a table. */

typedef struct {
    const last_cycle *last;
    distance below;  /* where criteria count, beside the surface */
    bool is_verdict; /* criteria alone are written; those of --criteria where it is given */
    worst_row row[COLUMN_MAX];
} worst_table;

void worst_find(const measured *result, worst_table *worst);

/* The worst places between the places become places too. */
void worst_add_places(const worst_table *worst, measured *result);

/* "swt 1.2 at x = -0.3; swt_damage 0.01 at x = -0.3 (2 cycles)"; "" where
 * there is none. Depths where they matter. */
void worst_write(const worst_table *worst, bool is_deep, char *text, size_t size);

/* A row for each: a rows_writer of a worst_table. The life is "inf" for a run-out. */
void worst_write_rows(void *of_worst, records *rows);

/* ---- series_table ---- A table of tests, each gone through. */

/* The tables of commands have them after the criteria; the angle is a command's own entry. */
enum {
    OPTION_TESTS = OPTION_AFTER_CRITERIA,
    OPTION_FIT_LENGTH,
    OPTION_LENGTH,
    OPTION_METHOD,
    OPTION_ANGLE,
    OPTION_AFTER_SERIES
};
extern struct poptOption series_option_table[];

/* The critical distance that --length, --method and --angle give. */
distance distance_read(const arguments *line, const material *constants);

typedef struct {
    csv_row row;
    size_t log;    /* its number, from 1; 0 is none */
    complaint why; /* why it has no results; "" */
} test_row;

typedef struct {
    series all;
    table_input file;
    test_row *row; /* as many as tests */
    test_run *run;
    size_t count, failed;
} series_table;

/* Reads the table of --input, goes through its tests, and fits a length where that is asked for.
 * Files of loads are none that is written; `out` may be NULL. It must not move. */
void series_table_read(const arguments *line, const output_options *out, char decimal_sign,
                       series_table *table);

/* ---- series_rows ---- */

/* What is to be known of a table: errors, doubts, what was passed over. */
void series_table_say(series_table *table);

/* The tests as rows, their cells in front. Returns the exit status: that of a failure where there
 * are tests and every one has an error. */
int series_table_write(series_table *table, const output_options *how);

#endif
