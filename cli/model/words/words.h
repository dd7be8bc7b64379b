/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_WORDS_H
#define CLI_WORDS_H

#include "model/model.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- case_words ---- What a case file has: names, in groups. A name that is none is an error. */

/* The version that a file says, as "rwedge_case": 1. A change that older readers would understand
 * wrongly counts it up. */
enum { CASE_VERSION = 1 };
extern const char case_version_name[];

typedef enum {
    WORD_QUANTITY, /* a number, or a text with its unit; of loads a list of numbers too */
    WORD_NUMBERS,  /* a list */
    WORD_TEXT,
    WORD_FLAG
} word_kind;

typedef struct {
    const char *group;  /* "bodies", "pad", "loads"; "" where it stands in none */
    const char *name;   /* as a column has it */
    const char *option; /* of the tool, without dashes; NULL for none */
    word_kind kind;
    int input; /* INPUT_COUNT where it is none */
} case_word;

size_t case_word_count(void);
const case_word *case_word_of(size_t i);

/* The word of a name in a group. NULL, with the complaint, which tells the nearest, or all. */
const case_word *case_word_find(const char *group, const char *name, complaint *why);

/* Whether that is a group: "bodies", "pad", "loads". */
bool case_group_exists(const char *name);

/* Whether a file of that version can be read: of a number that is not there, NAN. False, with the
 * complaint. */
bool case_version_check(double version, complaint *why);

#endif
