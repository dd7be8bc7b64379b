/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void claim_within(double actual, double expected, double tolerance, const char *what,
                  const char *file, int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%s\n    is       %.17g\n    expected %.17g\n    off by   %.3g, allowed %.3g\n",
                what, actual, expected, fabs(actual - expected), tolerance);
    _fail(file, line);
}

void claim_nan(double actual, const char *what, const char *file, int line)
{
    if (isnan(actual))
        return;
    print_error("%s\n    is %.17g, expected NaN\n", what, actual);
    _fail(file, line);
}

reference reference_open(const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", TEST_DATA, name);
    reference table = {.stream = fopen(path, "r")};
    char header[1024];
    if (!table.stream || !fgets(header, sizeof header, table.stream))
        fail_msg("cannot read %s", path);
    return table;
}

bool reference_next(reference *table)
{
    char line[1024];
    if (!fgets(line, sizeof line, table->stream)) {
        fclose(table->stream);
        return false;
    }
    table->row++;
    size_t column = 0;
    for (char *cell = strtok(line, ",\r\n"); cell && column < REFERENCE_COLUMNS;
         cell = strtok(NULL, ",\r\n")) {
        char *end;
        const double value = strtod(cell, &end);
        table->cell[column++] = *end ? NAN : value;
        snprintf(table->last, sizeof table->last, "%s", cell);
    }
    return true;
}

double random_fraction(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u; /* Knuth's MMIX generator */
    return (double)(*state >> 11) * 0x1p-53;
}

static int gsl_errors;

static void count(const char *reason, const char *file, int line, int number)
{
    gsl_errors++;
    fprintf(stderr, "GSL's handler was reached: %s:%d: %s (%d)\n", file, line, reason, number);
}

int run_claims(const char *room, const struct CMUnitTest *tests, size_t count_of_tests)
{
    gsl_set_error_handler(count);
    const int failed = _cmocka_run_group_tests(room, tests, count_of_tests, NULL, NULL);
    if (gsl_errors)
        fprintf(stderr, "%s: GSL's handler was reached %d times\n", room, gsl_errors);
    return failed || gsl_errors;
}
