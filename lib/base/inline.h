/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that must become part of the loop around them. Otherwise the compiler makes no vector
 * instructions of the loop. */
#ifndef RW_INLINE_H
#define RW_INLINE_H

#if defined(__GNUC__)
#define RW_INLINE static inline __attribute__((always_inline))
#else
#define RW_INLINE static inline
#endif

#endif
