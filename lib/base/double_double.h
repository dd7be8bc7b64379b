/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of twice the digits: each is a sum of two doubles that is not added up (Dekker 1971).
 * They are used where a formula cancels and no better one is known. The relative error of each
 * operation is below 2^-100, as long as nothing over- or underflows. */
#ifndef RW_DOUBLE_DOUBLE_H
#define RW_DOUBLE_DOUBLE_H

#include <math.h>

typedef struct {
    double hi, lo;
} rw_dd;

static inline rw_dd rw_dd_from(double a)
{
    return (rw_dd){a, 0};
}

/* a + b exactly. */
static inline rw_dd rw_dd_sum(double a, double b)
{
    const double hi = a + b, part = hi - a;
    return (rw_dd){hi, (a - (hi - part)) + (b - part)};
}

/* a b exactly: each factor in two halves of 26 bits. */
static inline rw_dd rw_dd_product(double a, double b)
{
    const double SPLIT = 0x1p27 + 1;
    const double ta = SPLIT * a, tb = SPLIT * b;
    const double a1 = ta - (ta - a), b1 = tb - (tb - b), a2 = a - a1, b2 = b - b1;
    const double hi = a * b;
    return (rw_dd){hi, ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2};
}

static inline rw_dd rw_dd_add(rw_dd a, rw_dd b)
{
    const rw_dd s = rw_dd_sum(a.hi, b.hi), t = rw_dd_sum(a.lo, b.lo);
    const rw_dd u = rw_dd_sum(s.hi, s.lo + t.hi);
    return rw_dd_sum(u.hi, u.lo + t.lo);
}

static inline rw_dd rw_dd_sub(rw_dd a, rw_dd b)
{
    return rw_dd_add(a, (rw_dd){-b.hi, -b.lo});
}

static inline rw_dd rw_dd_mul(rw_dd a, rw_dd b)
{
    const rw_dd p = rw_dd_product(a.hi, b.hi);
    return rw_dd_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline rw_dd rw_dd_div(rw_dd a, rw_dd b)
{
    const double first = a.hi / b.hi;
    const rw_dd rest = rw_dd_sub(a, rw_dd_mul(b, rw_dd_from(first)));
    const double second = rest.hi / b.hi;
    const rw_dd last = rw_dd_sub(rest, rw_dd_mul(b, rw_dd_from(second)));
    return rw_dd_add(rw_dd_sum(first, second), rw_dd_from(last.hi / b.hi));
}

/* a > 0. */
static inline rw_dd rw_dd_sqrt(rw_dd a)
{
    const double root = sqrt(a.hi);
    const rw_dd rest = rw_dd_sub(a, rw_dd_product(root, root));
    return rw_dd_sum(root, rest.hi / (2 * root));
}

#endif
