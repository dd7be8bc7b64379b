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

/* The unit behind a plain name, "" for none, as "N/mm" of "P [N/mm]", "Load(8801:Load) (N/mm)", "P
 * in N/mm"; it need not be one that is known. Returns how much of the name stands before it. */
size_t column_name_unit(const char *plain, char own[COLUMN_NAME_SIZE]);

/* Whether two names have the same letters and digits, whatever stands between them. The first has
 * `length` bytes. */
bool column_name_is_like(const char *a, size_t length, const char *b);

/* ---- header ---- The row of names of a table: which of its columns are inputs. It is read from
 * texts alone, wherever they come from. */

/* A table with more columns is none that is meant. */
enum { HEADER_COLUMNS = 1000 };

/* How the columns of a table are to be understood. */
typedef struct {
    const char *columns;         /* "P=Normal Force", a line each; NULL */
    const unit_system *units;    /* NULL where no unit is known */
    const char *const *unit_row; /* the units below the names; NULL */
    bool is_command;             /* messages may name options */
    bool takes_any_unit;         /* units are not looked at yet */
    bool is_driven;              /* loads have a displacement in place of Q */
    bool is_measured;            /* they have both */
} naming;

typedef struct {
    const char *const *name; /* as they stand in the table; they must outlive this */
    size_t count;
    const naming *how;
    size_t column[INPUT_COUNT];           /* where each input is; count where it is not there */
    size_t displacement;                  /* where that of driven loads is, likewise */
    double factor[HEADER_COLUMNS];        /* of what is needed: to the working units */
    unsigned char needed[HEADER_COLUMNS]; /* whether numbers must stand there: a column_need */
    bool is_used[HEADER_COLUMNS];         /* inputs, and labels of the rows */
    bool has_number[HEADER_COLUMNS];      /* columns that are not used, in a row that was noted */
} header;

/* A place has no mark for a missing value: -9999 is a number there. */
typedef enum { NEED_NOTHING, NEED_NUMBER, NEED_PLACE } column_need;

/* Begins with names alone, none of which is looked for yet. */
void header_begin(const char *const name[], size_t count, const naming *how, header *names);

bool header_has_input(const header *names, int input);
bool header_is_input(const header *names, size_t column);
bool header_has(const header *names, const char *name);

/* The cell of a column as it is in the file: a number if the column is read as numbers, or if it
 * would be written as it stands. Columns that are not read may have names that look like
 * numbers. */
cell header_cell_written(const header *names, size_t column, const char *text, char decimal_sign);

/* The column of a name, or of the name that stands for it; the count where it is not there. False,
 * with the complaint, where it is there twice, or a name that was given for it is not there. */
bool header_column(const header *names, const char *name, size_t *column, complaint *why);

/* Takes the column of a name as needed, with numbers of that dimension. False, with the complaint,
 * where its unit cannot be taken. */
bool header_need(header *names, size_t column, const char *name, const char *dimension,
                 unit_share of, column_need need, complaint *why);

/* Whether a name was given to stand for that of an input. */
bool header_is_given_name(const header *names, const char *name);

/* "; the names there: 'Time', 'Load'; --column NAME='THEIR NAME' takes one", to be added where a
 * name was not found. */
void header_write_names(const header *names, complaint *why);

/* Why the names of a header may lack one: "; the columns seem to be separated by ';': ..." where
 * there is one only, or that they are numbers; or nothing. */
const char *header_hint(const char *const name[], size_t count);

/* ---- header_inputs ---- Which columns are inputs, and which are nearly so. */

/* Finds the inputs from `first` on, before `end`, among the names; other names are columns like any
 * other. An input that the options give needs no column; the options may be NULL. False, with the
 * complaint,
 *   - where an input is there twice, or has a unit that cannot be taken,
 *   - where a name is nearly that of an input, or is followed by a unit, as "Q [N]" or "Q in N",
 *     and no working units are known,
 *   - where a name usually means an input that nothing gives. */
bool header_find(int first, int end, const input_texts *options, header *names, complaint *why);

/* The inputs of a row: constants, and else the texts of its cells, NULL where an input has no
 * column. A cell takes the place of the number that a material has. */
input_texts header_texts(const header *names, const input_texts *constants,
                         const char *const text[INPUT_COUNT]);

/* Whether E1 and nu1 of a row are those that a material of all rows has, where it has them. */
bool header_texts_agree(const input_texts *texts, const input_texts *constants, complaint *why);

/* What columns are called that say which row it is. bindings/interface/write_python.py reads this
 * line: Python's package warns by the same list. */
#define LABEL_NAMES                                                                                \
    "case id key line load name no nr number row step time cycle point label node test zeit n_f"

/* Marks the columns that say which row it is, such as a time, as used. */
void header_note_labels(header *names);

/* ---- header_rows ---- The rows below a header. */

/* Whether a row has as many cells as the header; the complaint says so if not. */
bool header_fits(size_t columns, size_t cells, char separator, complaint *why);

/* Reads the number of a cell in the working units. False, with the complaint, where it has none. */
bool header_cell(const header *names, const char *const cells[], size_t column,
                 const char *column_name, char decimal_sign, double *value, complaint *why);

/* Whether all columns that are needed, and at least one, have numbers in a row. */
bool header_has_numbers(const header *names, const char *const cells[], size_t count,
                        char decimal_sign);

/* The first needed column whose cell is empty, or marks a missing value: NaN, -9999; the count
 * where there is none. */
size_t header_missing(const header *names, const char *const cells[], char decimal_sign);

/* Notes the columns that nothing uses but that have a number in this row: one of them may be meant
 * for an input, and nobody would notice. */
void header_note_unused(header *names, const char *const cells[]);

/* Adds "columns with numbers that are not used: 'T'" to a list, where the rows that were noted have
 * any. */
void header_write_unused(const header *names, char *text, size_t size);

/* What the column of driven loads is called. */
extern const char displacement_column[];

/* Finds the columns of a load: P and Q, or the displacement of one that is driven; sigma, and M or
 * tilt, which may lack. False, with the complaint. */
bool load_header_find(header *names, complaint *why);

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
