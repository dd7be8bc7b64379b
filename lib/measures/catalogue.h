/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The measures of a cycle: what each is called, which constants it has, how it is found. */
#ifndef RW_CATALOGUE_H
#define RW_CATALOGUE_H

#include "measures/stress_cycles.h"
#include "measures/planes.h"

/* A constant is a number from low to high; `usual` counts where a material does not give it, and is
 * NAN where it has to. */
typedef struct {
    const char *name, *text, *unit;
    double low, high, usual;
} rw_constant;

enum { RW_CONSTANTS = 9 }; /* the most that one measure has */

/* A criterion is of planes, or of another kind. A measure of friction is neither. */
typedef struct {
    const char *name, *title, *text, *unit, *limit;
    rw_plane_criterion *of_planes;
    rw_criterion_of_field *of_field;
    bool counts_mean;                           /* also where nothing cycles */
    int degree;                                 /* its power in the stresses; 0 for no single one */
    int own;                                    /* how many of the constants are the criterion's */
    const rw_constant *constants[RW_CONSTANTS]; /* behind them those of the curve of life */
} rw_measure;

/* NULL for a number that no measure has. */
const rw_measure *rw_measure_of(int32_t criterion);

/* How many constants there are: the criterion's own, and those of its curve of life. */
int rw_all_constants(const rw_measure *measure);

/* Whether the first of the constants are in their ranges. */
bool rw_are_constants(const rw_measure *measure, int count, const double constants[]);

#endif
