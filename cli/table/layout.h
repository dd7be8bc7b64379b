/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table as rows: long, a row for every combination of the variables; or as a grid, a/b down, a
 * second variable across. */
#ifndef CLI_LAYOUT_H
#define CLI_LAYOUT_H

#include "tables.h"

typedef struct {
    const table *table;
    range axis[VARIABLE_COUNT]; /* those that the table depends on */
    bool grid;
    int quantity; /* the column that a grid shows */
    int threads;
} plan;

/* How many values the table computes. */
int64_t plan_size(const plan *job);

/* Writes it, with progress. Ends the command where a value cannot be computed, or written as the
 * format needs it; the output holds what went wrong with writing. */
void plan_write(void *plan_to_write, records *rows);

#endif
