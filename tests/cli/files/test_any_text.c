/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader of tables is given what no one would write: files of instruments with bytes put in,
 * taken out and changed. Two numbers, of cases and for the seed, give more and others. */
#define PI PI_OF_CLAIMS /* the model has its own */
#include "claims.h"
#undef PI
#include "input/input.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Small files of the kinds that are read, and what they are mutated with. */
static const char *const files[] = {
    "x,height\n-1,0.01\n0,0\n1,0.01\n",
    "x [um]\theight [um]\n-1000\t10\n0\t0\n1000\t10\n",
    "Operator: A\nSample: 3\n\nx;height\nmm;um\n-1;10\n0;0\n1;10\n",
    "# x height\n-1 0.01\n0 0\n1 0.01\n",
    "\xef\xbb\xbfx,slope\r\n-1,-0.02\r\n0,0\r\n1,0.02\r\n",
    "sep=|\nname|x|height\n\"a \"\"b\"\"\"|-1|0.01\n\"c\nd\"|0|0\ne|1|0.01\n",
};
static const char *const parts[] = {",", ";",   "\t",    "\"",     "\n",      "\r", "#",    "[mm]",
                                    "|", "NaN", "1e999", "-",      "sep=;\n", "x,", "\xef", "-9999",
                                    " ", "'",   "\xc3",  "height", "1.5e-3",  ",,", "inf"};
enum {
    FILES = sizeof files / sizeof files[0],
    PARTS = sizeof parts / sizeof parts[0],
    MOST = 4096
};

static size_t below(size_t count, uint64_t *seed)
{
    return (size_t)(random_fraction(seed) * (double)count);
}

/* Puts a part, or a byte, in the place of some bytes. */
static size_t change(char text[MOST], size_t length, uint64_t *seed)
{
    char byte[2] = {(char)below(256, seed), '\0'};
    const char *part = random_fraction(seed) < 0.7 ? parts[below(PARTS, seed)] : byte;
    const size_t at = below(length + 1, seed), size = strlen(part);
    size_t gone = random_fraction(seed) < 0.5 ? 0 : below(8, seed);
    gone = at + gone > length ? length - at : gone;
    if (length - gone + size >= MOST)
        return length;
    memmove(text + at + size, text + at + gone, length - at - gone);
    memcpy(text + at, part, size);
    return length - gone + size;
}

static void write_file(const char *path, const char *text, size_t length)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

/* Either finite numbers, or a problem that names the file. */
static void check(const char *path, bool has_units, bool drops, char decimal_sign)
{
    complaint why;
    unit_system units = units_unknown;
    assert_true(!has_units || units_read("mm,N,MPa", &units, &why));
    const reading how = {
        .decimal_sign = decimal_sign, .units = &units, .drops = drops, .is_command = true};
    const pair_columns wanted = {.first = "x",
                                 .second = "slope",
                                 .instead = "height",
                                 .dimension = "slope",
                                 .other = "length",
                                 .needed = "x, and slope or height",
                                 .rows = "places",
                                 .most = 1000};
    pairs rows;
    pairs_read(path, &how, &wanted, &rows);
    if (rows.problem.text[0] == '\0') {
        assert_true(rows.count > 0);
        for (size_t i = 0; i < rows.count; i++)
            assert_true(isfinite(rows.first[i]) && isfinite(rows.second[i]) && rows.line[i] > 0);
    } else {
        assert_int_equal(strncmp(rows.problem.text, path, strlen(path)), 0);
    }
    pairs_free(&rows);
}

CLAIM(any_text_gives_numbers_or_a_problem)
{
    static const char path[] = "any_text.csv"; /* where the test runs */
    uint64_t seed = seed_or(7);
    for (long i = 0; i < cases_or(6000); i++) {
        char text[MOST];
        size_t length = strlen(files[i % FILES]);
        memcpy(text, files[i % FILES], length);
        for (size_t changes = 1 + below(12, &seed); changes > 0; changes--)
            length = change(text, length, &seed);
        write_file(path, text, length);
        check(path, i % 2 == 0, i % 3 == 0, i % 5 == 0 ? ',' : '.');
    }
    remove(path);
}
