/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Complex numbers of ball arithmetic, like ball.hpp. */
#ifndef COMPLEX_BALL_HPP
#define COMPLEX_BALL_HPP

#include "balls/ball.hpp"

class complex_ball
{
    acb_t v;

  public:
    complex_ball() { acb_init(v); }
    complex_ball(const ball &real) : complex_ball() { acb_set_arb(v, real.arb()); }
    complex_ball(double real) : complex_ball() { acb_set_d(v, real); }
    complex_ball(const ball &real, const ball &imaginary) : complex_ball()
    {
        acb_set_arb_arb(v, real.arb(), imaginary.arb());
    }
    complex_ball(const complex_ball &z) : complex_ball() { acb_set(v, z.v); }
    complex_ball(complex_ball &&z) noexcept : complex_ball() { acb_swap(v, z.v); }
    ~complex_ball() { acb_clear(v); }
    complex_ball &operator=(const complex_ball &z)
    {
        acb_set(v, z.v);
        return *this;
    }
    complex_ball &operator=(complex_ball &&z) noexcept
    {
        acb_swap(v, z.v);
        return *this;
    }

    acb_ptr acb() { return v; }
    acb_srcptr acb() const { return v; }

    complex_ball &operator+=(const complex_ball &z)
    {
        acb_add(v, v, z.v, bits);
        return *this;
    }
    complex_ball &operator-=(const complex_ball &z)
    {
        acb_sub(v, v, z.v, bits);
        return *this;
    }
    complex_ball &operator*=(const complex_ball &z)
    {
        acb_mul(v, v, z.v, bits);
        return *this;
    }
    complex_ball &operator/=(const complex_ball &z)
    {
        acb_div(v, v, z.v, bits);
        return *this;
    }
    complex_ball &operator*=(const ball &x)
    {
        acb_mul_arb(v, v, x.arb(), bits);
        return *this;
    }
    complex_ball &operator/=(const ball &x)
    {
        acb_div_arb(v, v, x.arb(), bits);
        return *this;
    }

    /* f(result, z, bits) of Arb, or without bits */
    template <typename Function> static complex_ball rounded(Function f, const complex_ball &z)
    {
        complex_ball result;
        f(result.v, z.v, bits);
        return result;
    }
    template <typename Function> static complex_ball exactly(Function f, const complex_ball &z)
    {
        complex_ball result;
        f(result.v, z.v);
        return result;
    }

    friend complex_ball operator+(complex_ball x, const complex_ball &y)
    {
        return std::move(x += y);
    }
    friend complex_ball operator-(complex_ball x, const complex_ball &y)
    {
        return std::move(x -= y);
    }
    friend complex_ball operator*(complex_ball x, const complex_ball &y)
    {
        return std::move(x *= y);
    }
    friend complex_ball operator/(complex_ball x, const complex_ball &y)
    {
        return std::move(x /= y);
    }
    friend complex_ball operator*(complex_ball x, const ball &y) { return x *= y; }
    friend complex_ball operator*(const ball &x, complex_ball y) { return y *= x; }
    friend complex_ball operator/(complex_ball x, const ball &y) { return x /= y; }
    friend complex_ball operator*(double x, complex_ball y) { return y *= ball(x); }
    friend complex_ball operator/(complex_ball x, double y) { return x /= ball(y); }
    friend complex_ball operator*(complex_ball x, double y) { return x *= ball(y); }
    friend complex_ball operator-(const complex_ball &z) { return exactly(acb_neg, z); }
    friend complex_ball times_i(const complex_ball &z) { return exactly(acb_mul_onei, z); }
    friend complex_ball over_i(const complex_ball &z) { return exactly(acb_div_onei, z); }
    friend complex_ball log(const complex_ball &z) { return rounded(acb_log, z); }
    friend complex_ball inv(const complex_ball &z) { return rounded(acb_inv, z); }
    friend complex_ball sqr(const complex_ball &z) { return rounded(acb_sqr, z); }
    friend complex_ball midpoint(const complex_ball &z) { return exactly(acb_get_mid, z); }
    friend complex_ball conj(const complex_ball &z) { return exactly(acb_conj, z); }
    friend complex_ball sqrt(const complex_ball &z) { return rounded(acb_sqrt, z); }
    /* exp(i pi/4) sqrt(-i z): continuous over the closed upper half-plane but for 0, cut
     * downwards */
    friend complex_ball root(const complex_ball &z)
    {
        return sqrt(over_i(z)) * sqrt(complex_ball(0, 1));
    }
    friend complex_ball i_over_pi(const complex_ball &z) { return times_i(z) / pi(); }

    friend ball re(const complex_ball &z) { return ball::copy(acb_realref(z.v)); }

    friend ball im(const complex_ball &z) { return ball::copy(acb_imagref(z.v)); }

    friend ball abs(const complex_ball &z)
    {
        ball modulus;
        acb_abs(modulus.arb(), z.acb(), bits);
        return modulus;
    }

    /* re x re y + im x im y */
    friend ball dot(const complex_ball &x, const complex_ball &y)
    {
        return re(x) * re(y) + im(x) * im(y);
    }

    /* of the modulus, exactly */
    friend ball upper_bound(const complex_ball &z)
    {
        ball bound;
        acb_get_abs_ubound_arf(arb_midref(bound.arb()), z.acb(), bits);
        return bound;
    }

    friend bool contains_zero(const complex_ball &z) { return acb_contains_zero(z.acb()); }
};

#endif
