/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_TABLE_H
#define CLI_TABLE_H

#include "rows/rows.h"

#include <stdint.h>

/* ---- tables ---- The tables: what each depends on, its columns, and how a row is computed. */

enum { COLUMNS_MAX = 10, COLUMN_KINDS = 24 };

typedef struct {
    const char *name;
    const char *summary;
    bool has[VARIABLE_COUNT]; /* the variables that it depends on, a/b among them */
    /* the variable that a grid has across, a/b being down; VARIABLE_COUNT where it has no grid */
    int across;
    /* the columns behind those of the variables; NULL after the last */
    const char *quantity[COLUMNS_MAX];
    /* Fills the quantities from the values of the variables. RWEDGE_OK, or the library's status. */
    int32_t (*row)(const double value[VARIABLE_COUNT], cell row[COLUMNS_MAX]);
    const table_variable *ratio; /* a/b of another pad than the wedge; NULL */
    const char *allowed;         /* of the variables, where the library refuses some; NULL */
} table;

/* The tables of the wedge, then those of a flat pad, and those of unlike bodies. */
enum { WEDGE_TABLES = 6, TABLE_COUNT = 11 };
extern const table tables[TABLE_COUNT];

/* The columns of all tables. */
extern const column_kind table_columns[COLUMN_KINDS];

/* The table of a name, of the wedge or of a flat pad, of similar or of unlike bodies; NULL where
 * there is none. */
const table *table_named(const char *name, bool is_flat, bool is_unlike);

/* One of its variables. */
const table_variable *table_variable_of(const table *chosen, int variable);

/* The a/b of a flat pad, in place of a wedge's: a is half the width of the flat. */
extern const table_variable flat_over_b;

#endif
