/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_INPUT_H
#define CLI_INPUT_H

#include "model/reading/reading.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- text_input ---- A file of text, read as UTF-8 whatever its encoding. What is no text is
 * refused here, so that every format can write what was read. */

typedef struct {
    const char *name;  /* as messages call it */
    bool has_mark;     /* it begins with the mark of Unicode; known once it has been read from */
    complaint problem; /* why it cannot be opened, or read on; "" as long as it can */
} text_input;

/* Refuses an encoding that iconv does not know, by the name of --encoding. */
void text_input_check(const char *encoding);

/* Opens a file, or standard input where path is "-". The encoding is one that iconv knows; NULL is
 * UTF-8, or UTF-16 where the file begins with its mark. */
text_input *text_input_open(const char *path, const char *encoding);

/* Reads whole characters, at most `size` bytes, 4 or more; *count is 0 at the end. False, with the
 * problem, where it cannot be read, or has what is no text: the problem names the file, the line
 * and the column, which is the number of the character in the line. */
bool text_input_read(text_input *in, char *bytes, size_t size, size_t *count);

void text_input_close(text_input *in);

/* ---- csv_input ---- Rows of a CSV file (RFC 4180), one at a time: memory holds one row, however
 * many there are. */

/* A separator: runs of blanks and tabs. */
enum { CSV_BLANKS = ' ' };

/* A longer row, or one with more cells, does not belong to a table for this tool. */
enum { CSV_ROW_BYTES = 1 << 20, CSV_ROW_CELLS = 1000 };

typedef struct {
    bool malformed; /* quotes are misplaced: the cells before that */
    int64_t line;   /* of the file, on which it starts, from 1 */
    size_t count;
    const char **cell;
    const char *whole; /* as it stands in the file, quotes and all */
    size_t bytes;      /* that one takes which is kept */
} csv_row;

typedef struct {
    const char *name;     /* of the file, in messages */
    char separator;       /* of the cells: a comma, a semicolon, a tab, or what the file names */
    bool has_mark;        /* whether it begins with the mark of Unicode */
    bool takes_malformed; /* rows; the next line starts afresh. Otherwise one is a problem */
    csv_row row;          /* that was read last; its texts live until the next is read */
    complaint problem;    /* why it cannot be read on, with the name and the line; or "" */
} csv_input;

/* Opens a file, or standard input where path is "-". Tabs separate where the name ends in .tsv, or
 * where the first line has tabs but no separator; another separator where the first line names it,
 * as "sep=;". The encoding is that of text_input. Where it cannot be opened there is a problem, and
 * no next row. */
csv_input *csv_input_open(const char *path, char separator, const char *encoding);

/* Reads the next row. False at the end, or where there is a problem. Blank lines, and rows of empty
 * cells, are no rows. A quote that is not closed ends the file: what it has taken may have been
 * rows. */
bool csv_input_next(csv_input *in);

/* Reads the rows at the beginning of the file, as far as they are at hand, as often as it is
 * called,
 * each time as if that were the separator, unless the file names one. False where there are none.
 * */
bool csv_input_scan(csv_input *in, char separator);

/* Begins in earnest, after scans. */
void csv_input_begin(csv_input *in, char separator);

/* Whether the file names its separator; the one that its first line has, the usual one or tabs. */
bool csv_input_names_separator(const csv_input *in);
char csv_input_guess(const csv_input *in, char usual);

/* Reads the first row, which is kept. False where there is a problem. */
bool csv_input_header(csv_input *in, csv_row *row);

/* Ends the file with a problem, made as by printf, after its name. False. */
bool csv_input_stop(csv_input *in, const char *format, ...) PRINTF_LIKE(2, 3);

/* Ends the command where there is a problem. */
void csv_input_check(const csv_input *in);

/* The option that names the encoding, for a command's own table. It is checked by
 * text_input_check(). */
#define ENCODING_OPTION                                                                            \
    "encoding", '\0', POPT_ARG_STRING, NULL, OPTION_ENCODING,                                      \
        "Encoding of the file that is read, such as windows-1252 (default utf-8)", "NAME"

