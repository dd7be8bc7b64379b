/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of ball arithmetic with C++'s operators: a ball contains the exact number whatever was
 * rounded on the way. All results have `bits` bits, which belong to the thread. A comparison is
 * true only if it is certain, so that !(x < y) does not say x >= y. */
#ifndef BALL_HPP
#define BALL_HPP

#include <math.h>

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

/* Arb's names for real and for complex numbers are one here. */
inline void begin(arb_ptr x) { arb_init(x); }
inline void begin(acb_ptr z) { acb_init(z); }
inline void end(arb_ptr x) { arb_clear(x); }
inline void end(acb_ptr z) { acb_clear(z); }
inline void copy(arb_ptr x, arb_srcptr y) { arb_set(x, y); }
inline void copy(acb_ptr z, acb_srcptr w) { acb_set(z, w); }
inline void exchange(arb_ptr x, arb_ptr y) { arb_swap(x, y); }
inline void exchange(acb_ptr z, acb_ptr w) { acb_swap(z, w); }

template <typename Struct> class number
{
    Struct v[1];

  public:
    number() { begin(v); }
    number(const number &x) : number() { copy(v, x.v); }
    number(number &&x) noexcept : number() { exchange(v, x.v); }
    ~number() { end(v); }
    number &operator=(number x) noexcept
    {
        exchange(v, x.v);
        return *this;
    }

    /* As Arb's functions take it. */
    Struct *raw() { return v; }
    const Struct *raw() const { return v; }
};

struct ball : number<arb_struct> {
    ball() = default;
    ball(double exact) { arb_set_d(raw(), exact); }
};

/* f(result, arguments ..., bits) of Arb, or without bits where the result is exact */
template <typename Function, typename Number, typename... Rest>
Number rounded(Function f, const Number &x, const Rest &...rest)
{
    Number result;
    f(result.raw(), x.raw(), rest.raw()..., bits);
    return result;
}

template <typename Function, typename Number> Number exactly(Function f, const Number &x)
{
    Number result;
    f(result.raw(), x.raw());
    return result;
}

inline ball operator+(const ball &x, const ball &y) { return rounded(arb_add, x, y); }
inline ball operator-(const ball &x, const ball &y) { return rounded(arb_sub, x, y); }
inline ball operator*(const ball &x, const ball &y) { return rounded(arb_mul, x, y); }
inline ball operator/(const ball &x, const ball &y) { return rounded(arb_div, x, y); }
inline ball &operator+=(ball &x, const ball &y) { return x = x + y; }
inline ball operator-(const ball &x) { return exactly(arb_neg, x); }
inline bool operator<(const ball &x, const ball &y) { return arb_lt(x.raw(), y.raw()); }
inline bool operator>(const ball &x, const ball &y) { return y < x; }
inline bool operator<=(const ball &x, const ball &y) { return arb_le(x.raw(), y.raw()); }
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
inline ball tanh(const ball &x) { return rounded(arb_tanh, x); }
inline ball sech(const ball &x) { return rounded(arb_sech, x); }
inline ball asin(const ball &x) { return rounded(arb_asin, x); }
inline ball atan2(const ball &y, const ball &x) { return rounded(arb_atan2, y, x); }
inline ball hypot(const ball &x, const ball &y) { return rounded(arb_hypot, x, y); }
inline ball max(const ball &x, const ball &y) { return rounded(arb_max, x, y); }
inline ball min(const ball &x, const ball &y) { return rounded(arb_min, x, y); }
inline ball hull(const ball &x, const ball &y) { return rounded(arb_union, x, y); }

inline ball pi()
{
    ball result;
    arb_const_pi(result.raw(), bits);
    return result;
}

inline ball unknown()
{
    ball result;
    arb_indeterminate(result.raw());
    return result;
}

struct direction {
    ball cosine, sine;
};

inline direction direction_of(const ball &angle)
{
    direction d;
    arb_sin_cos(d.sine.raw(), d.cosine.raw(), angle.raw(), bits);
    return d;
}

/* Of the middle, and of the radius. */
inline ball midpoint(const ball &x) { return exactly(arb_get_mid_arb, x); }
inline double middle(const ball &x) { return arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR); }
inline double radius(const ball &x) { return mag_get_d(arb_radref(x.raw())); }
inline double upper_bound(const ball &x)
{
    arf_t bound;
    arf_init(bound);
    arb_get_ubound_arf(bound, x.raw(), 64);
    const double upper = arf_get_d(bound, ARF_RND_UP);
    arf_clear(bound);
    return upper;
}
inline int sign(const ball &x) { return arf_sgn(arb_midref(x.raw())); }

/* Whether x is below 2^-n of the scale, but for a factor of 2. */
inline bool is_small(const ball &x, const ball &scale, slong n)
{
    const arf_srcptr a = arb_midref(x.raw()), b = arb_midref(scale.raw());
    return arf_is_zero(a) || ARF_EXP(a) < ARF_EXP(b) - n;
}

inline bool is_zero(const ball &x) { return arb_is_zero(x.raw()); }
inline bool is_finite(const ball &x) { return arb_is_finite(x.raw()); }

/* x 2^n, and x with that radius added. */
inline ball scaled(const ball &x, slong n)
{
    ball result;
    arb_mul_2exp_si(result.raw(), x.raw(), n);
    return result;
}

inline ball widened(ball x, const ball &radius)
{
    arb_add_error(x.raw(), radius.raw());
    return x;
}

#endif
