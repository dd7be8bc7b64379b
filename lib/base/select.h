/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Selects one of two values by the sign of a third. Both values are computed.
 *
 * A file whose loops are to become vector instructions defines RW_VECTORS before it includes this.
 * Then the bits are masked. A condition would be in the way: compilers move into its branches what
 * only one of them needs, and a loop with branches stays a loop of single numbers. In other files a
 * condition is used, because it is quicker. */
#ifndef RW_SELECT_H
#define RW_SELECT_H

#include <stdint.h>
#include <string.h>

/* Functions that must become part of the loop around them. Otherwise the compiler makes no vector
 * instructions of the loop. */
#if defined(__GNUC__)
#define RW_INLINE static inline __attribute__((always_inline))
#else
#define RW_INLINE static inline
#endif

RW_INLINE uint64_t rw_bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

RW_INLINE double rw_double_of(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* yes where sign < 0, else no. Not for the sign -0. */
RW_INLINE double rw_if_negative(double sign, double yes, double no)
{
#ifdef RW_VECTORS
    const uint64_t otherwise = (rw_bits_of(sign) >> 63) - 1; /* all bits, or none */
    return rw_double_of((rw_bits_of(yes) & ~otherwise) | (rw_bits_of(no) & otherwise));
#else
    return sign < 0 ? yes : no;
#endif
}

/* Branches in place of calls: fmax() and fmin() have to look for NaN. */
RW_INLINE double rw_larger(double a, double b)
{
    return a > b ? a : b;
}

RW_INLINE double rw_smaller(double a, double b)
{
    return a < b ? a : b;
}

#endif
