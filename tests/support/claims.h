/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every test program shares: assertions with a visible tolerance, reference tables, and a
 * GSL error handler that only counts, because no call of the library may reach it. */
#ifndef CLAIMS_H
#define CLAIMS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static const double PI = 3.14159265358979323846;

/* A test: CLAIM(what_holds) { ... }. Those of a program run in the order of their file. */
#define CLAIM(name)                                                                                \
    static void name(void);                                                                        \
    __attribute__((constructor)) static void add_##name(void)                                      \
    {                                                                                              \
        claim_add(#name, name);                                                                    \
    }                                                                                              \
    static void name(void)
void claim_add(const char *name, void (*claim)(void));

/* The object lives to the end of the present claim, whether that holds or fails. */
void free_after_claim(void *object, void (*destroy)(void *object));

/* Runs the claims under the counting handler; the process' exit status. */
int run_claims(void);

/* How many random cases a claim takes, and their first seed, if the command line says so. */
long cases_or(long usual);
uint64_t seed_or(uint64_t usual);

/* The call of the library gives the status RWEDGE_OK. */
#define assert_ok(call) assert_int_equal((call), RWEDGE_OK)

/* |actual - expected| <= relative |expected|. A NaN fails. */
#define assert_close(actual, expected, relative)                                                   \
    claim_within((actual), (expected), (relative)*fabs((double)(expected)), #actual, __FILE__,     \
                 __LINE__)

/* |actual - expected| <= absolute. A NaN fails. */
#define assert_within(actual, expected, absolute)                                                  \
    claim_within((actual), (expected), (absolute), #actual, __FILE__, __LINE__)

/* actual is not a number. */
#define assert_nan(actual) claim_nan((actual), #actual, __FILE__, __LINE__)

void claim_within(double actual, double expected, double tolerance, const char *expression,
                  const char *file, int line);
void claim_nan(double actual, const char *expression, const char *file, int line);

/* A table of tests/data/, read row by row. Cells that are not numbers are NaN; text keeps the
 * last column. */
enum { REFERENCE_COLUMNS = 1200 };
typedef struct {
    void *stream;
    double cell[REFERENCE_COLUMNS];
    char last[32];
    size_t row;
} reference;

reference reference_open(const char *name); /* fails the test where it cannot be read */
bool reference_next(reference *table);      /* closes the file at its end */

/* Uniform in [0, 1), the same sequence on every machine; *state is any seed. */
double random_fraction(uint64_t *state);
double random_between(uint64_t *state, double low, double high);

#endif
