/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_READING_H
#define CLI_READING_H

#include "model/results/results.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- column_name ---- The name of a column as people write it: with spaces, a unit, and letters
 * that look alike. */

enum { COLUMN_NAME_SIZE = 200 };

/* Copies a name with plain letters, digits and spaces for those that look the same: full-width
 * ones, subscripts, spaces that do not break or have no width. A longer name is cut. Returns the
 * length. */
size_t column_name_make_plain(const char *name, char plain[COLUMN_NAME_SIZE]);

/* How much of a plain name stands before its unit: "Q" of "Q [N/mm]", "Q / N", "Q in N", "Q_N". The
 * whole name where it has none. */
size_t column_name_stem(const char *plain);

/* Whether two names have the same letters and digits, whatever stands between them. The first has
 * `length` bytes. */
bool column_name_is_like(const char *a, size_t length, const char *b);

/* ---- header ---- The first row of a table: which of its columns are inputs. It is read from texts
 * alone, wherever they come from. */

/* A table with more columns is none that is meant. */
enum { HEADER_COLUMNS = 1000 };

typedef struct {
    const char *const *name; /* as they stand in the table; they must outlive this */
    size_t count;
    size_t column[INPUT_COUNT];      /* where each input is; count where it is not there */
    bool is_used[HEADER_COLUMNS];    /* inputs, and labels of the rows */
    bool has_number[HEADER_COLUMNS]; /* columns that are not used, in a row that was noted */
} header;

/* Finds the inputs from `first` on, before `end`, among the names; other names are columns like any
 * other. An input that the options give needs no column; the options may be NULL. False, with the
 * complaint,
 *   - where an input is there twice,
 *   - where a name is nearly that of an input, or is followed by a unit, as "Q [N]" or "Q in N",
 *   - where a name usually means an input that nothing gives. */
bool header_find(const char *const name[], size_t count, int first, int end,
                 const input_texts *options, header *names, complaint *why);

bool header_has_input(const header *names, int input);
bool header_is_input(const header *names, size_t column);
bool header_has(const header *names, const char *name);

/* The column of a name; the count where it is not there. False, with the complaint, where it is
 * there twice. */
bool header_column(const header *names, const char *name, size_t *column, complaint *why);

/* Whether a row has as many cells as the header; the complaint says so if not. */
bool header_fits(size_t columns, size_t cells, char separator, complaint *why);

/* Reads a number. False, with the complaint, where the cell has none. */
bool cell_read(const char *text, const char *column, char decimal_sign, double *value,
               complaint *why);

/* Notes the columns that nothing uses but that have a number in this row: one of them may be meant
 * for an input, and nobody would notice. */
void header_note_unused(header *names, const char *const cells[]);

/* Adds "columns with numbers that are not used: 'T'" to a list, where the rows that were noted have
 * any. */
void header_write_unused(const header *names, char *text, size_t size);

/* Why the names of a header may lack one: "; the columns seem to be separated by ';': ..." where
 * there is one only, or that they are numbers; or nothing. */
const char *header_hint(const char *const name[], size_t count);

/* Finds the columns of a load: P and Q, and M and sigma, which may lack. False, with the
 * complaint. */
bool load_header_find(const char *const name[], size_t count, header *names, complaint *why);

/* Reads a row of so many cells between separators. False, with the complaint, where it is no
 * load. */
bool load_row_read(const header *names, const char *const cells[], size_t count, char separator,
                   char decimal_sign, load *to, complaint *why);

/* ---- case_table ---- Many cases: the rows of a table, and what all of them have in common. */

typedef struct {
    header names;
    input_texts constants; /* for the columns that the table does not have */
    results_wanted wanted; /* the edges too where a column needs them */
    char separator;
    bool shown[RESULT_COUNT]; /* the results that become columns */
} case_table;

/* The column after the results, which says why a row has none. */
extern const char case_table_error[];

/* To be called before any row, when the other members are set: chooses the results that are shown.
 * False, with the complaint, where columns and constants cannot give a contact, or where a column
 * has the name of a result. */
bool case_table_begin(case_table *table, complaint *why);

/* Solves a row of `count` cells. False, with the complaint, where it has no results. Several
 * threads may call it at a time. */
bool case_table_solve(const case_table *table, const char *const row[], size_t count,
                      results *answer, complaint *why);

#endif
