/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inputs that define a contact: for each its names as option and as column, its domain, and how
 * its text is read. */
#ifndef CLI_INPUTS_H
#define CLI_INPUTS_H

#include "pad/pad_profile.h"

#include <stdbool.h>

enum {
    INPUT_E1,
    INPUT_NU1,
    INPUT_E2,
    INPUT_NU2,
    INPUT_THETA,
    INPUT_THETA_DEG,
    INPUT_A,
    INPUT_RADIUS,
    INPUT_FLAT,
    INPUT_PROFILE, /* a name, not a number */
    INPUT_P,       /* the loads, up to sigma */
    INPUT_M,
    INPUT_Q,
    INPUT_SIGMA,
    INPUT_F,
    INPUT_K,
    INPUT_YIELD_STRESS,
    INPUT_COUNT
};

typedef struct {
    const char *option, *meaning, *argument; /* as the help of an option has them */
    const char *unit;                        /* the dimension, as that of a result */
    const char *subject;                     /* of a sentence */
    double lo, hi;
    bool open; /* the ends are not in the domain */
    const char *domain;
} input_kind;
extern const input_kind input_kinds[INPUT_COUNT];

/* Texts from options, or from the cells of a row, whose decimal sign may be a comma. */
typedef struct {
    const char *text[INPUT_COUNT]; /* NULL where not given; an empty cell is as good as none */
    bool is_cell[INPUT_COUNT];
    char cell_decimal_sign;
    /* what messages about cells advise: how they may have a decimal comma, "with --decimal-comma";
     * where else inputs are given, "columns or options", or NULL */
    const char *how_comma, *where_else;
    /* the profile of a name; NULL with the complaint where there is none. May itself be NULL */
    const pad_profile *(*profile_named)(const char *name, char complaint[]);
    /* of q over f p0, to which loads without a closed form are computed; 0 refuses them */
    double tolerance;
} input_texts;

/* The tolerance where none is given. */
extern const double usual_tolerance;

/* What is wrong with the inputs: the line of a message, or the error of a row. */
enum { COMPLAINT_SIZE = 400, INPUT_NAME_SIZE = 16 };

/* The name of its column, "theta_deg". */
const char *input_column(int input, char name[INPUT_NAME_SIZE]);

/* The input that is an alternative to this one, as radius is to a; -1 where there is none. */
int input_alternative(int input);

/* The name of an input as the source of its text spells it: "theta_deg" in a file, "--theta-deg" as
 * an option. */
const char *input_name(const input_texts *texts, int input, char name[INPUT_NAME_SIZE]);

/* Whether a text is there; an empty cell is none. */
bool input_is_given(const input_texts *texts, int input);

/* Reads an input that is given. False, with the complaint, where it is outside its domain. E2 may
 * be HUGE_VAL, "inf"; the value of a profile is the number of its places. */
bool input_read(const input_texts *texts, int input, double *value, char complaint[COMPLAINT_SIZE]);

#endif
