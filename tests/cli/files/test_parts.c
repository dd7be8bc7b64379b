/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of the command-line tool that its tables reach not at all, or with too few values: texts in
 * CSV and JSON, and hundreds of thousands of numbers and ranges. */
#include "claims.h"
#include "sheet/sheet.h"
#include "text/text.h"
#include "number/number.h"
#include "rows/rows.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <iconv.h>

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
    records rows = {
        .format = format, .out = &out, .digits = 17, .decimal_sign = '.', .separator = separator};
    format->name(&rows, name);
    format->end_header(&rows);
    out.used = 0;
    records_row(&rows, 1, &value);
    out.buffer[out.used] = '\0';
    return rows.problem != NULL ? rows.problem : out.buffer;
}

CLAIM(csv_quotes_what_rfc_4180_says)
{
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

CLAIM(numbers_that_are_not_finite_are_empty)
{
    const double not_finite[] = {NAN, HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 3; i++) {
        assert_string_equal(written(&delimited_format, ',', "n", cell_number(not_finite[i])), "\n");
        assert_string_equal(written(&json_format, ',', "n", cell_number(not_finite[i])),
                            "\n{\"n\": null}");
    }
}

CLAIM(json_escapes_texts_and_refuses_what_is_not_utf8)
{
    assert_string_equal(written(&json_format, ',', "n", cell_text("\"\\\n\x01")),
                        "\n{\"n\": \"\\\"\\\\\\n\\u0001\"}");
    assert_string_equal(written(&json_format, ',', "\"", cell_number(0.5)), "\n{\"\\\"\": 0.5}");
    assert_string_equal(written(&json_format, ',', "n", cell_text("\xc3\xa4")),
                        "\n{\"n\": \"\xc3\xa4\"}");
    assert_string_equal(written(&json_format, ',', "n", cell_empty()), "\n{\"n\": null}");
    assert_non_null(strstr(written(&json_format, ',', "n", cell_text("\xe4")), "not UTF-8"));
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

/* Arguments are typed by people and made by programs: whatever the text, an answer, and only
 * finite values. */
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

/* ---- UTF-8, against iconv ---- */

/* The bytes of the first character as iconv sees it, and its code; 0 where there is none. */
static size_t length_by_iconv(iconv_t converter, char *bytes, size_t count, uint32_t *code)
{
    for (size_t length = 1; length <= count && length <= 4; length++) {
        unsigned char wide[8];
        char *from = bytes, *to = (char *)wide;
        size_t left = length, room = sizeof wide;
        iconv(converter, NULL, NULL, NULL, NULL);
        if (iconv(converter, &from, &left, &to, &room) == (size_t)-1 || room != 4)
            continue;
        *code = (uint32_t)wide[0] | (uint32_t)wide[1] << 8 | (uint32_t)wide[2] << 16;
        return length;
    }
    return 0;
}

CLAIM(utf8_is_what_iconv_takes_for_it)
{
    iconv_t converter = iconv_open("UTF-32LE", "UTF-8");
    if (converter == (iconv_t)-1) {
        print_message("SKIPPED: iconv has no UTF-32LE here\n");
        skip();
    }
    static const unsigned char edges[] = {0x00, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf,
                                          0xc0, 0xc1, 0xc2, 0xdf, 0xe0, 0xe1, 0xed, 0xee, 0xef,
                                          0xf0, 0xf1, 0xf3, 0xf4, 0xf5, 0xf8, 0xfe, 0xff};
    enum { EDGES = sizeof edges };
    int characters = 0;
    for (int i = 0; i < EDGES * EDGES * EDGES * EDGES; i++) {
        char bytes[4];
        for (int j = 0, rest = i; j < 4; j++, rest /= EDGES)
            bytes[j] = (char)edges[rest % EDGES];
        uint32_t ours = 0, theirs = 0;
        const size_t length = utf8_length(bytes, sizeof bytes, &ours);
        assert_int_equal(length, length_by_iconv(converter, bytes, sizeof bytes, &theirs));
        assert_int_equal(ours, theirs);
        characters += length > 1;
    }
    assert_true(characters > 1000);
    iconv_close(converter);
}

CLAIM(a_text_is_cut_between_its_characters)
{
    char room[8];
    assert_true(utf8_copy("a\xc3\xa4", utf8_is_text, "?", room, sizeof room));
    assert_string_equal(room, "a\xc3\xa4");
    assert_true(utf8_copy("a\xff\x01\xc3", utf8_is_text, "?", room, sizeof room));
    assert_string_equal(room, "a???");
    assert_false(utf8_copy("abcde\xe2\x82\xac", utf8_is_text, "?", room, sizeof room));
    assert_string_equal(room, "abcde");
    assert_true(utf8_copy("abcd\xe2\x82\xac", utf8_is_text, "?", room, sizeof room));
}

CLAIM(no_spreadsheet_holds_what_xml_cannot)
{
    static const char *const texts[] = {"\xfc", "\x01", "\xef\xbf\xbe", "\xc3", "sound \xc3\xbc"};
    enum { TEXTS = sizeof texts / sizeof texts[0] };
    if (xlsx_missing() != NULL) {
        print_message("SKIPPED: this build has no libxlsxwriter\n");
        skip();
    }
    for (int i = 0; i < TEXTS; i++) {
        static output out;
        const char *problem;
        out = (output){.descriptor = -1, .error = 1}; /* takes nothing */
        xlsx *book = xlsx_begin("texts", true, &problem);
        assert_non_null(book);
        xlsx_sheet(book, "Texts");
        xlsx_text(book, 0, 0, texts[i], XLSX_PLAIN);
        assert_int_equal(xlsx_finish(book, &out) == NULL, i == TEXTS - 1);
    }
}

CLAIM(the_nearest_name_is_the_one_that_was_meant)
{
    static const char *const names[] = {"solve", "table", "field", "figure", "yield-stress", "E1"};
    static const char *const typed[][2] = {{"sovle", "solve"},
                                           {"tabel", "table"},
                                           {"fig", "figure"},
                                           {"FIELD", "field"},
                                           {"yield_stres", "yield-stress"},
                                           {"E", "E1"},
                                           {"x", NULL},
                                           {"", NULL},
                                           {"workbook", NULL},
                                           {"mu", NULL}};
    for (size_t i = 0; i < sizeof typed / sizeof typed[0]; i++) {
        nearest_name to = nearest_to(typed[i][0]);
        for (size_t j = 0; j < sizeof names / sizeof names[0]; j++)
            nearest_try(&to, names[j]);
        if (typed[i][1] == NULL)
            assert_null(to.name);
        else
            assert_string_equal(to.name, typed[i][1]);
    }
}
