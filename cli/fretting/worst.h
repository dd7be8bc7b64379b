/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where each column of "rwedge fretting" is worst, also between the places: a line, or a table. */
#ifndef CLI_WORST_H
#define CLI_WORST_H

#include "rows/records.h"
#include "surface.h"

/* The theory of critical distances: the stresses below a place of the surface, at half of a length,
 * or their means over twice the length. */
typedef struct {
    double length, angle; /* NAN for none; from the surface's normal towards +x, deg */
    bool is_line;         /* mean over twice the length; else the point at half of it */
} distance;

/* The value is NAN where the column is nowhere above 0; cycles but for damage. */
typedef struct {
    double x, y, value, cycles;
} worst_row;

typedef struct {
    const last_cycle *last;
    distance below;  /* where criteria count, beside the surface */
    bool is_verdict; /* criteria alone are written; those of --criteria where it is given */
    worst_row row[COLUMN_COUNT];
} worst_table;

void worst_find(const measured *all, worst_table *worst);

/* Those between the places become places too. */
void worst_add_places(const worst_table *worst, measured *all);

/* "swt 1.2 at x = -0.3; swt_damage 0.01 at x = -0.3 (2 cycles)"; "" where
 * there is none. Depths where they matter. */
void worst_write(const worst_table *worst, bool is_deep, char *text, size_t size);

/* A row for each: a rows_writer of a worst_table. The life is "inf" for a run-out. */
void worst_write_rows(void *of_worst, records *rows);

#endif
