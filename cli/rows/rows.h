/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_ROWS_H
#define CLI_ROWS_H

#include "options/options.h"
#include "system/system.h"

/* ---- records ---- Rows of named cells. They are written cell by cell, so that neither long nor
 * wide tables take memory. The formats are delimited (CSV, TSV), json, spreadsheet (XLSX) and vtk,
 * which alone keeps the rows to the end. */

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

/* CSV and TSV; JSON; XLSX; VTK. Each is in the file of its name, XLSX in spreadsheet. */
extern const record_format delimited_format, json_format, xlsx_format, vtk_format;

/* How rows are written, and where: as the options of a command say. */
typedef struct {
    const char *format_name;
    const record_format *format; /* NULL for a command's own format */
    int digits;                  /* significant ones; NUMBER_DIGITS to read back the same */
    char decimal_sign, separator;
    const char *option, *path; /* the option that names it; NULL for standard output */
    bool quiet;
    bool no_formulas; /* CSV: a ' before texts that a spreadsheet would compute */
} output_options;

struct records {
    const output_options *how;
    output *out;
    bool mark; /* of Unicode, in front of a text file */
    bool show_progress, is_begun;
    const column_kind *kinds; /* for a format that has room to say it; NULL for none */
    int kind_count;
    bool row_begun, any_row;
    char **key; /* of json_format: the names, none of them twice */
    size_t key_count, next_key;
    const char *title; /* of vtk_format: of the file */
    size_t across;     /* rows that are side by side on a grid; 0 where they are on none */
    const char **name; /* of the columns; not copied */
    double *kept;      /* all numbers, row by row */
    size_t names, kept_count;
    struct xlsx *book;         /* of xlsx_format: a file that is written when it is whole */
    const char *const *sheets; /* the names of several, ending with NULL; NULL for one */
    int sheet, row, column, last_column, described;
    uint64_t described_kinds; /* a bit for each */
};

/* A format that writes nothing there has it. */
void records_nothing(records *rows);

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
void records_columns(records *rows, const column_kind kinds[], int count);

/* The columns with their meanings, for a help text; names in so many characters. */
void columns_describe(const column_kind kinds[], int count, int width, FILE *stream);

/* A row: cells one by one, and its end; or whole. What the format cannot hold ends the command. */
void records_value(records *rows, cell value);
void records_end_row(records *rows);
void records_row(records *rows, size_t count, const cell values[]);

/* Whether to go on writing: after a failure of the output no more rows are written. */
bool records_go_on(const records *rows);

/* Ends the file, if it has begun; output_finish() reports failures of the output. */
void records_end(records *rows);

/* ---- spreadsheet ---- XLSX. */

/* What follows, a header first, goes to the next of several sheets. */
void spreadsheet_next_sheet(records *rows);

/* ---- output_options ---- The options that every command with rows of results has: how they are
 * written, and where. */

/* Tables to include (POPT_ARG_INCLUDE_TABLE): of a command that writes rows; of one whose rows are
 * places, which VTK can have too. */
extern struct poptOption output_option_table[], grid_output_option_table[];
extern const char *const grid_formats[]; /* of the second */

/* The option of a command whose rows have texts of a file in them. */
#define NO_FORMULAS_OPTION                                                                         \
    "no-formulas", '\0', POPT_ARG_NONE, NULL, OPTION_NO_FORMULAS,                                  \
        "In csv and tsv a ' before texts that a spreadsheet would compute: = + - @", NULL

/* Reads the options; a mistake in them ends the command. */
void output_options_read(const arguments *line, output_options *how);

/* The same for a command with formats of its own. The list ends with NULL, its first is the
 * default; the hint follows where a message lists them. */
void output_options_read_of(const arguments *line, const char *const formats[], const char *hint,
                            output_options *how);

/* Which of these formats --format asks for, or the ending of the output's name. A contradiction of
 * the two, and an ending that says nothing, are refused. */
const char *output_format_choose(const arguments *line, const char *const formats[],
                                 const char *hint);

/* Refuses an output that is this file, NULL for none, which the message calls by two words; or one
 * of the files that the command line names, which output_options_read() does too. */
void output_options_spare(const output_options *how, const char *file, const char *kind,
                          const char *name);
void output_options_spare_files(const arguments *line, const output_options *how);

/* Writes rows. */
typedef void rows_writer(void *context, records *rows);

/* Opens the output, calls the writer of the rows, and finishes the output. */
void output_options_write(const output_options *how, rows_writer *write_rows, void *context);

#endif
