/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SERIES_H
#define CLI_SERIES_H

#include "model/cycle/cycle.h"
#include "model/reading/reading.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- test_columns ---- Which columns of a table are what of a test. */

enum {
    TEST_P0, /* the largest pressure under P alone, in place of P */
    TEST_Q_MAX,
    TEST_Q_MIN,
    TEST_SIGMA_MAX,
    TEST_SIGMA_MIN,
    TEST_SIGMA_BEFORE, /* that acts before P comes, and while it does */
    TEST_LOADS,        /* the name of a file of loads, the cycle */
    TEST_LIFE,         /* that was measured; ">1e7" is a run-out */
    TEST_COLUMNS
};

typedef struct {
    const char *name, *meaning, *unit;
    unit_share of;
} test_column;
extern const test_column test_columns[TEST_COLUMNS];

/* A series, and what all its tests have in common. */
typedef struct {
    header names;
    input_texts constants; /* for the columns that the table does not have */
    criteria asked;        /* the constants of all tests are given */
    distance below;        /* a length of NAN for the surface alone */
    int64_t cycles;
    char separator;
    size_t column[TEST_COLUMNS], constant[MATERIAL_MAX]; /* the count where it is not there */
} series;

bool series_has(const series *all, int test_column);

/* Finds the columns. False, with the complaint, where they give no tests. */
bool series_find(series *all, header *names, complaint *why);

/* The constants of a material, those that have a column standing for any number. */
material series_constants(const series *all, const material *given);

/* ---- test_row ---- A test from the cells of its row. */

/* Loads of a file; the complaint says what is wrong with it. */
typedef struct {
    load *to;
    size_t count;
    complaint why;
} test_log;

enum { TEST_LOADS_MAX = 2 }; /* before the cycle, and of one without a file */

typedef struct {
    contact_case setup;
    criteria asked;
    load before[TEST_LOADS_MAX], own[TEST_LOADS_MAX];
    const load *cycle; /* these, or those of the file */
    size_t before_count, count;
    double P;      /* under which it first is; found where p0 is given */
    double tested; /* the life; NAN where it is not given */
    bool is_run_out;
} test_case;

/* The name of its file of loads; "" for none. */
const char *test_log_name(const series *all, const char *const row[], size_t count);

/* Its friction; 0 where that cannot be read. */
double test_friction(const series *all, const char *const row[], size_t count);

/* Reads a row of so many cells; the log is that of its file, NULL for none. False, with the
 * complaint, where it is no test. Destroy the contact also after an error. */
bool test_read(const series *all, const char *const row[], size_t count, const test_log *log,
               test_case *test, complaint *why);

/* ---- test_run ---- A test that is gone through. */

/* What a criterion comes to at the worst place of the surface, and at the length where there is
 * one. NAN where it is not known, or nowhere above 0. */
typedef struct {
    double value, x, at_length, load_factor;
} test_criterion;

typedef struct {
    double left, right, stick_left, stick_right; /* in all of the cycle; NAN for no stick zone */
    double peak_pressure;                        /* after the last load */
    test_criterion criterion[DAMAGE];
    double damage, life; /* by the criterion of lives; a life of INFINITY is a run-out */
    doubts doubts;
} test_results;

typedef struct {
    bool is_run; /* the rest is there */
    test_case test;
    last_cycle last;
    worst_row worst[COLUMN_MAX];
    test_results results;
} test_run;

/* Goes through a test, and finds where each criterion is worst. False, with the complaint. */
bool test_go(const series *all, test_run *run, complaint *why);
void test_free(test_run *run);

/* Whether a criterion is told of. */
bool series_shows(const series *all, int criterion);

/* The criterion of lives: the first that is told of and has a curve; NO_CRITERION for none. */
int series_of_lives(const series *all);

/* ---- series_length ---- What the tests come to at a critical distance. */

/* The results at the length of the series, or at the surface. False, with the complaint. */
bool test_judge(const series *all, test_run *run, complaint *why);

/* How much tests scatter: of lives the standard deviation of the logarithm, to 10, of tested over
 * predicted, run-outs apart; of another criterion its standard deviation over its mean. NAN where
 * fewer than two count, or one has no life. */
double series_scatter(const series *all, size_t n, const test_run run[], double length);

/* The first criterion, whose scatter it is; whether it is that of lives. */
int series_leading(const series *all, size_t n, const test_run run[], bool *is_of_lives);

/* The critical distance of the least scatter, up to the largest half-width of a contact. NAN, with
 * the complaint, where there is none: the scatter is least at the surface, or at the far end. */
double series_fit_length(const series *all, size_t n, const test_run run[], complaint *why);

#endif
