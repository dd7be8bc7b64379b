/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "decimal.h"

#include <ctype.h>

/* An exponent beyond this one is out of a double's range, however many digits come before it in
 * an argument. */
enum { EXPONENT_MAX = 1000000 };

static bool multiply_by_ten(int64_t *units, int times)
{
    for (; times > 0 && *units != 0; times--) {
        if (*units > DECIMAL_UNITS_MAX / 10 || *units < -DECIMAL_UNITS_MAX / 10)
            return false;
        *units *= 10;
    }
    return true;
}

static bool append_digit(int64_t *units, int digit, int zeros_before)
{
    if (!multiply_by_ten(units, zeros_before + 1))
        return false;
    *units += digit;
    return *units <= DECIMAL_UNITS_MAX;
}

static int read_exponent(const char *text, const char *end)
{
    const bool negative = *text == '-';
    int exponent = 0;
    for (text += *text == '+' || *text == '-' ? 1 : 0; text < end; text++)
        if (exponent < EXPONENT_MAX)
            exponent = 10 * exponent + (*text - '0');
    return negative ? -exponent : exponent;
}

bool decimal_read(const char *text, size_t length, decimal *number)
{
    const char *const end = text + length;
    const bool negative = *text == '-';
    int64_t units = 0;
    int zeros = 0, places = 0; /* zeros not yet multiplied in: 0.500 has units 5, places 1 */
    bool after_point = false;
    const char *c = text + (*text == '+' || *text == '-' ? 1 : 0);
    for (; c < end && (isdigit((unsigned char)*c) || *c == '.'); c++) {
        if (*c == '.') {
            after_point = true;
            continue;
        }
        places += after_point ? 1 : 0;
        if (*c == '0')
            zeros++;
        else if (append_digit(&units, *c - '0', zeros))
            zeros = 0;
        else
            return false;
    }
    const int exponent = c < end ? read_exponent(c + 1, end) : 0;
    number->units = negative ? -units : units;
    number->places = units == 0 ? 0 : places - zeros - exponent;
    return true;
}

bool decimal_rescale(decimal *number, int places)
{
    const int more = places - number->places;
    number->places = places;
    return multiply_by_ten(&number->units, more);
}

double decimal_power(int places)
{
    double power = 1;
    for (int i = 0; i < places; i++)
        power *= 10;
    return power;
}
