/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inputs of a contact as options of a command. */
#ifndef CLI_INPUT_OPTIONS_H
#define CLI_INPUT_OPTIONS_H

#include "model/inputs.h"
#include "options/arguments.h"

/* The numbers of their options; those of a command that has them start after the last. */
enum {
    OPTION_INPUT = OPTION_OWN,
    OPTION_HULL = OPTION_INPUT + INPUT_COUNT,
    OPTION_EXACT,
    OPTION_TOLERANCE,
    OPTION_AFTER_INPUTS
};

/* An entry of a command's own table. */
#define HULL_OPTION                                                                                \
    "hull", '\0', POPT_ARG_NONE, NULL, OPTION_HULL,                                                \
        "Take the convex hull of the heights of a profile", NULL

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE: the contact and its loads; its strength;
 * how loads without a closed form are taken. The first two are empty before the first call of
 * input_options_prepare(). */
extern struct poptOption input_option_table[], strength_option_table[], exactness_option_table[];

/* Fills the tables with the words of the inputs. */
void input_options_prepare(void);

/* Those on a command line; reads the profile. An impossible tolerance is a mistake. */
void input_texts_from_options(const arguments *line, input_texts *texts);

/* Refuses --hull without a profile. */
void input_options_check_hull(const arguments *line);

#endif
