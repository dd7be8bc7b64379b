/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One contact and its load, from the texts that give it. */
#ifndef CLI_CONTACT_CASE_H
#define CLI_CONTACT_CASE_H

#include "inputs.h"

typedef struct {
    double E1, nu1, E2, nu2; /* E2 is HUGE_VAL where body 2 is rigid */
    double theta, a, P, Q, f;
    double k;    /* NAN where not given */
    double A;    /* composite compliance */
    double beta; /* Dundurs' second constant */
} contact_case;

/* Whether inputs exclude each other, or one that is needed is missing; P counts as needed where
 * needs_load is true. */
bool case_is_complete(const input_texts *given, bool needs_load, char complaint[COMPLAINT_SIZE]);

/* Reads it; P and Q are 0 where they are not given. False, with the complaint. */
bool case_read(const input_texts *given, bool needs_load, contact_case *what,
               char complaint[COMPLAINT_SIZE]);

/* Q/(fP), of magnitude 1 at the most; 0 where f or Q is. */
double case_shear_ratio(const contact_case *what);

#endif
