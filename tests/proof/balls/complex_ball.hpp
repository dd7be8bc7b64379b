/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complex numbers of ball arithmetic, like ball.hpp. A real number beside one is taken for complex:
 * Arb skips a part that is 0. */
#ifndef COMPLEX_BALL_HPP
#define COMPLEX_BALL_HPP

#include "balls/ball.hpp"

struct complex_ball : number<acb_struct> {
    complex_ball() = default;
    complex_ball(const ball &real) { acb_set_arb(raw(), real.raw()); }
    complex_ball(double real) { acb_set_d(raw(), real); }
    complex_ball(const ball &real, const ball &imaginary)
    {
        acb_set_arb_arb(raw(), real.raw(), imaginary.raw());
    }
};

inline complex_ball operator+(const complex_ball &x, const complex_ball &y)
{
    return rounded(acb_add, x, y);
}
inline complex_ball operator-(const complex_ball &x, const complex_ball &y)
{
    return rounded(acb_sub, x, y);
}
inline complex_ball operator*(const complex_ball &x, const complex_ball &y)
{
    return rounded(acb_mul, x, y);
}
inline complex_ball operator/(const complex_ball &x, const complex_ball &y)
{
    return rounded(acb_div, x, y);
}
inline complex_ball &operator+=(complex_ball &x, const complex_ball &y) { return x = x + y; }
inline complex_ball &operator-=(complex_ball &x, const complex_ball &y) { return x = x - y; }
inline complex_ball operator-(const complex_ball &z) { return exactly(acb_neg, z); }
inline complex_ball times_i(const complex_ball &z) { return exactly(acb_mul_onei, z); }
inline complex_ball over_i(const complex_ball &z) { return exactly(acb_div_onei, z); }
inline complex_ball midpoint(const complex_ball &z) { return exactly(acb_get_mid, z); }
inline complex_ball conj(const complex_ball &z) { return exactly(acb_conj, z); }
inline complex_ball log(const complex_ball &z) { return rounded(acb_log, z); }
inline complex_ball inv(const complex_ball &z) { return rounded(acb_inv, z); }
inline complex_ball sqr(const complex_ball &z) { return rounded(acb_sqr, z); }
inline complex_ball sqrt(const complex_ball &z) { return rounded(acb_sqrt, z); }
inline complex_ball i_over_pi(const complex_ball &z) { return times_i(z) / pi(); }

/* exp(i pi/4) sqrt(-i z): continuous over the closed upper half-plane but for 0, cut downwards */
inline complex_ball root(const complex_ball &z)
{
    return sqrt(over_i(z)) * sqrt(complex_ball(0, 1));
}

/* A part, or what else is real of it. */
template <typename Function, typename... Bits>
ball real(Function f, const complex_ball &z, Bits... n)
{
    ball result;
    f(result.raw(), z.raw(), n...);
    return result;
}

inline ball re(const complex_ball &z) { return real(acb_get_real, z); }
inline ball im(const complex_ball &z) { return real(acb_get_imag, z); }
inline ball abs(const complex_ball &z) { return real(acb_abs, z, bits); }

/* re x re y + im x im y */
inline ball dot(const complex_ball &x, const complex_ball &y)
{
    return re(x) * re(y) + im(x) * im(y);
}

/* of the modulus, exactly */
inline ball upper_bound(const complex_ball &z)
{
    ball bound;
    acb_get_abs_ubound_arf(arb_midref(bound.raw()), z.raw(), bits);
    return bound;
}

inline bool contains_zero(const complex_ball &z) { return acb_contains_zero(z.raw()); }

#endif
