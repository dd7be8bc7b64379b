/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first row of a CSV file: which columns it has. */
#ifndef CLI_HEADER_H
#define CLI_HEADER_H

#include "input/csv_input.h"
#include "model/inputs.h"

typedef struct {
    char **name; /* as they stand in the file */
    size_t count;
    char separator;                  /* what stands between the cells */
    size_t column[INPUT_COUNT];      /* where each input is; count where it is not there */
    bool has_numbers[CSV_ROW_CELLS]; /* columns in whose rows a number has been seen */
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

/* Whether the column is an input. */
bool header_is_input(const header *names, size_t column);

/* Says which columns are no inputs but have numbers: one of them may be meant for an input, and
 * nobody would notice. Loads without a file have no columns: nothing is said. */
void header_name_unused(const header *names, const char *file);

bool header_has(const header *names, const char *name);

/* Whether a row of so many cells has as many as the header; the complaint says so if not. */
bool header_fits(const header *names, size_t cells, char complaint[COMPLAINT_SIZE]);

/* "; the header has a ';': ..." where the wrong separator explains that a column is missing; or
 * nothing. */
const char *header_separator_hint(const header *names);

#endif
