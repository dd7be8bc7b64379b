/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A history of loads, in straight steps, from the command line or a CSV file. */
#ifndef CLI_LOADS_H
#define CLI_LOADS_H

#include "inputs.h"

#include <rwedge.h>

typedef struct {
    double P, M, Q, sigma;
} load;

/* Applies P and M, then Q and sigma together under constant P and M; returns the library's
 * status. */
int32_t loads_apply_monotonic(load to, rwedge_contact *contact);

/* What is wrong with a load: with which of its four, INPUT_COUNT where with none, and the rest of
 * the sentence about it. */
typedef struct {
    int input;
    char why[COMPLAINT_SIZE - 100]; /* a name and a text have room in front of it */
} load_fault;

/* Of a load that the contact, which is as before, has refused with this status. */
load_fault loads_fault(int32_t status, load to, double f, const rwedge_contact *contact);

/* Applies "P,Q" or "P,M,Q,sigma", one to a line, as --load gave them; returns the exit status. */
int loads_apply_list(const char *lines, double f, rwedge_contact *contact);

/* Applies the rows of a file with the columns P and Q, and perhaps M and sigma, as --history names
 * it; returns the exit status. */
int loads_apply_file(const char *path, const char *encoding, char decimal_sign, double f,
                     rwedge_contact *contact);

#endif
