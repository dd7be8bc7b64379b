/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first row of a table: which of its columns are inputs. It is read from texts alone, wherever
 * they come from. */
#ifndef CLI_HEADER_H
#define CLI_HEADER_H

#include "model/inputs.h"

#include <stddef.h>

/* A table with more columns is none that is meant. */
enum { HEADER_COLUMNS = 1000 };

typedef struct {
    const char *const *name; /* as they stand in the table; they must outlive this */
    size_t count;
    size_t column[INPUT_COUNT];   /* where each input is; count where it is not there */
    bool is_used[HEADER_COLUMNS]; /* inputs, and labels of the rows */
} header;

/* Finds the wanted inputs among the names; other names are columns like any other. An input that
 * the options give needs no column; the options may be NULL. False, with the complaint,
 *   - where an input is there twice,
 *   - where a name is nearly that of an input, or is followed by a unit, as "Q [N]" or "Q in N",
 *   - where a name usually means an input that nothing gives. */
bool header_find(const char *const name[], size_t count, const bool wanted[INPUT_COUNT],
                 const input_texts *options, header *names, char complaint[COMPLAINT_SIZE]);

bool header_has_input(const header *names, int input);
bool header_is_input(const header *names, size_t column);
bool header_has(const header *names, const char *name);

/* Whether a row has as many cells as the header; the complaint says so if not. */
bool header_fits(size_t columns, size_t cells, char separator, char complaint[COMPLAINT_SIZE]);

/* Notes the columns that nothing uses but that have a number in this row: one of them may be meant
 * for an input, and nobody would notice. */
void header_note_unused(const header *names, const char *const cell[], bool unused[HEADER_COLUMNS]);

/* Adds "columns with numbers that are not used: 'T'" to a list, where there are any. */
void header_write_unused(const header *names, const bool unused[HEADER_COLUMNS], char *text,
                         size_t size);

/* "; the columns seem to be separated by ';': ..." of the names of a header where the wrong
 * separator may be why it has one only; or nothing. */
const char *header_separator_hint(const char *const name[], size_t count);

#endif
