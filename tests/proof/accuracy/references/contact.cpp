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

/* (x X - L - max(x - alpha, 0)^2)/(2 alpha), L = arcosh x, X = sqrt(x^2-1): Hertz. */
ball hertz_gap(const ball &alpha, const ball &x, const ball &X, const ball &L)
{
    return (x * X - L - sqr(max(x - alpha, 0))) / (2 * alpha);
}

/* x - int G dx, int G = x G - (2/(pi alpha)) [(x^2-alpha^2) M/2 - alpha c0 L/2 - phi0 (x X +
 * L)/2], which is 1 at x = 1, with G = (2/pi) [atan(c0/X) + x M/alpha - phi0 X/alpha] and M =
 * atan(tan(phi0) X/x): in all x - (2/pi) [x atan(c0/X) + (x^2+alpha^2) M/(2 alpha) + c0 L/2 -
 * phi0 (x X - L)/(2 alpha)]. */
ball rounded_gap(const ball &alpha, const ball &x, const ball &X, const ball &L)
{
    const angle tip = angle_of(alpha, 1);
    const ball M = atan2(alpha * X, tip.c0 * x);
    const ball rest = (sqr(x) + sqr(alpha)) * M - (x * X - L) * tip.phi0;
    return x - 2 / pi() * (x * atan2(tip.c0, X) + (rest / alpha + tip.c0 * L) / 2);
}

/* alpha -> 0: x - (2/pi) [x atan(1/X) + L]. */
ball sharp_gap(const ball &x, const ball &X, const ball &L)
{
    return x - 2 / pi() * (x * atan(1 / X) + L);
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

ball gap_of(const ball &a, const ball &width, const ball &place)
{
    const ball x = place / width;
    if (!(x > 1))
        return 0;
    const ball X = sqrt((x - 1) * (x + 1)), L = asinh(X), alpha = a / width;
    return width * (is_zero(a)  ? sharp_gap(x, X, L)
                    : a < width ? rounded_gap(alpha, x, X, L)
                                : hertz_gap(alpha, x, X, L));
}
