/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "number.h"

#include "text/text.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char not_a_range[] = "must be a number, a comma list of numbers, or START:STOP:STEP";
static const char zero_step[] = "the STEP of START:STOP:STEP must not be 0";
static const char wrong_sign[] = "the STEP of START:STOP:STEP must lead from START towards STOP";
static const char too_many[] = "must not have more than 1000000000 values";
static const char impossible[] = "must be 0, or 1e-60 to 1e60 in magnitude";

enum { START, STOP, STEP };

/* The decimals that were meant: 0.1 + 2 * 0.1 is not 0.3 in doubles, but 3/10 is. A sum of numbers
 * below this many units of the last decimal place errs by less than half a unit. */
static const double UNITS_MAX = 1e15;

/* The largest power of ten that is a double. */
static const double POWER_MAX = 1e22;

static double in_units(double value, double power)
{
    return floor(value * power + 0.5) / power;
}

/* The power of ten that makes all three whole numbers; 0 where they have too many digits. */
static double common_power(const double number[3])
{
    double power = 1;
    for (int i = 0; i < 3; i++)
        while (power <= POWER_MAX && in_units(number[i], power) != number[i])
            power *= 10;
    for (int i = 0; i < 3; i++)
        if (!(fabs(number[i]) * power < UNITS_MAX))
            return 0;
    return power <= POWER_MAX ? power : 0;
}

static double after_steps(const range *values, double steps)
{
    const double value = values->first + steps * values->step;
    return values->power > 0 ? in_units(value, values->power) : value;
}

/* A number with too many digits counts as STOP where it differs from STOP by rounding alone. */
static const char *read_steps(const char *text, range *values)
{
    double number[3];
    if (number_read_list(text, strlen(text), ':', 3, number) != 3)
        return not_a_range;
    const double start = number[START], stop = number[STOP], step = number[STEP];
    if (step == 0)
        return zero_step;
    if ((stop > start && step < 0) || (stop < start && step > 0))
        return wrong_sign;
    if (!number_is_size(start) || !number_is_size(stop))
        return impossible;
    values->first = start;
    values->step = step;
    values->power = common_power(number);
    const double steps = (stop - start) / step, nearest = floor(steps + 0.5);
    const double rounding = values->power > 0 ? 0 : 4 * DBL_EPSILON * (fabs(start) + fabs(stop));
    const bool hit = fabs(after_steps(values, nearest) - stop) <= rounding;
    const double last = hit ? nearest : floor(steps);
    if (!(last < (double)RANGE_VALUES_MAX))
        return too_many;
    values->count = (int64_t)last + 1;
    values->last = hit && last > 0 ? stop : after_steps(values, last);
    return NULL;
}

static const char *read_list(const char *text, range *values)
{
    int most = 1;
    for (const char *c = text; *c != '\0'; c++)
        most += *c == ',';
    values->items = memory_zeroed((size_t)most, sizeof *values->items);
    values->count = number_read_list(text, strlen(text), ',', most, values->items);
    for (int64_t i = 0; i < values->count; i++)
        if (!number_is_size(values->items[i]))
            return impossible;
    return values->count > 0 ? NULL : not_a_range;
}

const char *range_read(const char *text, range *values)
{
    *values = (range){0};
    const char *reason =
        strchr(text, ':') != NULL ? read_steps(text, values) : read_list(text, values);
    if (reason != NULL)
        range_free(values);
    return reason;
}

/* 0,5 and 1,05: a zero is in front of digits. */
bool range_say_pair(const char *option, const char *all, const char *text, size_t length)
{
    static const char digits[] = "0123456789";
    const size_t sign = text[0] == '-' || text[0] == '+' ? 1 : 0;
    const size_t whole = strspn(text + sign, digits), comma = sign + whole;
    const size_t fraction = text[comma] == ',' ? strspn(text + comma + 1, digits) : 0;
    const int first = (int)comma, second = (int)fraction;
    if (whole == 0 || fraction == 0 || comma + 1 + fraction != length ||
        !((whole == 1 && text[sign] == '0') || (fraction > 1 && text[comma + 1] == '0')))
        return false;
    notice("--%s %s: two values, %.*s and %.*s; a decimal is written %.*s.%.*s", option, all, first,
           text, second, text + first + 1, first, text, second, text + first + 1);
    return true;
}

/* Counted from the middle where that is 0: first + i * step would miss it by its rounding. */
range range_between(double first, double last, int64_t count)
{
    range values = {.count = count, .items = memory_zeroed((size_t)count, sizeof(double))};
    const double parts = (double)(count - 1);
    for (int64_t i = 0; i < count; i++)
        values.items[i] = first == -last ? last * ((double)(2 * i) - parts) / parts
                                         : first + (last - first) * (double)i / parts;
    values.items[0] = first;
    values.items[count - 1] = last;
    return values;
}

double range_value(const range *values, int64_t i)
{
    if (values->items != NULL)
        return values->items[i];
    return i == values->count - 1 ? values->last : after_steps(values, (double)i);
}

int64_t range_product(int count, const range values[])
{
    double size = 1;
    for (int i = 0; i < count; i++)
        size *= (double)values[i].count;
    return size < 9e18 ? (int64_t)size : INT64_MAX;
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
