/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The coefficients of the paper's series. With m = 2n+1,
 *     b_0 = (2/pi)(phi0 + alpha c0)/alpha,
 *     b_n = (4/pi)(-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)]/(m (m^2-1)),
 * and 4 (-1)^n/(pi m) for the sharp wedge, where the paper prints (-1)^(2n) (E1).
 *
 * There are three losses of digits. The bracket cancels near the zeros of b_n as a function of
 * alpha. It cancels like (1-alpha)^(3/2) near alpha = 1. The product m phi0 loses the digits of m.
 * An integer power of exp(i phi0) in twice the digits avoids all three. */
#include "rwedge.h"

#include "base/domain.h"
#include "base/double_double.h"

typedef struct {
    rw_dd re, im;
} complex_dd;

static complex_dd product(complex_dd a, complex_dd b)
{
    return (complex_dd){rw_dd_sub(rw_dd_mul(a.re, b.re), rw_dd_mul(a.im, b.im)),
                        rw_dd_add(rw_dd_mul(a.re, b.im), rw_dd_mul(a.im, b.re))};
}

static complex_dd power(complex_dd base, uint32_t exponent)
{
    complex_dd result = {rw_dd_from(1), rw_dd_from(0)};
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1)
            result = product(result, base);
        base = product(base, base);
    }
    return result;
}

/* (-1)^n [m sin(m phi0) cot(phi0) - cos(m phi0)]. It uses powers of the smaller one of the angles
 * phi0 and pi/2 - phi0, so that a small sine keeps its relative accuracy. */
static double bracket(double alpha, uint32_t m)
{
    const rw_dd sine = rw_dd_from(alpha);
    const rw_dd cosine = rw_dd_sqrt(rw_dd_mul(rw_dd_sum(1, -alpha), rw_dd_sum(1, alpha)));
    const rw_dd order = rw_dd_from(m);
    if (alpha * alpha < 0.5) {
        const complex_dd e = power((complex_dd){cosine, sine}, m);
        const rw_dd b = rw_dd_sub(rw_dd_div(rw_dd_mul(order, rw_dd_mul(e.im, cosine)), sine), e.re);
        return (m / 2) % 2 == 0 ? b.hi : -b.hi;
    }
    /* angle pi/2 - phi0: the sign (-1)^n drops out */
    const complex_dd e = power((complex_dd){sine, cosine}, m);
    return rw_dd_sub(rw_dd_div(rw_dd_mul(order, rw_dd_mul(e.re, cosine)), sine), e.im).hi;
}

double rwedge_coefficient(double alpha, int32_t n)
{
    /* Where m alpha is below it the bracket is m^2 - 1, with a relative error of its square. */
    static const double SHARP = 1e-9;
    if (!rw_is_magnitude(alpha) || n < 0)
        return NAN;
    if (alpha >= 1)
        return n == 0 ? 1 / alpha : 0;
    if (n == 0)
        return 2 / RW_PI * rwedge_load(alpha);
    const double m = 2.0 * n + 1;
    if (m * alpha < SHARP)
        return (n % 2 == 0 ? 4 : -4) / (RW_PI * m);
    return 4 / RW_PI * bracket(alpha, 2 * (uint32_t)n + 1) / (m * (m * m - 1));
}
