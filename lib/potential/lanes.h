/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the loops over many points share: points go by as many as RW_LANES, and the loop is compiled
 * for each kind of processor. */
#ifndef RW_LANES_H
#define RW_LANES_H

#include "base/select.h"
#include "potential/batch.h"

enum { RW_LANES = 8 }; /* a multiple of the numbers in a vector */

/* Defines NAME(potential, count, x, y, fields), which does LOOP for the processor at hand: vectors
 * of eight or four numbers where it has them. Every x86-64 has vectors of two. */
#define RW_PARAMETERS(POTENTIAL)                                                                   \
    const POTENTIAL *p, int count, const double x[], const double y[], rw_fields *fields
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(RW_BASELINE)
#define RW_FOR_PROCESSOR(NAME, LOOP, POTENTIAL, TARGET)                                            \
    __attribute__((target(TARGET))) static void NAME(RW_PARAMETERS(POTENTIAL))                     \
    {                                                                                              \
        LOOP(p, count, x, y, fields);                                                              \
    }
#define RW_BEST_PROCESSOR(NAME, LOOP, POTENTIAL)                                                   \
    RW_FOR_PROCESSOR(NAME##_of_two, LOOP, POTENTIAL, "sse2")                                       \
    RW_FOR_PROCESSOR(NAME##_of_four, LOOP, POTENTIAL, "avx2")                                      \
    RW_FOR_PROCESSOR(NAME##_of_eight, LOOP, POTENTIAL, "avx512f,avx512dq")                         \
    static void NAME(RW_PARAMETERS(POTENTIAL))                                                     \
    {                                                                                              \
        if (__builtin_cpu_supports("avx512dq"))                                                    \
            NAME##_of_eight(p, count, x, y, fields);                                               \
        else if (__builtin_cpu_supports("avx2"))                                                   \
            NAME##_of_four(p, count, x, y, fields);                                                \
        else                                                                                       \
            NAME##_of_two(p, count, x, y, fields);                                                 \
    }
#else
#define RW_BEST_PROCESSOR(NAME, LOOP, POTENTIAL)                                                   \
    static void NAME(RW_PARAMETERS(POTENTIAL))                                                     \
    {                                                                                              \
        LOOP(p, count, x, y, fields);                                                              \
    }
#endif

#endif
