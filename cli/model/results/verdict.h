/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all results of a contact come to. */
#ifndef CLI_VERDICT_H
#define CLI_VERDICT_H

#include "results.h"

typedef struct {
    const char *colour; /* green, amber or red */
    char strength[400]; /* one sentence or two: by which factor it is elastic, where it yields */
    double factor;      /* the one that counts, of the first sentence; NAN where there is none */
    char text[1200];    /* its state in a word, and what is doubtful */
} verdict;

/* How its sentences are written. */
typedef struct {
    char decimal_sign;
    const char *length; /* the unit, or "" */
} verdict_style;

/* The state under the loads as they are counts, by the yield factor; where that is not computed,
 * full sliding does. */
verdict verdict_of(const results *answer, verdict_style style);

/* On a contact that the library refuses with this status, or RWEDGE_OK where its inputs are
 * wrong. */
verdict verdict_of_fault(int32_t status, const char *complaint);

#endif
