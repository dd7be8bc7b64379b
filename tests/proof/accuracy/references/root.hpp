/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Zeros enclosed by Newton's method: where two functions of two numbers are 0, or one of one. A
 * function returns its values and slopes over a ball. */
#ifndef ROOT_HPP
#define ROOT_HPP

#include "balls/ball.hpp"

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

/* The zero near a guess, by Newton's method; that operator proves that there is one and that it is
 * where it says. Unknown where none is proved. The neighbourhoods tried are small beside the
 * width. */
template <typename Function>
column find_zero(const column &guess, double width, const Function &function)
{
    column x = guess;
    square A;
    for (int i = 0; i < 12; i++) {
        const residual at = function(x);
        A = inverse_of(at.J);
        const column step = A * at.F;
        const ball length = max(abs(step.x), abs(step.y));
        if (!(length < width))
            return {unknown(), unknown()};
        x = midpoint(x - step);
        if (middle(length) < ldexp(width, -(int)bits / 2))
            break;
    }
    const column AF = A * function(x).F;
    for (slong n = bits / 2; n > 0; n -= bits / 8) {
        const ball reach = scaled(width, -n);
        const column X = {widened(x.x, reach), widened(x.y, reach)};
        const column zero = krawczyk(x, AF, A, function(X).J, X);
        if (abs(zero.x - x.x) < reach && abs(zero.y - x.y) < reach)
            return zero;
    }
    return {unknown(), unknown()};
}

/* ---- One function of one number ---- */

struct value_slope {
    ball value, slope;
};

/* The other number is 0. */
template <typename Function>
ball find_zero(const ball &guess, double width, const Function &function)
{
    const auto both = [&](const column &z) -> residual {
        const value_slope at = function(z.x);
        return {{at.value, z.y}, {at.slope, 0, 0, 1}};
    };
    return find_zero(column{midpoint(guess), 0}, width, both).x;
}

#endif
