/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values that an option takes: START:STOP:STEP, a comma list, or one number. A value is
 * computed from its index, so that a range of a thousand million values takes no more memory
 * than one of three. */
#ifndef CLI_RANGE_H
#define CLI_RANGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define RANGE_VALUES_MAX INT64_C(1000000000)

typedef struct {
    int64_t count;
    double *items; /* of a list; NULL for START:STOP:STEP */
    double first, last, step;
    double
        power; /* of ten: the values are whole numbers over it; 0 where they have too many digits */
    int64_t parts; /* of range_between; otherwise 0 */
} range;

/* Reads text; returns NULL, or what is wrong with it as the end of a sentence that names the
 * option and the text. Numbers are 0, or 1e-60 to 1e60 in magnitude. */
const char *range_read(const char *text, range *values);

/* Says on stderr how a list was understood that may have been meant as one number, such as 0,5: two
 * whole numbers, of which the first is 0 or the second begins with 0. */
void range_say_two_values(const char *option, const char *text);

/* The same of a pair that is a part of an option's value. Whether it was said. */
bool range_say_pair(const char *option, const char *all, const char *text, size_t length);

/* `count` values, at least 2, in equal steps. Between -x and x they are exact mirror images; 0 is
 * among them if their number is odd. */
range range_between(double first, double last, int64_t count);

/* The value of index i, 0 <= i < count. */
double range_value(const range *values, int64_t i);

/* Whether lo <= value <= hi for every value; otherwise *outside is one that is not. */
bool range_within(const range *values, double lo, double hi, double *outside);

void range_free(range *values);

#endif
