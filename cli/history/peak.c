/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "peak.h"

#include <math.h>

/* The interval shrinks around its best place: to a quarter in each round. */
enum { PARTS = 8, ROUNDS = 17 };

peak peak_between(double from, double to, peak start, peak_function *f, const void *context)
{
    peak best = start;
    for (int round = 0; round < ROUNDS; round++) {
        const double step = (to - from) / PARTS;
        for (int i = 1; i < PARTS; i++) {
            const double x = from + i * step, value = f(context, x);
            if (value > best.value)
                best = (peak){x, value};
        }
        from = fmax(from, best.x - step);
        to = fmin(to, best.x + step);
    }
    return best;
}
