/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Zeros enclosed by Newton's method. A function returns value and slope over a ball. */
#ifndef ROOT_HPP
#define ROOT_HPP

#include "balls/ball.hpp"

struct value_slope {
    ball value, slope;
};

/* Newton's method without proof: a guess to about the square root of the precision. */
template <typename Function> ball improved(const ball &guess, const Function &function)
{
    ball x = midpoint(guess);
    for (int i = 0; i < 12; i++) {
        const value_slope at = function(x);
        const ball step = midpoint(at.value / at.slope);
        if (!is_finite(step))
            break;
        x = midpoint(x - step);
        if (abs(step) <= abs(x) && is_small(step, x, bits / 2))
            break;
    }
    return x;
}

/* A zero near the guess: Newton's method, the last step with the derivative over a whole
 * neighbourhood, which proves that there is one and that it is where it says. False where none
 * is proved. The neighbourhoods tried are small beside the width. */
template <typename Function>
bool find_zero(ball *zero, const ball &guess, double width, const Function &function)
{
    const ball centre = improved(guess, function), value = function(centre).value;
    for (slong n = bits / 2; n > 0; n -= bits / 8) {
        const ball neighbourhood = widened(centre, scaled(width, -n));
        *zero = centre - value / function(neighbourhood).slope;
        if (contains(neighbourhood, *zero))
            return true;
    }
    return false;
}

#endif
