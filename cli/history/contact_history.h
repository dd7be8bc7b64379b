/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact and the loads it goes through, once or again and again. */
#ifndef CLI_CONTACT_HISTORY_H
#define CLI_CONTACT_HISTORY_H

#include "contact/load_history.h"
#include "model/contact_case.h"

enum { OPTION_CYCLES = OPTION_AFTER_LOADS, OPTION_UNTIL, OPTION_AFTER_HISTORY };

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE, after that of the inputs. */
extern struct poptOption history_option_table[];

/* How often a command goes through the loads where --cycles is not given. */
typedef struct {
    int64_t cycles;
    int64_t of_two; /* through two loads, to and fro; 0 where that makes no difference */
} usual_cycles;

typedef struct {
    contact_case setup;
    load_history before; /* applied once, before the first cycle; perhaps none */
    load_history loads;
    int64_t cycles; /* how often the table is gone through */
    size_t steps;   /* how many loads are applied: all, or with --until those before the first that
                       cannot be */
    double error;   /* the largest rwedge_contact_error() after any of them */
} contact_history;

/* Reads the options, and a file that stands in place of --history, and tries every load: a load
 * that cannot be applied ends the command, unless --until is given. Beside a file, --load gives
 * loads before the first cycle. */
void contact_history_read(const arguments *line, char decimal_sign, usual_cycles usage,
                          contact_history *history);

/* The file the loads come from; NULL where there is none. */
const char *history_file(const arguments *line);

/* The row of the table that the load of this step stands in. */
size_t contact_history_row(const contact_history *history, size_t step);
load contact_history_load(const contact_history *history, size_t step);

/* The contact before its first cycle. */
rwedge_contact *contact_history_begin(const contact_history *history);

/* Applies the load of a step, which has been tried. */
void contact_history_go_on(const contact_history *history, size_t step, rwedge_contact *contact);

#endif
