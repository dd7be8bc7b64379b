/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every public function as a call of doubles, for tests that try them all with whatever arguments.
 * The functions and the domains are those of bindings/interface's entries.h. */
#ifndef CALLS_H
#define CALLS_H

#include "entries.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { CALL_ARGUMENTS = 128, CALL_OUTPUTS = 512 };

/* Numbers of an array, 3 unless set before all else; of one of two sizes, 2 times 2. */
extern int array_size;

typedef struct {
    const entry *entry;
    int arguments;                                  /* how many numbers it takes */
    const entry_argument *argument[CALL_ARGUMENTS]; /* the domain of each */
    int outputs;                                    /* how many numbers it gives */
    uint32_t also_allowed; /* statuses, as bits, that arguments in the domain may have too */
} public_call;

/* Of each family, which its functions are called with. The last contact is computed. A cycle of
 * each contact has two loads. */
enum { OBJECTS = 11, COMPUTED = OBJECTS - 1, HELD = OBJECTS - 2, OBJECT_LOADS = 2 };

/* The number in front of the arguments of a function that takes an object. */
extern const entry_argument which_object;

/* The object of that number; it lives as long as the program. */
void *object_of(const entry *e, double number);

/* NULL, or what is told when the library begins to be called, and when it has returned. */
extern void (*on_call)(bool begins);

/* All calls: ENTRY_COUNT. */
const public_call *public_calls(void);

/* Arguments in the domain, mostly of the order of 1; the same on every machine. */
void draw_inside(const public_call *call, uint64_t *state, double v[]);
double draw_number(const entry_argument *a, uint64_t *state); /* one of them */
double draw_argument(const entry *e, int j, uint64_t *state); /* with which there is a result */

/* How many numbers there are of a size that is no argument: for the criterion that is drawn. */
size_t implied_count(const entry *e, int size);

/* The constants of that criterion, n of them, in their ranges, where the argument is such. */
void draw_constants(const entry *e, int j, size_t n, double v[]);

/* What is wrong with a call's answer, by the header's rules for errors: NULL if nothing. Calls it.
 * A call that is refused changes neither its outputs nor its object. */
const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status);

/* What is wrong with the answers to calls in which one pointer is NULL: NULL if nothing. v are
 * arguments of the domain. */
const char *complaint_about_null(const public_call *call, const double v[]);

/* The number of edges of an argument's domain, on both sides of it, and the i-th of them. The
 * computed contact is not among the objects, as it takes its time. */
size_t edge_count(const entry_argument *a);
double edge(const entry_argument *a, size_t i);

#endif
