/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops that are compiled for each kind of processor. */
#ifndef RW_PROCESSOR_H
#define RW_PROCESSOR_H

#include "base/select.h"

#include <stddef.h>

/* Defines a function NAME PARAMETERS, which does LOOP ARGUMENTS for the processor at hand: with
 * vectors of eight or four numbers where it has them. Every x86-64 has vectors of two. LOOP is
 * RW_INLINE. */
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(RW_BASELINE)
#define RW_FOR_PROCESSOR(NAME, LOOP, PARAMETERS, ARGUMENTS, TARGET)                                \
    __attribute__((target(TARGET))) static void NAME PARAMETERS                                    \
    {                                                                                              \
        LOOP ARGUMENTS;                                                                            \
    }
#define RW_DISPATCH(NAME, LOOP, PARAMETERS, ARGUMENTS)                                             \
    RW_FOR_PROCESSOR(NAME##_of_two, LOOP, PARAMETERS, ARGUMENTS, "sse2")                           \
    RW_FOR_PROCESSOR(NAME##_of_four, LOOP, PARAMETERS, ARGUMENTS, "avx2")                          \
    RW_FOR_PROCESSOR(NAME##_of_eight, LOOP, PARAMETERS, ARGUMENTS, "avx512f,avx512dq")             \
    static void NAME PARAMETERS                                                                    \
    {                                                                                              \
        if (__builtin_cpu_supports("avx512dq"))                                                    \
            NAME##_of_eight ARGUMENTS;                                                             \
        else if (__builtin_cpu_supports("avx2"))                                                   \
            NAME##_of_four ARGUMENTS;                                                              \
        else                                                                                       \
            NAME##_of_two ARGUMENTS;                                                               \
    }
#else
#define RW_DISPATCH(NAME, LOOP, PARAMETERS, ARGUMENTS)                                             \
    static void NAME PARAMETERS                                                                    \
    {                                                                                              \
        LOOP ARGUMENTS;                                                                            \
    }
#endif

/* A short loop that is to become vector instructions. GCC would unroll it first, and then make them
 * of a part of it alone. */
#if defined(__GNUC__) && !defined(__clang__)
#define RW_EACH(I, N) _Pragma("GCC unroll 1") for (size_t I = 0; I < (N); I++)
#else
#define RW_EACH(I, N) for (size_t I = 0; I < (N); I++)
#endif

#endif
