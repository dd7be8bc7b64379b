/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the claims of a program, or those whose names fit a pattern:
 *
 *     PROGRAM [CASES [SEED]] [PATTERN]
 *
 * with so many random cases, from that seed, where a claim draws them. */
#include "claims.h"

#include <stdio.h>
#include <stdlib.h>

static long asked[2]; /* cases, seed; 0 where the command says nothing */

long cases_or(long usual)
{
    return asked[0] > 0 ? asked[0] : usual;
}

uint64_t seed_or(uint64_t usual)
{
    return asked[1] > 0 ? (uint64_t)asked[1] : usual;
}

int main(int argc, char **argv)
{
    for (int i = 1, numbers = 0; i < argc; i++) {
        char *end;
        const long number = strtol(argv[i], &end, 10);
        if (*end != '\0')
            cmocka_set_test_filter(argv[i]);
        else if (number > 0 && numbers < 2)
            asked[numbers++] = number;
        else {
            fprintf(stderr, "usage: %s [CASES [SEED]] [PATTERN], both numbers from 1\n", argv[0]);
            return 2;
        }
    }
    return run_claims();
}
