/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of named cells. They are written cell by cell, so that neither long nor wide tables take
 * memory. The formats are delimited (CSV, TSV), json and spreadsheet (XLSX). */
#ifndef CLI_RECORDS_H
#define CLI_RECORDS_H

#include "number/cell.h"
#include "number/number.h"
#include "system/output.h"

typedef struct records records;

/* What a format does. All cells of a row have been named in the header, in the same order. */
typedef struct {
    void (*begin)(records *rows);
    void (*name)(records *rows, const char *name); /* of a column, in the header */
    void (*end_header)(records *rows);
    void (*value)(records *rows, cell value);
    void (*end_row)(records *rows);
    void (*end)(records *rows);
} record_format;

/* CSV and TSV; JSON; XLSX. Each is in the file of its name, XLSX in spreadsheet. */
extern const record_format delimited_format, json_format, xlsx_format;

struct records {
    const record_format *format;
    output *out;
    int digits; /* significant ones; NUMBER_DIGITS to read back the same */
    char decimal_sign, separator;
    bool mark; /* of Unicode, in front of a text file */
    bool no_formulas, show_progress, is_begun;
    const column_kind *kinds; /* for a format that has room to say it; NULL for none */
    int kind_count;
    bool row_begun, any_row;
    char **key; /* of json_format: the names, none of them twice */
    size_t key_count, next_key;
    const char *problem;       /* what a format could not write */
    struct xlsx *book;         /* of xlsx_format: a file that is written when it is whole */
    const char *const *sheets; /* the names of several, ending with NULL; NULL for one */
    int sheet, row, column, last_column, described;
    uint64_t described_kinds; /* a bit for each */
};

/* To be called before the rows: meanings and units of columns by their names. */
static inline void records_describe(records *rows, const column_kind kinds[], int count)
{
    rows->kinds = kinds;
    rows->kind_count = count;
}

/* The header: names one by one, and its end; or whole. The first name begins the file. */
void records_name(records *rows, const char *name);
void records_end_header(records *rows);
void records_header(records *rows, size_t count, const char *const names[]);

/* A row: cells one by one, and its end; or whole. */
void records_value(records *rows, cell value);
void records_end_row(records *rows);
void records_row(records *rows, size_t count, const cell values[]);

/* Whether to go on writing: after a failure of the output no more rows are written. */
bool records_go_on(const records *rows);

/* Ends the file, if it has begun. Ends the command where a format could not write a text;
 * output_finish() reports failures of the output. */
void records_end(records *rows);

#endif
