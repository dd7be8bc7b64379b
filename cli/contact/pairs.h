/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A CSV file of which two columns are numbers: points, or a profile. */
#ifndef CLI_PAIRS_H
#define CLI_PAIRS_H

#include <stddef.h>
#include <stdint.h>

/* What the file must have. */
typedef struct {
    const char *first, *second, *instead; /* the last may be there for the second; or NULL */
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
    char unused[600];   /* columns with numbers that are not used */
    char problem[600];  /* why it cannot be read, with the name of the file; "" where it can */
} pairs;

/* Reads it all, but for what follows a problem. Free it. */
void pairs_read(const char *path, const char *encoding, char decimal_sign,
                const pair_columns *wanted, pairs *to);
void pairs_free(pairs *all);

#endif
