/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The variables that tables depend on: for each its option, its column, its domain and its range by
 * default. */
#ifndef CLI_VARIABLE_H
#define CLI_VARIABLE_H

#include "number/range.h"

enum { A_OVER_B, FRICTION, NU, Q_OVER_FP, VARIABLE_COUNT };

typedef struct {
    const char *option; /* without its dashes */
    const char *column;
    const char *name; /* as the subject of a sentence */
    double lo, hi;    /* the domain; hi is HUGE_VAL where there is no upper end */
    const char *domain;
    const char *usual; /* the range by default */
} table_variable;

extern const table_variable variables[VARIABLE_COUNT];

/* Reads an option's text, or the usual range where it is NULL. Free the range. */
void variable_read(const table_variable *variable, const char *text, range *values);

/* The same for one number. */
double variable_read_one(const table_variable *variable, const char *text);

#endif
