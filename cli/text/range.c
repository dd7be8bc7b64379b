/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "range.h"

#include "decimal.h"
#include "number.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char not_a_range[] = "must be a number, a comma list of numbers, or START:STOP:STEP";
static const char zero_step[] = "the STEP of START:STOP:STEP must not be 0";
static const char wrong_sign[] = "the STEP of START:STOP:STEP must lead from START towards STOP";
static const char too_many[] = "must not have more than 1000000000 values";
static const char no_memory[] = "out of memory";

/* The three numbers of START:STOP:STEP, as doubles and, where exact is true, as decimals. */
typedef struct {
    double value[3];
    decimal exact[3];
    bool all_exact;
} triple;

enum { START, STOP, STEP };

static bool read_triple(const char *text, triple *numbers)
{
    numbers->all_exact = true;
    for (int i = 0; i < 3; i++) {
        const size_t length = number_length(text);
        if (!number_read_part(text, length, &numbers->value[i]) ||
            text[length] != (i < 2 ? ':' : '\0'))
            return false;
        if (!decimal_read(text, length, &numbers->exact[i]))
            numbers->all_exact = false;
        text += length + 1;
    }
    return true;
}

static bool in_common_places(triple *numbers)
{
    if (!numbers->all_exact)
        return false;
    int places = 0;
    for (int i = 0; i < 3; i++)
        if (numbers->exact[i].places > places)
            places = numbers->exact[i].places;
    if (places > DECIMAL_PLACES_MAX)
        return false;
    for (int i = 0; i < 3; i++)
        if (!decimal_rescale(&numbers->exact[i], places))
            return false;
    return numbers->exact[STEP].units != 0;
}

static const char *exact_range(const triple *numbers, range *values)
{
    const int64_t start = numbers->exact[START].units, step = numbers->exact[STEP].units;
    const int64_t steps = (numbers->exact[STOP].units - start) / step;
    if (steps >= RANGE_VALUES_MAX)
        return too_many;
    values->first_units = start;
    values->step_units = step;
    values->power = decimal_power(numbers->exact[STEP].places);
    values->count = steps + 1;
    return NULL;
}

/* In doubles STOP counts as hit where start + steps * step differs from it by no more than their
 * rounding. */
static const char *rounded_range(const triple *numbers, range *values)
{
    const double start = numbers->value[START], stop = numbers->value[STOP],
                 step = numbers->value[STEP];
    const double steps = (stop - start) / step, nearest = floor(steps + 0.5);
    const double rounding = 4 * DBL_EPSILON * (fabs(start) + fabs(stop));
    const bool hit = fabs(start + nearest * step - stop) <= rounding;
    const double last = hit ? nearest : floor(steps);
    if (!(last < (double)RANGE_VALUES_MAX))
        return too_many;
    values->count = (int64_t)last + 1;
    values->first = start;
    values->step = step;
    values->last = hit && last > 0 ? stop : start + (double)(values->count - 1) * step;
    return NULL;
}

static const char *read_steps(const char *text, range *values)
{
    triple numbers;
    if (!read_triple(text, &numbers))
        return not_a_range;
    const double step = numbers.value[STEP], way = numbers.value[STOP] - numbers.value[START];
    if (step == 0)
        return zero_step;
    if ((way > 0 && step < 0) || (way < 0 && step > 0))
        return wrong_sign;
    return in_common_places(&numbers) ? exact_range(&numbers, values)
                                      : rounded_range(&numbers, values);
}

static const char *read_list(const char *text, range *values)
{
    size_t commas = 0;
    for (const char *c = text; *c != '\0'; c++)
        commas += *c == ',' ? 1 : 0;
    values->items = malloc((commas + 1) * sizeof *values->items);
    if (values->items == NULL)
        return no_memory;
    for (;; text++) {
        const size_t length = number_length(text);
        if (!number_read_part(text, length, &values->items[values->count]))
            return not_a_range;
        values->count++;
        text += length;
        if (*text == '\0')
            return NULL;
        if (*text != ',')
            return not_a_range;
    }
}

const char *range_read(const char *text, range *values)
{
    *values = (range){0};
    const char *complaint =
        strchr(text, ':') != NULL ? read_steps(text, values) : read_list(text, values);
    if (complaint != NULL)
        range_free(values);
    return complaint;
}

range range_between(double first, double last, int64_t count)
{
    return (range){.count = count, .first = first, .last = last, .parts = count - 1};
}

/* Counted from the middle where that is 0: first + i * step would miss it by its rounding. */
static double value_between(const range *values, int64_t i)
{
    const double parts = (double)values->parts;
    if (i == 0 || i == values->parts)
        return i == 0 ? values->first : values->last;
    if (values->first == -values->last)
        return values->last * (double)(2 * i - values->parts) / parts;
    return values->first + (values->last - values->first) * (double)i / parts;
}

double range_value(const range *values, int64_t i)
{
    if (values->items != NULL)
        return values->items[i];
    if (values->power > 0)
        return (double)(values->first_units + i * values->step_units) / values->power;
    if (values->parts > 0)
        return value_between(values, i);
    return i == values->count - 1 ? values->last : values->first + (double)i * values->step;
}

/* A range is monotonic: its ends tell. */
bool range_within(const range *values, double lo, double hi, double *outside)
{
    const int64_t stride = values->items != NULL || values->count < 2 ? 1 : values->count - 1;
    for (int64_t i = 0; i < values->count; i += stride) {
        *outside = range_value(values, i);
        if (!(*outside >= lo && *outside <= hi))
            return false;
    }
    return true;
}

void range_free(range *values)
{
    free(values->items);
    *values = (range){0};
}
