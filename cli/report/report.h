/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_REPORT_H
#define CLI_REPORT_H

#include "fretting/fretting.h"
#include "model/results/results.h"
#include "setup/setup.h"
#include "system/system.h"

/* ---- report_state ---- What a report tells of a case. */

/* The hardest of the loads of a history: the factor on the stress, and where. */
typedef struct {
    double factor, x, y; /* NAN where k is not given */
    size_t load;         /* the first is 1 */
} hardest_load;

typedef struct {
    const arguments *line;
    input_texts texts;
    const char *name;   /* of the case; the name of its file where it has none */
    contact_case setup; /* under its load, or the last of a history */
    results answer;
    results_wanted wanted;
    verdict judged;
    bool has_history, shows_pictures, shows_equations;
    /* of a history */
    contact_history history;
    criteria asked;
    last_cycle last;
    measured places;
    worst_table worst;
    hardest_load hardest;
    doubts doubts; /* of all states */
} report;

/* Reads the case of the options, and computes. */
void report_compute(const arguments *line, report *to);

/* ---- report_units ---- */

/* "N/mm" of "force/length"; "" where no units are said, and of pure numbers. */
enum { UNIT_SIZE = 60 };
void report_unit(const report *from, const char *dimension, char label[UNIT_SIZE]);

/* ---- report_page ---- */

/* The lines of page.html, which the build makes of it; NULL after the last. */
extern const char *const page_lines[];

/* Writes the page. */
void report_write(const report *from, output *out);

#endif
