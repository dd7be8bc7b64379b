/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A load, how it is applied, and what is wrong with it where it cannot be. */
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

/* What is wrong with a load: which of its four numbers, INPUT_COUNT for none of them, and the rest
 * of the sentence about it. */
typedef struct {
    int input;
    char why[COMPLAINT_SIZE - 100]; /* a name and a text have room in front of it */
    int32_t status;                 /* of the library */
} load_fault;

/* What is wrong with a load that the contact has refused with this status. The contact is as before
 * the load. */
load_fault loads_fault(int32_t status, load to, double f, const rwedge_contact *contact);

/* Applies the next load of a history. False, with the reason, where the contact refuses it; the
 * contact is then as before. */
bool loads_apply_next(load to, double f, rwedge_contact *contact, char complaint[COMPLAINT_SIZE]);

#endif
