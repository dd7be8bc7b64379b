/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of every function of the header, for comparison bit by bit: between compilers
 * (print_bits.c) and between threads (test_threads.c). */
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

/* Receives the results one after the other. */
typedef void receiver(void *context, const char *what, double value);

/* The arguments are those of a number, 0, 1, ...; results of "fit" are LAPACK's. */
void every_function(const shared_handles *shared, int number, receiver *receive, void *context);

#endif
