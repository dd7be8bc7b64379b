/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact and the loads it goes through, once or again and again. */
#ifndef CLI_COURSE_H
#define CLI_COURSE_H

#include "contact/load_table.h"
#include "model/contact_case.h"

enum { OPTION_CYCLES = OPTION_AFTER_LOADS, OPTION_UNTIL, OPTION_AFTER_COURSE };

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE, after that of the inputs. */
extern struct poptOption course_option_table[];

/* How often a command goes through the loads where --cycles is not given. */
typedef struct {
    int64_t cycles;
    int64_t of_two; /* through two loads, to and fro; 0 where that makes no difference */
} course_usage;

typedef struct {
    contact_case what;
    load_table before; /* applied once, before the first cycle; perhaps none */
    load_table loads;
    int64_t cycles; /* how often the table is gone through */
    size_t steps;   /* how many loads are applied: all, or with --until those before the first that
                       cannot be */
    double error;   /* the largest rwedge_contact_error() after any of them */
} course;

/* Reads the options, and a file that stands in place of --history, and tries every load: a load
 * that cannot be applied ends the command, unless --until is given. Beside a file, --load gives
 * loads before the first cycle. */
void course_read(const arguments *given, char decimal_sign, course_usage usage, course *whole);

/* The file the loads come from; NULL where there is none. */
const char *course_file(const arguments *given);

/* The row of the table that the load of this step stands in. */
size_t course_row(const course *whole, size_t step);
load course_load(const course *whole, size_t step);

/* The contact before its first cycle. */
rwedge_contact *course_begin(const course *whole);

/* Applies the load of a step, which has been tried. */
void course_go_on(const course *whole, size_t step, rwedge_contact *contact);

#endif
