/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hundreds of thousands of numbers and ranges, which the tool's tables try too few of. */
#include "claims.h"
#include "number/number.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The bits of two numbers: each has 53 that are random. */
static uint64_t next_random(uint64_t *state)
{
    const uint64_t high = (uint64_t)ldexp(random_fraction(state), 32);
    return high << 32 | (uint64_t)ldexp(random_fraction(state), 32);
}

CLAIM(every_double_reads_back)
{
    uint64_t seed = 1;
    for (int i = 0; i < 200000; i++) {
        const uint64_t bits = next_random(&seed);
        double value, again;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        char text[NUMBER_SIZE];
        const size_t length = number_write(value, NUMBER_DIGITS, '.', text);
        assert_int_equal(length, strlen(text));
        assert_true(number_read(text, &again));
        assert_memory_equal(&value, &again, sizeof value);
    }
}

CLAIM(minus_zero_is_zero)
{
    double value;
    assert_true(number_read("-0.0e5", &value));
    assert_false(signbit(value));
    char text[NUMBER_SIZE];
    number_write(-0.0, 17, '.', text);
    assert_string_equal(text, "0");
    number_write(-0.0, 3, ',', text);
    assert_string_equal(text, "0");
}

/* Reads "units e-places" as the nearest double, by the C library. */
static double double_near(int64_t units, int places)
{
    char text[64];
    snprintf(text, sizeof text, "%" PRId64 "e-%d", units, places);
    return strtod(text, NULL);
}

CLAIM(values_of_a_range_are_the_nearest_to_their_decimals)
{
    uint64_t seed = 2;
    for (int i = 0; i < 20000; i++) {
        const int places = (int)(next_random(&seed) % 13);
        const int64_t start = (int64_t)(next_random(&seed) % 2000001) - 1000000;
        const int64_t step = (int64_t)(next_random(&seed) % 99999) + 1,
                      count = (int64_t)(next_random(&seed) % 1000) + 1;
        const int64_t sign = next_random(&seed) % 2 == 0 ? 1 : -1;
        char text[160];
        snprintf(text, sizeof text, "%" PRId64 "e-%d:%" PRId64 "e-%d:%" PRId64 "e-%d", start,
                 places, start + sign * (count - 1) * step, places, sign * step, places);
        range values;
        assert_null(range_read(text, &values));
        assert_int_equal(values.count, count);
        const int64_t any = (int64_t)(next_random(&seed) % (uint64_t)count);
        assert_true(range_value(&values, any) == double_near(start + sign * any * step, places));
        assert_true(range_value(&values, count - 1) ==
                    double_near(start + sign * (count - 1) * step, places));
        range_free(&values);
    }
}

/* It begins with START, and does not pass STOP. */
static bool try_range(const char *text)
{
    range values;
    if (range_read(text, &values) != NULL)
        return false;
    assert_true(values.count >= 1 && values.count <= RANGE_VALUES_MAX);
    for (int64_t i = 0; i < values.count; i += 1 + values.count / 49)
        assert_true(isfinite(range_value(&values, i)));
    const char *colon = strchr(text, ':');
    const double first = range_value(&values, 0), last = range_value(&values, values.count - 1),
                 stop = colon != NULL ? strtod(colon + 1, NULL) : last;
    assert_true(first == strtod(text, NULL));
    assert_true(colon == NULL || (first <= stop ? last <= stop : last >= stop));
    range_free(&values);
    return true;
}

/* Arguments are typed by people and made by programs: whatever the text, an answer. */
CLAIM(no_text_upsets_a_range)
{
    static const char alphabet[] = "0123456789019.:,-+eE:,.5 xn";
    uint64_t seed = 3;
    int64_t accepted = 0;
    for (int i = 0; i < 500000; i++) {
        char text[24];
        const size_t length = next_random(&seed) % (sizeof text - 1);
        for (size_t j = 0; j < length; j++)
            text[j] = alphabet[next_random(&seed) % (sizeof alphabet - 1)];
        text[length] = '\0';
        accepted += try_range(text);
    }
    assert_true(accepted > 1000);
    assert_false(try_range("12e-8:1e+9:1.e0"));          /* one value too many */
    assert_true(try_range("9999999999999992e-8:1e8:1")); /* STOP within rounding */
}
