/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Many cases: the rows of a table, and what all of them have in common. */
#ifndef CLI_CASE_TABLE_H
#define CLI_CASE_TABLE_H

#include "header.h"
#include "model/results/results.h"

typedef struct {
    header names;
    input_texts constants; /* for the columns that the table does not have */
    results_wanted wanted; /* the edges too where a column needs them */
    char separator;
    bool shown[RESULT_COUNT]; /* the results that become columns */
} case_table;

/* The column after the results, which says why a row has none. */
extern const char case_table_error[];

/* To be called before any row, when the other members are set: chooses the results that are shown.
 * False, with the complaint, where columns and constants cannot give a contact, or where a column
 * has the name of a result. */
bool case_table_begin(case_table *table, char complaint[COMPLAINT_SIZE]);

/* Solves a row of `count` cells. False, with the complaint, where it has no results. Several
 * threads may call it at a time. */
bool case_table_solve(const case_table *table, const char *const row[], size_t count,
                      results *answer, char complaint[COMPLAINT_SIZE]);

#endif
