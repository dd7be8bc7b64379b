/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void claim_within(double actual, double expected, double tolerance, const char *expression,
                  const char *file, int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%s\n    is       %.17g\n    expected %.17g\n    off by   %.3g, allowed %.3g\n",
                expression, actual, expected, fabs(actual - expected), tolerance);
    _fail(file, line);
}

void claim_nan(double actual, const char *expression, const char *file, int line)
{
    if (isnan(actual))
        return;
    print_error("%s\n    is %.17g, expected NaN\n", expression, actual);
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
    static char line[1 << 15];
    if (!fgets(line, sizeof line, table->stream)) {
        fclose(table->stream);
        return false;
    }
    table->row++;
    size_t column = 0;
    for (char *cell = line; cell && column < REFERENCE_COLUMNS; column++) {
        char *end = cell + strcspn(cell, ",\r\n"), *stop, *next = *end == ',' ? end + 1 : NULL;
        *end = '\0';
        const double value = strtod(cell, &stop);
        table->cell[column] = stop == cell || *stop ? NAN : value;
        snprintf(table->last, sizeof table->last, "%.31s", cell);
        cell = next;
    }
    return true;
}

double random_fraction(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u; /* Knuth's MMIX generator */
    return (double)(*state >> 11) * 0x1p-53;
}

double random_between(uint64_t *state, double low, double high)
{
    return low + (high - low) * random_fraction(state);
}

static int gsl_errors;

static void count(const char *reason, const char *file, int line, int number)
{
    gsl_errors++;
    fprintf(stderr, "GSL's handler was reached: %s:%d: %s (%d)\n", file, line, reason, number);
}

/* ---- Running ---- */

typedef struct owned {
    void *object;
    void (*destroy)(void *object);
    struct owned *before;
} owned;
static owned *last_owned;

void free_after_claim(void *object, void (*destroy)(void *object))
{
    owned *entry = malloc(sizeof *entry);
    assert_non_null(entry);
    *entry = (owned){object, destroy, last_owned};
    last_owned = entry;
}

static int free_owned(void **unused)
{
    (void)unused;
    for (owned *entry; (entry = last_owned) != NULL; free(entry)) {
        last_owned = entry->before;
        entry->destroy(entry->object);
    }
    return 0;
}

enum { CLAIMS_MAX = 64 };
static void (*claims[CLAIMS_MAX])(void);
static struct CMUnitTest tests[CLAIMS_MAX];
static size_t claim_count;

static size_t runs;

static void run(void **claim)
{
    runs++;
    (*(void (**)(void)) * claim)();
}

void claim_add(const char *name, void (*claim)(void))
{
    if (claim_count == CLAIMS_MAX) {
        fprintf(stderr, "%s: no room for more claims\n", name);
        exit(1);
    }
    claims[claim_count] = claim;
    tests[claim_count] = (struct CMUnitTest){.name = name,
                                             .test_func = run,
                                             .teardown_func = free_owned,
                                             .initial_state = &claims[claim_count]};
    claim_count++;
}

int run_claims(void)
{
    gsl_set_error_handler(count);
    const int failed = _cmocka_run_group_tests("claims", tests, claim_count, NULL, NULL);
    if (gsl_errors)
        fprintf(stderr, "GSL's handler was reached %d times\n", gsl_errors);
    if (runs == 0)
        fprintf(stderr, "no claim has been tried: none has such a name\n");
    return runs == 0 || failed || gsl_errors;
}