void csv_input_close(csv_input *in);

/* Copies the row that was read last: it stays while others are read. Free it. */
void csv_row_keep(const csv_input *in, csv_row *row);
void csv_row_free(csv_row *row);

/* What is wrong with a row, for a column "error" beside its cells: with the whole row where the
 * columns of its table cannot show it. Free it. */
char *csv_row_fault(const csv_row *row, size_t columns, const char *why);

/* ---- table_input ---- A table in a file: what stands above it is passed over, its header is
 * found,
 * and its units; the rows below it, without comments, which begin with #. Memory holds a row. */

/* How files are to be read. */
typedef struct {
    char decimal_sign;
    const char *encoding;        /* NULL: UTF-8 */
    const char *columns;         /* as in naming */
    const unit_system *units;    /* NULL */
    bool drops;                  /* rows that lack a number, in place of refusing them */
    bool is_driven, is_measured; /* as in naming */
    bool is_command;
} reading;

/* What a table must have. */
typedef struct {
    /* Finds the columns among the names of a header that has been begun. False, with the
     * complaint. */
    bool (*find)(void *context, header *names, complaint *why);
    void *context;
    /* the names of so many columns where the file has none; NULL refuses that */
    const char *const *(*usual)(size_t count);
    bool takes_malformed; /* rows, as csv_input has it */
    bool counts_missing;  /* rows that lack a number are counted, and refused or left out */
} table_wanted;

typedef struct {
    csv_input *in;
    csv_row first, units; /* that have the names, and units below them */
    naming how;
    header names;
    table_wanted wanted;
    char decimal_sign;
    int64_t first_line; /* that is not blank */
    bool is_pending;    /* the row at hand is the next one */
    bool drops;
    size_t missing; /* rows that lack a number */
    complaint first_missing;
    complaint remark; /* what was passed over; known at the end */
} table_input;

/* Opens a file, or standard input where path is "-", and reads its header. False where there is a
 * problem, that of `in`. Close it in either case. It must not move. */
bool table_open(const char *path, const reading *how, const table_wanted *wanted, table_input *t);

/* Reads the next row, that of `in`. False at the end, or where there is a problem. */
bool table_next(table_input *t);

void table_close(table_input *t);

/* ---- pairs ---- A CSV file of which two columns are numbers: points, or a profile. */

/* What the file must have. */
typedef struct {
    const char *first, *second, *instead; /* the last may be there for the second; or NULL */
    const char *dimension, *other;        /* of the second; of what is there instead */
    /* the names of two columns in a file that has none; NULL refuses it */
    const char *const *(*usual)(size_t count);
    const char *needed, *rows; /* "x and y, the depth"; "points" */
    size_t most;
    /* what is wrong with such numbers, or NULL */
    const char *(*complaint_about)(double first, double second);
} pair_columns;

typedef struct {
    size_t count;
    double *first, *second;
    int64_t *line;      /* on which each stands */
    const char *column; /* what the second is */
    complaint remark;   /* what was passed over, and columns with numbers that are not used */
    complaint problem;  /* why it cannot be read, with the name of the file; "" where it can */
} pairs;

/* Reads it all, but for what follows a problem. Free it. */
void pairs_read(const char *path, const reading *how, const pair_columns *wanted, pairs *to);
void pairs_free(pairs *all);

/* ---- profiles ---- The profiles of pads, each from a file of its name. */

/* Reads a file, unless it has been read, and gives what is to be known of it: columns that are not
 * used, the hull; or "". What is wrong with it is kept too. Not while threads look for profiles. */
const char *profiles_read(const char *name, const reading *how, const profile_making *making);

/* Places that stand for a file of that name, which is read then; they are freed with it. */
void profiles_offer(const char *name, pairs places);

/* The places of a file that were kept; NULL for none. */
const pairs *profiles_places(const char *name);

/* The profile of a file that has been read for input_texts. */
const pad_profile *profiles_named(const char *name, complaint *why);

/* Forgets those that were read since so many had been. */
size_t profiles_count(void);
void profiles_forget(size_t count);

#endif
