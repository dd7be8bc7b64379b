/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The verdict: a summary of all results of a contact. */
#ifndef CLI_VERDICT_H
#define CLI_VERDICT_H

#include "results.h"

typedef struct {
    const char *colour; /* green, amber or red */
    char strength[400]; /* one sentence or two: by which factor it is elastic, where it yields */
    double factor;      /* the one that counts, of the first sentence; NAN where there is none */
    char text[1200];    /* its state in a word, and what is doubtful */
} verdict;

/* The style of its sentences. */
typedef struct {
    char decimal_sign;
    const char *length; /* the unit, or "" */
} verdict_style;

/* The verdict goes by the yield factor of the present loads; where that is not computed, by full
 * sliding. */
verdict verdict_of(const results *answer, verdict_style style);

/* The verdict on a contact that the library refuses with this status; RWEDGE_OK means that its
 * inputs are wrong. */
verdict verdict_of_fault(int32_t status, const char *complaint);

#endif
