/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the command-line tool that its tables reach not at all, or with too few values: texts in
 * CSV and JSON, and hundreds of thousands of numbers and ranges. */
#include "text/number.h"
#include "text/range.h"
#include "rows/delimited.h"
#include "rows/json.h"

#include <inttypes.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The same sequence on every machine (splitmix64). */
static uint64_t next_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* One row of one cell, and what was written of it. */
static const char *written(const record_format *format, char separator, const char *name,
                           cell value)
{
    static output out;
    out.used = 0;
    records rows = {
        .format = format, .out = &out, .digits = 17, .decimal_sign = '.', .separator = separator};
    format->value(&rows, name, value);
    format->end_row(&rows);
    out.buffer[out.used] = '\0';
    return rows.problem != NULL ? rows.problem : out.buffer;
}

static void csv_quotes_what_rfc_4180_says(void **state)
{
    (void)state;
    const record_format *csv = &delimited_format;
    assert_string_equal(written(csv, ',', "n", cell_text("plain")), "plain\n");
    assert_string_equal(written(csv, ',', "n", cell_text("a,b")), "\"a,b\"\n");
    assert_string_equal(written(csv, ',', "n", cell_text("a;b\tc d'e")), "a;b\tc d'e\n");
    assert_string_equal(written(csv, ',', "n", cell_text("say \"no\"")), "\"say \"\"no\"\"\"\n");
    assert_string_equal(written(csv, ',', "n", cell_text("two\nlines")), "\"two\nlines\"\n");
    assert_string_equal(written(csv, ',', "n", cell_text("cr\r")), "\"cr\r\"\n");
    assert_string_equal(written(csv, ';', "n", cell_text("a,b")), "a,b\n");
    assert_string_equal(written(csv, ';', "n", cell_text("a;b")), "\"a;b\"\n");
    assert_string_equal(written(csv, '\t', "n", cell_text("a\tb")), "\"a\tb\"\n");
    assert_string_equal(written(csv, ',', "n", cell_empty()), "\n");
}

static void numbers_that_are_not_finite_are_empty(void **state)
{
    (void)state;
    const double not_finite[] = {NAN, HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 3; i++) {
        assert_string_equal(written(&delimited_format, ',', "n", cell_number(not_finite[i])), "\n");
        assert_string_equal(written(&json_format, ',', "n", cell_number(not_finite[i])),
                            "\n{\"n\": null}");
    }
}

static void json_escapes_texts_and_refuses_what_is_not_utf8(void **state)
{
    (void)state;
    assert_string_equal(written(&json_format, ',', "n", cell_text("\"\\\n\x01")),
                        "\n{\"n\": \"\\\"\\\\\\n\\u0001\"}");
    assert_string_equal(written(&json_format, ',', "\"", cell_number(0.5)), "\n{\"\\\"\": 0.5}");
    assert_string_equal(written(&json_format, ',', "n", cell_text("\xc3\xa4")),
                        "\n{\"n\": \"\xc3\xa4\"}");
    assert_string_equal(written(&json_format, ',', "n", cell_empty()), "\n{\"n\": null}");
    assert_non_null(strstr(written(&json_format, ',', "n", cell_text("\xe4")), "not UTF-8"));
}

static void every_double_reads_back(void **state)
{
    (void)state;
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

static void minus_zero_is_zero(void **state)
{
    (void)state;
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
static double nearest_to(int64_t units, int places)
{
    char text[64];
    snprintf(text, sizeof text, "%" PRId64 "e-%d", units, places);
    return strtod(text, NULL);
}

static void values_of_a_range_are_the_nearest_to_their_decimals(void **state)
{
    (void)state;
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
        assert_true(range_value(&values, any) == nearest_to(start + sign * any * step, places));
        assert_true(range_value(&values, count - 1) ==
                    nearest_to(start + sign * (count - 1) * step, places));
        range_free(&values);
    }
}

/* Arguments are typed by people and made by programs: whatever the text, an answer, and only
 * finite values. */
static void no_text_upsets_a_range(void **state)
{
    (void)state;
    static const char alphabet[] = "0123456789019.:,-+eE:,.5 xn";
    uint64_t seed = 3;
    int64_t accepted = 0;
    for (int i = 0; i < 500000; i++) {
        char text[24];
        const size_t length = next_random(&seed) % (sizeof text - 1);
        for (size_t j = 0; j < length; j++)
            text[j] = alphabet[next_random(&seed) % (sizeof alphabet - 1)];
        text[length] = '\0';
        range values;
        if (range_read(text, &values) != NULL)
            continue;
        accepted++;
        assert_true(values.count >= 1 && values.count <= RANGE_VALUES_MAX);
        assert_true(isfinite(range_value(&values, 0)) &&
                    isfinite(range_value(&values, values.count - 1)));
        range_free(&values);
    }
    assert_true(accepted > 1000);
}

int main(void)
{
    const struct CMUnitTest claims[] = {
        cmocka_unit_test(csv_quotes_what_rfc_4180_says),
        cmocka_unit_test(numbers_that_are_not_finite_are_empty),
        cmocka_unit_test(json_escapes_texts_and_refuses_what_is_not_utf8),
        cmocka_unit_test(every_double_reads_back),
        cmocka_unit_test(minus_zero_is_zero),
        cmocka_unit_test(values_of_a_range_are_the_nearest_to_their_decimals),
        cmocka_unit_test(no_text_upsets_a_range),
    };
    return cmocka_run_group_tests_name("cli_parts", claims, NULL, NULL);
}
