/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of a flat pad with rounded edges: a is half the width of the flat. */
#ifndef CLI_FLAT_PAD_H
#define CLI_FLAT_PAD_H

#include "options/variable.h"
#include "number/cell.h"

#include <stdint.h>

/* In place of a/b of a wedge. */
extern const table_variable flat_over_b;

/* Rows, as those of tables. */
int32_t flat_elastic_limit(const double value[], cell row[]);
int32_t flat_contact_law(const double value[], cell row[]);

#endif
