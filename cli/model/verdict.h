/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all results of a contact come to, in one sentence. */
#ifndef CLI_VERDICT_H
#define CLI_VERDICT_H

#include "results.h"

typedef struct {
    const char *colour; /* green, amber or red */
    char text[1200];
} verdict;

/* The state under the loads as they are counts, by the yield factor; where that is not computed,
 * full sliding does. */
verdict verdict_of(const results *answer);

/* On a contact that the library refuses with this status, or RWEDGE_OK where its inputs are
 * wrong. */
verdict verdict_of_fault(int32_t status, const char *complaint);

#endif
