/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheets of tables. */
#ifndef CLI_TABLE_SHEETS_H
#define CLI_TABLE_SHEETS_H

#include "model.h"

#include "sheet/xlsx.h"

/* Names of the tables that the calculator's formulas use; the rest of the names are defined
 * where they are written. */
#define NAME_SURFACE "rwt_surface"
#define NAME_BELOW "rwt_below"

/* Ranges that the charts draw. */
#define TENSION_TIPS "='Maximum tension'!$A$5:$A$105"
#define TENSION_VALUES "='Maximum tension'!$B$5:$B$105"

/* Each fills the sheet that has been turned to. False where the library could not compute a
 * value. */
bool sheet_elastic_limit(xlsx *book, const limit_table *table);
void sheet_max_tension(xlsx *book);
void sheet_contact_law(xlsx *book);
bool sheet_critical_friction(xlsx *book);

#endif
