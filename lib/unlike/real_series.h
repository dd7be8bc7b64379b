/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A series with real coefficients at a complex place needs no complex product a term: it is divided
 * by z^2 - 2 Re(z) z + |z|^2. */
#ifndef RW_REAL_SERIES_H
#define RW_REAL_SERIES_H

#include "potential/batch.h"

/* Places, or values at them, of so many points at once; a loop over them becomes vectors. */
typedef struct {
    double re[RW_LANES], im[RW_LANES];
} rw_complex_lanes;

/* sum c_k z^k, k < terms, in the first `lanes`. */
RW_INLINE void rw_real_series(int lanes, int terms, const double c[], const rw_complex_lanes *z,
                              rw_complex_lanes *sum)
{
    double twice[RW_LANES], size[RW_LANES], b[RW_LANES] = {0}, before[RW_LANES] = {0};
    for (int i = 0; i < lanes; i++) {
        twice[i] = 2 * z->re[i];
        size[i] = z->re[i] * z->re[i] + z->im[i] * z->im[i];
    }
    for (int k = terms - 1; k > 0; k--)
        for (int i = 0; i < lanes; i++) {
            const double next = (c[k] - size[i] * before[i]) + twice[i] * b[i];
            before[i] = b[i];
            b[i] = next;
        }
    for (int i = 0; i < lanes; i++) {
        sum->re[i] = (c[0] - size[i] * before[i]) + z->re[i] * b[i];
        sum->im[i] = z->im[i] * b[i];
    }
}

#endif
