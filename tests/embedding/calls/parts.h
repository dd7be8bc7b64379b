/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of this folder know of each other. */
#ifndef PARTS_H
#define PARTS_H

#include "calls.h"

enum { OBJECTS = 3 /* of each family, which its functions are called with */ };

/* The number in front of the arguments of a function that takes an object. */
extern const entry_argument which_object;

/* Whether any number will do: what comes of it may be refused or not. */
bool may_be_anything(const entry_argument *a);

/* Calls that are made one after the other. The list ends with a name that is NULL. */
typedef struct {
    const char *name;
    const char *kinds; /* a letter for each number */
    int outputs;
    uint32_t allowed; /* statuses, as bits, that numbers of the domain may have */
    int32_t (*make)(const double v[], double out[]);
} sequence;
extern const sequence sequences[];
const entry_argument *argument_of_letter(char letter);

#endif
