/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/contact.hpp"

#include "references/root.hpp"

angle angle_of(const ball &a, const ball &b)
{
    /* a ball of numbers below 1 may be rounded to one that contains more */
    const ball alpha = min(a / b, 1), c0 = sqrt((1 - alpha) * (1 + alpha));
    return {atan2(alpha, c0), c0};
}

/* for a > b c0 is 0 */
static ball force_at(const angle &at, const ball &a, const ball &b)
{
    return b * (at.phi0 / (a / b) + at.c0);
}

ball force(const ball &a, const ball &b)
{
    return is_zero(a) ? 2 * b : force_at(angle_of(a, b), a, b);
}

namespace
{

/* Eq. (14): -(2/pi) arcosh(c/x). */
ball sharp_pressure(const ball &c, const ball &x) { return -2 / pi() * acosh(c / x); }

/* Eq. (8) in the algebraic form of its sines: with s = cos(phi), over c, 1/pi of
 * 2 ln((c0 x + a s)/(c0 + s)) + ((x - a)/a) ln((c0 x + a s)^2/|a^2 - x^2|) - 2 phi0 s/a. */
ball rounded_pressure(const ball &a, const ball &c, const ball &x)
{
    const angle tip = angle_of(a, c);
    const ball s = angle_of(x, c).c0, S = tip.c0 * x + a * s, past = x - a;
    const ball flank = is_zero(past) ? 0 : past / a * log(sqr(S) / abs((x + a) * past));
    return (2 * log(S / ((tip.c0 + s) * c)) + flank - 2 * tip.phi0 * s * c / a) / pi();
}

/* Eq. (12): -sqrt(c^2-x^2)/a. */
ball hertz_pressure(const ball &a, const ball &c, const ball &x)
{
    return -sqrt((c - x) * (c + x)) / a;
}

} // namespace

ball half_width(const ball &a, const ball &wanted, double guess)
{
    const auto too_much = [&](const ball &b) -> value_slope {
        if (is_zero(a))
            return {2 * b - wanted, 2};
        const angle at = angle_of(a, b);
        return {force_at(at, a, b) - wanted, 2 * at.phi0 * b / a};
    };
    ball b;
    return find_zero(&b, guess, guess, too_much) ? b : unknown();
}

ball pressure(const ball &a, const ball &c, const ball &x)
{
    const ball right = abs(x);
    if (right >= c)
        return 0;
    if (!(right < c))
        return unknown();
    if (a >= c)
        return hertz_pressure(a, c, right);
    return is_zero(a) ? sharp_pressure(c, right) : rounded_pressure(a, c, right);
}
