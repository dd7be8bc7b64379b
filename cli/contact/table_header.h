/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The header of a table that a file has. */
#ifndef CLI_TABLE_HEADER_H
#define CLI_TABLE_HEADER_H

#include "model/reading/header.h"
#include "input/csv_row.h"

/* Reads the first row, which is kept. Ends the command where there is none. */
void table_header_read(csv_input *in, csv_row *row);

/* Says which columns have numbers that nothing uses. */
void table_header_say_unused(const header *names, const bool unused[HEADER_COLUMNS],
                             const char *file);

#endif
