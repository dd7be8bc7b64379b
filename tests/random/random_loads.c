/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Realistic loads at random: uniform bytes for targets/any_history.c, which says what loads these
 * are.
 *
 *     random_loads HISTORIES [SEED]
 *
 * The exit status is 1 if more than one load in 1000 does not converge, or if one takes more than
 * LONGEST seconds of the processor. */
#include "targets/any_history.c"

enum { BYTES = 256, LOADS_PER_UNSOLVED = 1000 };

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
static const double LONGEST = 200;
#else
static const double LONGEST = 5;
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
    return tally.unsolved > tally.loads / LOADS_PER_UNSOLVED || tally.slowest > LONGEST;
}
