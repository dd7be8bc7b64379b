/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/contact.hpp"

#include "balls/patch.hpp"
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

ball half_width(const ball &a, const ball &wanted, double guess)
{
    const auto too_much = [&](const ball &b) -> value_slope {
        if (is_zero(a))
            return {2 * b - wanted, 2};
        const angle at = angle_of(a, b);
        return {force_at(at, a, b) - wanted, 2 * at.phi0 * b / a};
    };
    return find_zero(guess, guess, too_much);
}

ball pressure(const ball &a, const ball &c, const ball &x)
{
    const ball right = abs(x);
    if (right >= c)
        return 0;
    return right < c ? im(patch(a, c).potential(x)) : unknown();
}
