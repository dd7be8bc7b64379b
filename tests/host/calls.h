/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every public function as a call of doubles, with the domain of each argument as the header
 * says it: for tests that try them all with whatever arguments. */
#ifndef CALLS_H
#define CALLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { CALL_ARGUMENTS = 12, CALL_OUTPUTS = 16 };

typedef struct {
    const char *name;
    const char *kinds; /* a letter for each argument: what it is */
    int outputs;       /* how many numbers it gives */
    bool may_be_infinite;
    uint32_t also_allowed; /* statuses, as bits, that arguments in the domain may have too */

    /* A pure formula has the status RWEDGE_EDOMAIN where it gives NaN. Outputs that a status
     * leaves alone are left. */
    int32_t (*make)(const double v[], double out[]);
    bool (*also_in_domain)(const double v[]); /* NULL, or what a domain by argument cannot say */
} public_call;

extern const public_call public_calls[];
extern const size_t public_call_count;

/* Whether the header's domain has these arguments. */
bool is_in_domain(const public_call *call, const double v[]);

/* Whether an argument is in the domain of its kind by itself, or for a ratio that may be
 * refused, will not be. */
bool is_sound(char kind, double v);

/* What is wrong with a call's answer, by the header's rules for errors: NULL if nothing. Calls
 * it. */
const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status);

/* The number of edges of a kind of argument, inside the domain and out, and the i-th of them. */
size_t edge_count(char kind);
double edge(char kind, size_t i);

#endif
