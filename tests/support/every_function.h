/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of every function of the header, for comparison bit by bit: between compilers
 * (print_bits.c) and between threads (test_threads.c). The functions and the domains of their
 * arguments are those of bindings/interface's entries.h: no function is listed by hand. */
#ifndef EVERY_FUNCTION_H
#define EVERY_FUNCTION_H

#include "rwedge.h"

#include <stdbool.h>

/* Handles that all threads read. */
typedef struct {
    rwedge_contact *contact;
    rwedge_series *series;
} shared_handles;

bool shared_create(shared_handles *shared);
void shared_destroy(shared_handles *shared);

/* Receives the results one after the other, each with the name of its function without rwedge_. A
 * call gives its status first, RWEDGE_OK for a function that has none, and then the numbers. */
typedef void receiver(void *context, const char *function, bool is_status, double value);

/* The arguments are those of a number, 0, 1, ... */
void every_function(const shared_handles *shared, int number, receiver *receive, void *context);

/* The i-th of the functions, NULL after the last; `function` is one of these texts. */
const char *function_of(int i);

#endif
