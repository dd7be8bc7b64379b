/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact is given by, one at a time: its names as option and as column, its domain, and
 * how its text is read. */
#ifndef CLI_INPUTS_H
#define CLI_INPUTS_H

#include "options/arguments.h"

enum {
    INPUT_E1,
    INPUT_NU1,
    INPUT_E2,
    INPUT_NU2,
    INPUT_THETA,
    INPUT_THETA_DEG,
    INPUT_A,
    INPUT_RADIUS,
    INPUT_P, /* the loads, up to sigma */
    INPUT_M,
    INPUT_Q,
    INPUT_SIGMA,
    INPUT_F,
    INPUT_K,
    INPUT_YIELD_STRESS,
    INPUT_COUNT
};

/* The numbers of their options; those of a command that has them start after the last. */
enum { OPTION_INPUT = OPTION_OWN, OPTION_AFTER_INPUTS = OPTION_INPUT + INPUT_COUNT };

/* For a command's own table, by POPT_ARG_INCLUDE_TABLE: the contact and its loads; its strength. */
extern struct poptOption input_option_table[], strength_option_table[];

/* Texts from the command line and from the cells of a row, whose decimal sign may be a comma. */
typedef struct {
    const char *text[INPUT_COUNT]; /* NULL where not given; an empty cell is as good as none */
    bool is_cell[INPUT_COUNT];
    char cell_decimal_sign;
} input_texts;

/* What is wrong with the inputs: the line of a message, or the error of a row. */
enum { COMPLAINT_SIZE = 400, INPUT_NAME_SIZE = 16 };

/* The name of its column, "theta_deg". */
const char *input_column(int input, char name[INPUT_NAME_SIZE]);

/* The other input that gives the same, as radius gives a; -1 where there is none. */
int input_alternative(int input);

/* Its name as where its text came from spells it: "theta_deg" or "--theta-deg". */
const char *input_name(const input_texts *given, int input, char name[INPUT_NAME_SIZE]);

/* Those on a command line. */
void input_texts_from_options(const arguments *given, input_texts *texts);

/* Whether a text is there; an empty cell is none. */
bool input_is_given(const input_texts *given, int input);

/* Reads one that is given. False, with the complaint, where it is not in its domain. E2 may be
 * HUGE_VAL, "inf". */
bool input_read(const input_texts *given, int input, double *value, char complaint[COMPLAINT_SIZE]);

#endif
