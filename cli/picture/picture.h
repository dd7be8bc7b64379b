/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_PICTURE_H
#define CLI_PICTURE_H

#include "rows/rows.h"
#include "text/text.h"

#include <stdbool.h>
#include <stdio.h>

/* ---- dataset ---- The numbers behind a figure: rows in memory, in groups of one curve each. What
 * is drawn and what --data writes are the same rows. */

enum { DATA_COLUMNS_MAX = 8 };

typedef struct {
    int curve;        /* which group it belongs to */
    const char *text; /* of the text column, where there is one; not copied */
    /* of the others, in their order; what is not finite is empty */
    double number[DATA_COLUMNS_MAX];
} data_row;

/* All zero is empty. */
typedef struct {
    const char *const *column; /* the names of the numbers; NULL after the last */
    const char *text_column;   /* the name of the text column, the last; NULL where there is none */
    size_t across;             /* of a grid: how many rows are side by side; 0 for curves */
    data_row *row;
    size_t count;
} dataset;

void dataset_add(dataset *to, data_row row);

/* The largest finite number of a column; at least 0. */
double dataset_largest(const dataset *data, int column);

/* Writes it as rows. */
void dataset_write(const dataset *data, records *rows);

/* ---- gnuplot ---- gnuplot draws the pictures. It is looked for on PATH when one is drawn; nothing
 * else needs it, and no other file runs it. What it draws is said in its own language. */

/* Has gnuplot draw a picture, as svg, png or pdf, into the output. What writes the script finds
 * `terminal` in it, a format of the paper's width and height, and `paper` and `line`: that width,
 * and the height of a line of text over it. */
typedef void script_writer(const void *context, const dataset *rows, FILE *script);
void gnuplot_draw(const char *format, script_writer *write, const void *context,
                  const dataset *rows, output *out);

/* The lines of a script that stands in a file; a line "frame" stands for the lines of `frame`. */
void script_lines(FILE *script, const char *const lines[], const char *const frame[]);

/* The name is a number from then on; or a text, in which *a* is italic and _c a subscript. */
void script_number(FILE *script, const char *name, double value);
void script_text(FILE *script, const char *name, const char *text);

/* The name is the rows from then on, all columns of them: an index for each curve, a blank line
 * after each row of a grid. */
void script_rows(FILE *script, const char *name, const dataset *rows);

#endif
