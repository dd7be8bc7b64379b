/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/maximum.h"

#include "base/domain.h"

void rw_spread_places(double left, double right, double place[RW_SPREAD])
{
    enum { LAST = RW_SPREAD - 1, STEPS = LAST / 2 };
    const double middle = (left + right) / 2, half = (right - left) / 2;
    for (int i = 1; i < LAST; i++)
        place[i] = middle + half * sin(RW_HALF_PI * (i - STEPS) / STEPS);
    place[0] = left;
    place[LAST] = right;
}

/* The interval shrinks around its best place: to a quarter in each round. */
static rw_maximum narrow(rw_function f, const void *context, double from, double to,
                         rw_maximum best)
{
    enum { PARTS = 8, ROUNDS = 17 };
    for (int round = 0; round < ROUNDS; round++) {
        const double step = (to - from) / PARTS;
        for (int i = 1; i < PARTS; i++) {
            const double x = from + i * step, value = f(x, context);
            if (value > best.value)
                best = (rw_maximum){x, value};
        }
        from = fmax(from, best.x - step);
        to = fmin(to, best.x + step);
    }
    return best;
}

static bool is_top(size_t n, const double value[], size_t i)
{
    return (i == 0 || value[i] > value[i - 1]) && (i + 1 == n || value[i] >= value[i + 1]);
}

static double largest_of(size_t n, const double value[])
{
    double largest = value[0];
    for (size_t i = 1; i < n; i++)
        largest = fmax(largest, value[i]);
    return largest;
}

rw_maximum rw_largest_value(rw_function f, const void *context, size_t n, const double place[],
                            double value[])
{
    static const double NEARLY = 0.97; /* such a part of the largest one is looked at */
    enum { SEARCHES = 8 };             /* enough for tops; ripples have more */
    for (size_t i = 0; i < n; i++)
        value[i] = f(place[i], context);
    const double largest = largest_of(n, value);
    rw_maximum best = {place[0], value[0]};
    int searches = 0;
    for (size_t i = 0; i < n; i++) {
        const bool is_high =
            value[i] == largest || (value[i] >= NEARLY * largest && searches < SEARCHES);
        if (!is_high || !is_top(n, value, i))
            continue;
        searches++;
        const rw_maximum start = {place[i], value[i]},
                         top = narrow(f, context, place[i > 0 ? i - 1 : i],
                                      place[i + 1 < n ? i + 1 : i], start);
        best = top.value > best.value ? top : best;
    }
    return best;
}
