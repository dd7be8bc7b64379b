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

/* ---- pairs ---- A CSV file of which two columns are numbers: points, or a profile. */

/* What the file must have. */
typedef struct {
    const char *first, *second, *instead; /* the last may be there for the second; or NULL */
    const char *const *usual;             /* two names for a file that has none; NULL refuses it */
    const char *needed, *rows;            /* "x and y, the depth"; "points" */
    size_t most;
    /* what is wrong with such numbers, or NULL */
    const char *(*complaint_about)(double first, double second);
} pair_columns;

typedef struct {
    size_t count;
    double *first, *second;
    int64_t *line;      /* on which each stands */
    const char *column; /* what the second is */
    complaint unused;   /* columns with numbers that are not used */
    complaint problem;  /* why it cannot be read, with the name of the file; "" where it can */
} pairs;

/* Reads it all, but for what follows a problem. Free it. */
void pairs_read(const char *path, const char *encoding, char decimal_sign,
                const pair_columns *wanted, pairs *to);
void pairs_free(pairs *all);

/* ---- profiles ---- The profiles of pads, each from a file of its name. */

/* Reads a file, unless it has been read, and gives what is to be known of it: columns that are not
 * used, the hull; or "". What is wrong with it is kept too. Not while threads look for profiles.
 * Columns without names are x and height where that is taken. */
const char *profiles_read(const char *name, char decimal_sign, bool takes_hull, bool takes_unnamed);

/* Those that have been read: of input_texts. */
const pad_profile *profiles_named(const char *name, complaint *why);

/* Forgets those that were read since so many had been. */
size_t profiles_count(void);
void profiles_forget(size_t count);

#endif
