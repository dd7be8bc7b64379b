/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every public function as a call of doubles, for tests that try them all with whatever arguments.
 * The functions and the domains are those of bindings/interface's entries.h; beside them are some
 * sequences of calls. */
#ifndef CALLS_H
#define CALLS_H

#include "entries.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { CALL_ARGUMENTS = 128, CALL_OUTPUTS = 256 };

/* Numbers of an array, 3 unless set before all else; of one of two sizes, 2 times 2. */
extern int array_size;

typedef struct {
    const char *name;
    int arguments;                                  /* how many numbers it takes */
    const entry_argument *argument[CALL_ARGUMENTS]; /* the domain of each */
    int outputs;                                    /* how many numbers it gives */
    uint32_t also_allowed; /* statuses, as bits, that arguments in the domain may have too */
    bool may_be_infinite;
    bool gives_anything; /* numbers that say nothing by themselves */

    const entry *entry; /* NULL, or the function; else it is a sequence: */
    int32_t (*make)(const double v[], double out[]);
} public_call;

/* All calls. */
const public_call *public_calls(size_t *count);

/* Whether an argument is in its domain by itself. */
bool is_sound(const entry_argument *a, double v);

/* Arguments in the domain, mostly of the order of 1; the same on every machine. */
void draw_inside(const public_call *call, uint64_t *state, double v[]);

/* What is wrong with a call's answer, by the header's rules for errors: NULL if nothing. Calls
 * it. */
const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status);

/* What is wrong with the answers to calls in which one pointer is NULL: NULL if nothing. v are
 * arguments of the domain. */
const char *complaint_about_null(const public_call *call, const double v[]);

/* The number of edges of an argument's domain, on both sides of it, and the i-th of them. */
size_t edge_count(const entry_argument *a);
double edge(const entry_argument *a, size_t i);

#endif
