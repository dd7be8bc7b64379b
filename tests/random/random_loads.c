/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Realistic loads at random: uniform bytes for targets/any_history.c, which says how these make
 * loads. At most one load in 10^5 does not converge, and none takes more than a second.
 *
 *     random_loads HISTORIES [SEED] */
#include "targets/any_history.h"

#include "input.h"

enum { BYTES = 256 };

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
static const double LONGEST = 60;
#else
static const double LONGEST = 1;
#endif

int main(int argc, char **argv)
{
    const long histories = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t state = argc > 2 ? (uint64_t)strtol(argv[2], NULL, 10) : 1;
    uint8_t bytes[BYTES];
    if (histories < 1 || argc > 3) {
        fprintf(stderr, "usage: random_loads HISTORIES [SEED]\n");
        return 2;
    }
    for (long i = 0; i < histories; i++) {
        for (int k = 0; k < BYTES; k++)
            bytes[k] = (uint8_t)next_random(&state);
        LLVMFuzzerTestOneInput(bytes, BYTES);
    }
    printf("%ld loads, %ld of them computed, %ld did not converge; the slowest took %.2f s, the "
           "largest error is %.1e\n",
           tally.loads, tally.computed, tally.unsolved, tally.slowest, tally.worst);
    return tally.unsolved > tally.loads / 100000 || tally.slowest > LONGEST;
}
