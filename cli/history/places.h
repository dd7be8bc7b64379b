/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points of body 1 that are looked at: a list, a file of them, or a grid. */
#ifndef CLI_PLACES_H
#define CLI_PLACES_H

#include "contact_history.h"
#include "rows/output_options.h"
#include "number/range.h"

enum {
    OPTION_AT = OPTION_AFTER_HISTORY,
    OPTION_POINTS,
    OPTION_X,
    OPTION_DEPTH,
    OPTION_AFTER_PLACES
};

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE. */
extern struct poptOption place_option_table[];

typedef struct {
    double *x, *y;
    size_t count; /* 0 where no option gives any */
    /* of a grid, whose points are row by row, x fastest; 0 and 0 for other places */
    size_t columns, rows;
} places;

/* Reads --at or --points; or --x with --depth, which is 0 by default. Free them. */
void places_read(const arguments *line, char decimal_sign, places *to);
void places_free(places *at);

/* Refuses an output that is the file of loads or of points. */
void places_spare_files(const arguments *line, const output_options *how);

/* Reads --depth alone: 0 by default. Free the range. */
void places_read_depth(const arguments *line, range *depth);

#endif
