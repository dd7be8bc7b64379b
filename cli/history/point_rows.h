/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stresses at points after each load, as rows. */
#ifndef CLI_POINT_ROWS_H
#define CLI_POINT_ROWS_H

#include "contact_history.h"
#include "places.h"

#include "model/tensor.h"
#include "rows/records.h"

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
tensor point_stress(const point_rows *points, const rwedge_contact *contact, size_t i);

/* Columns of a file of loads that are no loads: they go in front of the results. */
void passed_names(const load_history *loads, records *rows);
void passed_cells(const load_history *loads, size_t row, records *rows);

/* Refuses a column that has the name of a result. */
void passed_check(const load_history *loads, const char *const results[], size_t count);

#endif
