/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_NUMBER_H
#define CLI_NUMBER_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- number ---- Numbers as text, the same in every locale: the tool never calls setlocale(), so
 * the decimal sign is a point unless asked otherwise. */

/* Reads a whole text as a number, correctly rounded; -0 becomes 0. Spaces, "inf", "nan" and
 * hexadecimal numbers, which strtod() accepts, are none here. */
bool number_read(const char *text, double *value);

/* The same with blanks around it, and with that decimal sign: the text of a cell. */
bool number_read_cell(const char *text, char decimal_sign, double *value);

/* Whether a cell is a number that is written as it stands: "007", "0.10", "1E5", "+49" and twenty
 * digits are meant as texts. */
bool number_survives(const char *text, char decimal_sign, double *value);

/* Reads numbers between separators, all of the first `length` characters. How many there are; 0
 * where it is not that, or more than `most`. */
int number_read_list(const char *text, size_t length, char separator, int most, double value[]);

/* Reads a whole number without a sign, lo to hi, which are below 2^53. */
bool number_read_whole(const char *text, int64_t lo, int64_t hi, int64_t *value);

/* Whether a number is in the library's domain of all that has a size. */
static inline bool number_is_size(double value)
{
    return value == 0 || (fabs(value) >= 1e-60 && fabs(value) <= 1e60);
}

enum { NUMBER_SIZE = 32, NUMBER_DIGITS = 17 };

/* Writes a finite number with so many significant digits, 1 to 17. 17 promises that it reads
 * back to the same bits, and takes the shortest of 15, 16 and 17 digits that does. Returns the
 * length. */
size_t number_write(double value, int digits, char decimal_sign, char text[NUMBER_SIZE]);

/* The number with so many digits; one that is not finite stays as it is. */
double number_rounded(double value, int digits);

/* ---- cell ---- A cell of a table, and what its column holds. */

/* A number as it was typed, with its text, which CSV gives back, other formats the number; or a
 * text, whose number is NAN; or a number, whose text is NULL. A number without a text that is not
 * finite is an empty cell, as is the text "". */
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

/* What a column holds, and in which unit. */
typedef struct {
    const char *name, *meaning, *unit;
} column_kind;

/* ---- range ---- */

/* The values that an option takes: START:STOP:STEP, a comma list, or one number. A value is
 * computed from its index, so that a range of a thousand million values takes no more memory than
 * one of three. */
#define RANGE_VALUES_MAX INT64_C(1000000000)

typedef struct {
    int64_t count;
    double *items; /* of a list, and of range_between(); NULL for START:STOP:STEP */
    double first, last, step;
    double
        power; /* of ten: the values are whole numbers over it; 0 where they have too many digits */
} range;

/* Reads text; returns NULL, or what is wrong with it as the end of a sentence that names the
 * option and the text. Numbers are 0, or 1e-60 to 1e60 in magnitude. */
const char *range_read(const char *text, range *values);

/* Says on stderr how a list was understood that may have been meant as one number, such as 0,5: two
 * whole numbers, of which the first is 0 or the second begins with 0. It is all of an option's
 * value, or a part. Whether it was said. */
bool range_say_pair(const char *option, const char *all, const char *text, size_t length);

/* `count` values, at least 2, in equal steps. Between -x and x they are exact mirror images; 0 is
 * among them if their number is odd. */
range range_between(double first, double last, int64_t count);

/* The value of index i, 0 <= i < count. */
double range_value(const range *values, int64_t i);

/* How many combinations of their values there are; INT64_MAX where that fits no integer. */
int64_t range_product(int count, const range values[]);

/* Whether lo <= value <= hi for every value; otherwise *outside is one that is not. */
bool range_within(const range *values, double lo, double hi, double *outside);

void range_free(range *values);

#endif
