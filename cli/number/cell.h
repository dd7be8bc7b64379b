/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A cell of a table, and what its column holds. */
#ifndef CLI_CELL_H
#define CLI_CELL_H

#include <math.h>
#include <stddef.h>

/* A number as it was typed, with its text; or a text, whose number is NAN; or a number, whose text
 * is NULL. A number without a text that is not finite is an empty cell. */
typedef struct {
    const char *text;
    double number;
} cell;

static inline cell cell_number(double number)
{
    return (cell){NULL, number};
}

static inline cell cell_text(const char *text)
{
    return (cell){text, NAN};
}

/* CSV gives the text back, other formats the number. */
static inline cell cell_typed(const char *text, double number)
{
    return (cell){text, number};
}

static inline cell cell_empty(void)
{
    return cell_text("");
}

/* What a column holds, and in which unit. */
typedef struct {
    const char *name, *meaning, *unit;
} column_kind;

#endif
