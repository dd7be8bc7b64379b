/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A history of loads, in straight steps, as the command line or a CSV file gives it: read whole,
 * and then applied, once or again and again. */
#ifndef CLI_LOAD_HISTORY_H
#define CLI_LOAD_HISTORY_H

#include "model/reading/header.h"
#include "input/csv_row.h"
#include "input_options.h"
#include "model/loads.h"

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE: --load, --history, --encoding, and how
 * exact they are. */
enum {
    OPTION_HISTORY = OPTION_AFTER_INPUTS,
    OPTION_LOAD, /* may be repeated */
    OPTION_AFTER_LOADS
};
extern struct poptOption load_option_table[];

typedef struct {
    const char *name;  /* of the file, as messages call it; NULL where --load gave the loads */
    const char *lines; /* what --load gave, one to a line */
    csv_row first;     /* of the file, and what its columns are */
    header names;
    bool unused[HEADER_COLUMNS]; /* columns with numbers that are not used */
    bool has_mark;               /* whether the file begins with the mark of Unicode */
    load *load;
    csv_row *row; /* of the file, where each stands */
    size_t count;
} load_history;

/* Where the loads come from; a file may be named by a word in place of the option. */
typedef struct {
    const char *file, *list, *encoding; /* NULL where not given */
} history_source;
history_source history_source_of(const arguments *line);
bool history_source_is_given(const history_source *from);

/* Refuses an encoding without a file, or one that iconv does not know. */
void history_source_check_encoding(const history_source *from);

/* Refuses a file beside a list, and loads that the texts give too. */
void history_source_check(const history_source *from, const input_texts *texts);

/* Reads the file or the list. */
void load_history_read(const history_source *from, char decimal_sign, load_history *loads);

/* Columns with numbers that are not used, of a row for a list of warnings; of all, said. */
void load_history_write_unused(const load_history *loads, size_t row, char *text, size_t size);
void load_history_say_unused(const load_history *loads);

/* Applies one load. False, with the complaint, where the contact refuses it; it is as before. */
bool load_history_apply(const load_history *loads, size_t row, double f, rwedge_contact *contact,
                        char complaint[COMPLAINT_SIZE]);

/* Applies them all, in order; the first refusal ends the command. */
void load_history_apply_all(const load_history *loads, double f, rwedge_contact *contact);

/* Ends the command as a load cannot be applied, after a word such as ", cycle 2", or "". */
NO_RETURN void load_history_fail(const load_history *loads, size_t row, const char *word,
                                 const char *complaint);

/* Reads the loads and applies them all, and names columns with numbers that are not used. */
void history_source_apply(const history_source *from, char decimal_sign, double f,
                          rwedge_contact *contact);

/* Where it stands, as messages say it: "loads.csv: line 3". */
enum { LOAD_PLACE_SIZE = 300 };
const char *load_history_place(const load_history *loads, size_t row, char place[LOAD_PLACE_SIZE]);

#endif
