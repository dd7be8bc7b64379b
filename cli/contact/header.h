/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first row of a CSV file: which columns it has. */
#ifndef CLI_HEADER_H
#define CLI_HEADER_H

#include "rows/csv_input.h"
#include "inputs.h"

typedef struct {
    char **name; /* as they stand in the file */
    size_t count;
    size_t column[INPUT_COUNT]; /* where each input is; count where it is not there */
} header;

/* Reads the header row and finds the wanted inputs in it; other names are columns like any other.
 * An input that the options give needs no column; the options may be NULL. False, with the reason
 * said,
 *   - where there is no header row,
 *   - where an input is there twice,
 *   - where a name is nearly that of an input,
 *   - where a name usually means an input that nothing gives.
 * Free it in either case. */
bool header_read(csv_input *in, const bool wanted[INPUT_COUNT], const input_texts *options,
                 header *names);
void header_free(header *names);

bool header_has(const header *names, const char *name);

/* Whether the row has as many cells as the header; the complaint says so if not. */
bool header_fits(const header *names, const csv_input *row, char complaint[COMPLAINT_SIZE]);

/* "; the header has a ';': ..." where the wrong separator explains that a column is missing; or
 * nothing. */
const char *header_separator_hint(const header *names);

#endif
