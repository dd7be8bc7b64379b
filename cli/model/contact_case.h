/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One contact and its load, from the texts that give it. */
#ifndef CLI_CONTACT_CASE_H
#define CLI_CONTACT_CASE_H

#include "loads.h"
#include "pad/pad.h"

typedef struct {
    double E1, nu1, E2, nu2; /* E2 is HUGE_VAL where body 2 is rigid */
    pad shape;
    double P, M, Q, sigma, f;
    double k;         /* NAN where not given */
    double A;         /* composite compliance */
    double beta;      /* Dundurs' second constant */
    double tolerance; /* as the texts have it */
    /* the contact that a history has brought to these loads; NULL: the loads came as
     * loads_apply_monotonic() has them */
    const rwedge_contact *after;
} contact_case;

/* What must be given beside the bodies and their shape. */
typedef enum {
    CASE_LOADS_APART, /* nothing: a history has the loads, and f may be 0 */
    CASE_OF_HISTORY,  /* f: a history has the loads */
    CASE_WITH_LOADS,  /* P */
    CASE_OF_SOLVE     /* P; f too where Q, sigma or a yield stress is: 0 would look like a result */
} case_needs;

/* Checks which inputs are given. False, with the complaint, where two exclude each other, or a
 * needed one is missing. */
bool case_is_complete(const input_texts *texts, case_needs needs, char complaint[COMPLAINT_SIZE]);

/* Reads a case; loads and f are 0 where they are not given. False, with the complaint, where a
 * value is wrong. */
bool case_read(const input_texts *texts, case_needs needs, contact_case *setup,
               char complaint[COMPLAINT_SIZE]);

/* Makes the contact of a case, without loads; returns the library's status. Destroy the contact
 * also after an error. */
int32_t case_contact(const contact_case *setup, rwedge_contact **contact);

/* Makes the contact under the loads of the case. */
int32_t case_loaded(const contact_case *setup, rwedge_contact **contact);

/* What is wrong with the loads of a case; nothing where they can be applied. */
load_fault case_fault(const contact_case *setup);

load case_load(const contact_case *setup);

/* Q/(fP), of magnitude 1 at the most; 0 where f or Q is. */
double case_shear_ratio(const contact_case *setup);

#endif
