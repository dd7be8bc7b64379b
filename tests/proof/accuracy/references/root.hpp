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

/* ---- Two numbers that two functions make 0 ---- */

struct column {
    ball x, y;
};

inline column operator+(const column &a, const column &b) { return {a.x + b.x, a.y + b.y}; }

inline column operator-(const column &a, const column &b) { return {a.x - b.x, a.y - b.y}; }

struct square {
    ball xx, xy, yx, yy;

    column operator*(const column &v) const { return {xx * v.x + xy * v.y, yx * v.x + yy * v.y}; }
};

/* The functions, and how they change with the numbers. */
struct residual {
    column F;
    square J;
};

inline column midpoint(const column &v) { return {midpoint(v.x), midpoint(v.y)}; }

/* Of the middles; any numbers near it serve. */
inline square inverse_of(const square &m)
{
    const ball determinant = m.xx * m.yy - m.xy * m.yx;
    return {midpoint(m.yy / determinant), midpoint(-m.xy / determinant),
            midpoint(-m.yx / determinant), midpoint(m.xx / determinant)};
}

/* x - A F(x) + (1 - A J(X)) (X - x), Krawczyk's operator: where it lies inside X there is a zero,
 * and it is there. AF is A F(x). */
inline column krawczyk(const column &x, const column &AF, const square &A, const square &J,
                       const column &X)
{
    const column first = A * column{J.xx, J.yx}, second = A * column{J.xy, J.yy};
    return x - AF + square{1 - first.x, -second.x, -first.y, 1 - second.y} * (X - x);
}

/* The zero near a guess, by Newton's method and that operator. False where none is proved. */
template <typename Function>
bool find_zero(column *zero, const column &guess, double width, const Function &function)
{
    column x = guess;
    square A;
    for (int i = 0; i < 12; i++) {
        const residual at = function(x);
        A = inverse_of(
            {midpoint(at.J.xx), midpoint(at.J.xy), midpoint(at.J.yx), midpoint(at.J.yy)});
        const column step = A * at.F;
        const ball length = max(abs(step.x), abs(step.y));
        if (!(length < width))
            return false;
        x = midpoint(x - step);
        if (middle(length) < ldexp(width, -(int)bits / 2))
            break;
    }
    const column AF = A * function(x).F;
    for (slong n = bits / 2; n > 0; n -= bits / 8) {
        const ball reach = scaled(width, -n);
        const column X = {widened(x.x, reach), widened(x.y, reach)};
        *zero = krawczyk(x, AF, A, function(X).J, X);
        if (abs(zero->x - x.x) < reach && abs(zero->y - x.y) < reach)
            return true;
    }
    return false;
}

#endif
