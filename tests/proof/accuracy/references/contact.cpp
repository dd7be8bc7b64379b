/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/contact.hpp"

#include "references/root.hpp"

ball half_width(const ball &a, const ball &wanted, double guess)
{
    const auto too_much = [&](const ball &b) -> value_slope {
        const patch p(a, b);
        return {p.load() - wanted, 2 * p.arc()};
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
