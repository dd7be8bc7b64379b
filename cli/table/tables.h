/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The five tables: what each depends on, its columns, and how a row is computed. */
#ifndef CLI_TABLES_H
#define CLI_TABLES_H

#include "rows/records.h"
#include "options/variable.h"

enum { AXES_MAX = 3, COLUMNS_MAX = 10, COLUMN_KINDS = 18 };

typedef struct {
    const char *name;
    const char *summary;
    int axis[AXES_MAX]; /* the variables, the slowest first */
    int axis_count;
    /* the variable that a grid has across, a/b being down; VARIABLE_COUNT where it has no grid */
    int across;
    const char *column[COLUMNS_MAX];
    int column_count;
    /* the column that a grid shows by default; the ones before it are the variables */
    int quantity;
    /* Fills a row from the values of the variables. RWEDGE_OK, or the library's status. */
    int32_t (*row)(const double value[VARIABLE_COUNT], cell row[COLUMNS_MAX]);
} table;

enum { TABLE_COUNT = 5 };
extern const table tables[TABLE_COUNT];

/* Of all tables. */
extern const column_kind table_columns[COLUMN_KINDS];

/* By its name; NULL where there is none. */
const table *table_named(const char *name);

bool table_depends_on(const table *which, int variable);

#endif
