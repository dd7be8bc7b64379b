/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of ball arithmetic with C++'s operators: a ball contains the exact number whatever was
 * rounded on the way. All results have `bits` bits, which belong to the thread. A comparison is
 * true only if it is certain, so that !(x < y) does not say x >= y. */
#ifndef BALL_HPP
#define BALL_HPP

#include <math.h>
#include <utility>

#ifdef BALLS_IN_FLINT /* FLINT 3 contains Arb */
#include <flint/acb.h>
#else
#include <acb.h>
#endif

inline thread_local slong bits = 128;

/* Other bits, to the end of the scope. */
class precision
{
    const slong before;

  public:
    explicit precision(slong wanted) : before(bits) { bits = wanted; }
    ~precision() { bits = before; }
    precision(const precision &) = delete;
    precision &operator=(const precision &) = delete;
};

class ball
{
    arb_t v;

  public:
    ball() { arb_init(v); }
    ball(double exact) : ball() { arb_set_d(v, exact); }
    ball(const ball &x) : ball() { arb_set(v, x.v); }
    ball(ball &&x) noexcept : ball() { arb_swap(v, x.v); }
    ~ball() { arb_clear(v); }
    ball &operator=(const ball &x)
    {
        arb_set(v, x.v);
        return *this;
    }
    ball &operator=(ball &&x) noexcept
    {
        arb_swap(v, x.v);
        return *this;
    }

    static ball copy(const arb_t x)
    {
        ball result;
        arb_set(result.v, x);
        return result;
    }
    arb_ptr arb() { return v; }
    arb_srcptr arb() const { return v; }

    ball &operator+=(const ball &x)
    {
        arb_add(v, v, x.v, bits);
        return *this;
    }
    ball &operator-=(const ball &x)
    {
        arb_sub(v, v, x.v, bits);
        return *this;
    }
    ball &operator*=(const ball &x)
    {
        arb_mul(v, v, x.v, bits);
        return *this;
    }
    ball &operator/=(const ball &x)
    {
        arb_div(v, v, x.v, bits);
        return *this;
    }
};

/* f(result, arguments ..., bits) of Arb, or without bits where the result is exact */
template <typename Function, typename... Balls> ball rounded(Function f, const Balls &...x)
{
    ball result;
    f(result.arb(), x.arb()..., bits);
    return result;
}

template <typename Function, typename... Balls> ball exactly(Function f, const Balls &...x)
{
    ball result;
    f(result.arb(), x.arb()...);
    return result;
}

inline ball operator+(const ball &x, const ball &y) { return rounded(arb_add, x, y); }
inline ball operator+(ball &&x, const ball &y) { return std::move(x += y); }
inline ball operator-(const ball &x, const ball &y) { return rounded(arb_sub, x, y); }
inline ball operator-(ball &&x, const ball &y) { return std::move(x -= y); }
inline ball operator*(const ball &x, const ball &y) { return rounded(arb_mul, x, y); }
inline ball operator*(ball &&x, const ball &y) { return std::move(x *= y); }
inline ball operator/(const ball &x, const ball &y) { return rounded(arb_div, x, y); }
inline ball operator/(ball &&x, const ball &y) { return std::move(x /= y); }
inline ball operator-(const ball &x) { return exactly(arb_neg, x); }
inline bool operator<(const ball &x, const ball &y) { return arb_lt(x.arb(), y.arb()); }
inline bool operator>(const ball &x, const ball &y) { return y < x; }
inline bool operator<=(const ball &x, const ball &y) { return arb_le(x.arb(), y.arb()); }
inline bool operator>=(const ball &x, const ball &y) { return y <= x; }

inline ball abs(const ball &x) { return exactly(arb_abs, x); }
inline ball sqr(const ball &x) { return rounded(arb_sqr, x); }
inline ball cube(const ball &x) { return sqr(x) * x; }
/* Of what is not negative: a ball that rounding took below 0 counts from 0. */
inline ball sqrt(const ball &x) { return rounded(arb_sqrtpos, x); }
inline ball log(const ball &x) { return rounded(arb_log, x); }
inline ball exp(const ball &x) { return rounded(arb_exp, x); }
inline ball sin(const ball &x) { return rounded(arb_sin, x); }
inline ball cos(const ball &x) { return rounded(arb_cos, x); }
inline ball tan(const ball &x) { return rounded(arb_tan, x); }
inline ball asin(const ball &x) { return rounded(arb_asin, x); }
inline ball acos(const ball &x) { return rounded(arb_acos, x); }
inline ball atan2(const ball &y, const ball &x) { return rounded(arb_atan2, y, x); }
inline ball acosh(const ball &x) { return rounded(arb_acosh, x); }
inline ball hypot(const ball &x, const ball &y) { return rounded(arb_hypot, x, y); }
inline ball max(const ball &x, const ball &y) { return rounded(arb_max, x, y); }
inline ball min(const ball &x, const ball &y) { return rounded(arb_min, x, y); }
inline ball hull(const ball &x, const ball &y) { return rounded(arb_union, x, y); }
inline ball pi() { return rounded(arb_const_pi); }
inline ball unknown() { return exactly(arb_indeterminate); }

struct direction {
    ball cosine, sine;
};

inline direction direction_of(const ball &angle)
{
    direction d;
    arb_sin_cos(d.sine.arb(), d.cosine.arb(), angle.arb(), bits);
    return d;
}

/* Of the middle, and of the radius. */
inline ball midpoint(const ball &x) { return exactly(arb_get_mid_arb, x); }
inline double middle(const ball &x) { return arf_get_d(arb_midref(x.arb()), ARF_RND_NEAR); }
inline double radius(const ball &x) { return mag_get_d(arb_radref(x.arb())); }
inline double upper_bound(const ball &x)
{
    arf_t bound;
    arf_init(bound);
    arb_get_ubound_arf(bound, x.arb(), 64);
    const double upper = arf_get_d(bound, ARF_RND_UP);
    arf_clear(bound);
    return upper;
}
inline int sign(const ball &x) { return arf_sgn(arb_midref(x.arb())); }

/* Whether x is below 2^-n of the scale, but for a factor of 2. */
inline bool is_small(const ball &x, const ball &scale, slong n)
{
    const arf_srcptr a = arb_midref(x.arb()), b = arb_midref(scale.arb());
    return arf_is_zero(a) || ARF_EXP(a) < ARF_EXP(b) - n;
}

inline bool is_zero(const ball &x) { return arb_is_zero(x.arb()); }
inline bool is_finite(const ball &x) { return arb_is_finite(x.arb()); }
inline bool contains(const ball &whole, const ball &part)
{
    return arb_contains(whole.arb(), part.arb());
}

/* x 2^n, and x with that radius added. */
inline ball scaled(const ball &x, slong n)
{
    ball result;
    arb_mul_2exp_si(result.arb(), x.arb(), n);
    return result;
}

inline ball widened(ball x, const ball &radius)
{
    arb_add_error(x.arb(), radius.arb());
    return x;
}

#endif
