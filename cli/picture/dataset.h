/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers behind a figure: rows in memory, in groups of one curve each. What is drawn and
 * what --data writes are the same rows. */
#ifndef CLI_DATASET_H
#define CLI_DATASET_H

#include "rows/records.h"

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
    data_row *row;
    size_t count;
} dataset;

void dataset_add(dataset *to, data_row row);

/* The rows of a curve: where they start, and how many. */
size_t dataset_curve(const dataset *data, int curve, size_t *first);
int dataset_curves(const dataset *data);

/* A rows_writer of output_options.h for a dataset. */
void dataset_write(void *of_dataset, records *rows);

#endif
