/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the targets share: the fuzzer's bytes taken apart, and claims that end the run where they
 * do not hold. */
#ifndef INPUT_H
#define INPUT_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size); /* libFuzzer's name */

typedef struct {
    const uint8_t *data;
    size_t left;
} input;

/* 0 when there are no more. */
static inline uint8_t take_byte(input *in)
{
    if (in->left == 0)
        return 0;
    in->left--;
    return *in->data++;
}

static inline uint64_t take_bytes(input *in, int count)
{
    uint64_t bytes = 0;
    for (int i = 0; i < count; i++)
        bytes = bytes << 8 | take_byte(in);
    return bytes;
}

/* Any double. */
static inline double take_double(input *in)
{
    const uint64_t bits = take_bytes(in, 8);
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

/* 0 to 1, both included, in 2^16 steps. */
static inline double take_fraction(input *in)
{
    return (double)take_bytes(in, 2) / 65535;
}

/* The same sequence on every machine; *state is any seed. */
static inline uint64_t next_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15)); /* splitmix64 */
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

#define CLAIM(holds, ...)                                                                          \
    do {                                                                                           \
        if (!(holds)) {                                                                            \
            fprintf(stderr, "%s:%d: %s does not hold: ", __FILE__, __LINE__, #holds);              \
            fprintf(stderr, __VA_ARGS__);                                                          \
            fputc('\n', stderr);                                                                   \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

static inline bool are_close(double one, double other, double relative)
{
    return fabs(one - other) <= relative * fmax(fabs(one), fabs(other));
}

#endif
