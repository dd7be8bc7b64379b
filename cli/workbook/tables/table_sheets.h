/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sheets of tables. */
#ifndef CLI_TABLE_SHEETS_H
#define CLI_TABLE_SHEETS_H

#include "sheet/xlsx.h"

/* Ranges that the charts draw. */
#define TENSION_TIPS "='Maximum tension'!$A$5:$A$105"
#define TENSION_VALUES "='Maximum tension'!$B$5:$B$105"

enum { BRANCH_TIPS = 29 };

/* Each fills the sheet that has been turned to. */
void sheet_elastic_limit(xlsx *book);
void sheet_max_tension(xlsx *book);
void sheet_contact_law(xlsx *book);
void sheet_critical_friction(xlsx *book);

#endif
