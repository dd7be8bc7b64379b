/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "square.hpp"

#include <float.h>
#include <math.h>

/* The ball's middle, rounded; *rest grows by how far the ball reaches from it. */
static double middle_of(const ball &x, double *rest)
{
    const double m = middle(x);
    *rest += radius(x) + DBL_EPSILON * fabs(m);
    return m;
}

static double modulus(const complex_ball &z)
{
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, z.raw());
    const double m = mag_get_d(bound) * (1 + DBL_EPSILON);
    mag_clear(bound);
    return m;
}

/* For the rounding of the handful of positive terms that make up a rest. */
static const double ROUNDED_UP = 1 + 1e-12;

/* Coefficients of 1, xi, eta, xi^2, xi eta, eta^2, and what they leave out. */
static model model_of(const ball k[6], double rest)
{
    double m[6];
    for (int i = 0; i < 6; i++)
        m[i] = middle_of(k[i], &rest);
    return {m[0], m[1], m[2], m[3], m[4], m[5], rest * ROUNDED_UP};
}

static model constant(const ball &x)
{
    const ball k[6] = {x};
    return model_of(k, 0);
}

/* Near a singularity, where derivatives are of no use: constants. */
static field constants_over(const patch &c, const complex_ball &z)
{
    const potentials p = c.at(z);
    return {constant(re(p.G)), constant(im(p.G)), constant(re(p.H)), constant(im(p.H))};
}

/* The models of the real and of the imaginary part. */
static void split_parts(model *real, model *imaginary, const complex_ball k[6], double rest)
{
    ball u[6], v[6];
    for (int i = 0; i < 6; i++) {
        u[i] = re(k[i]);
        v[i] = im(k[i]);
    }
    *real = model_of(u, rest);
    *imaginary = model_of(v, rest);
}

/* With z - centre = h omega, |omega| <= sqrt(2), what Taylor's formula leaves along the straight
 * line from the centre is at most this times h^3 and the largest next derivative: 2 sqrt(2)/6,
 * rounded up. */
static const double TAYLOR = 0.4714046;

/* By Taylor's formula from the centre: G, and H = (y + h eta) G', y that of the centre; G1 ... G3
 * are the derivatives times powers of h. The third and fourth derivatives bound the rests by their
 * largest moduli anywhere in the square. */
static field taylor_over(const patch &c, square s, const complex_ball &z)
{
    const complex_ball centre = midpoint(z);
    const higher_derivatives bends = c.bends(centre), around = c.bends(z);
    const ball h = s.half, y = s.y / h;
    const complex_ball G1 = h * c.slope(centre), G2 = sqr(h) * bends.second,
                       G3 = cube(h) * bends.third;
    const complex_ball of_G[6] = {c.potential(centre), G1,       times_i(G1), G2 / 2,
                                  times_i(G2),         -(G2 / 2)};
    const complex_ball of_H[6] = {y * G1,
                                  y * G2,
                                  times_i(y * G2) + G1,
                                  y * G3 / 2,
                                  times_i(y * G3) + G2,
                                  times_i(G2) - y * G3 / 2};
    const double next = TAYLOR * s.half * s.half * s.half;
    field over;
    split_parts(&over.u, &over.v, of_G, next * modulus(around.third));
    split_parts(&over.p, &over.q, of_H,
                modulus(G3) + next * (s.y + s.half) * modulus(around.fourth));
    return over;
}

/* How far the square's centre is from the next of ±1, ±alpha, roughly. */
static double distance_of_singularity(const patch &c, square s)
{
    const double alpha = fmin(1, middle(c.alpha)), x = fabs(s.x);
    return fmin(hypot(x - alpha, s.y), hypot(x - 1, s.y));
}

static const model &sharper(const model &a, const model &b)
{
    return b.rest < a.rest ? b : a;
}

field field_over(const patch &c, square s)
{
    /* halves of the square: between, now this is sharper, now that */
    static const double TOUCHING = 3, NEAR = 12;
    const double distance = distance_of_singularity(c, s);
    const complex_ball z(widened(s.x, s.half), widened(s.y, s.half));
    if (distance < TOUCHING * s.half)
        return constants_over(c, z);
    const field taylor = taylor_over(c, s, z);
    if (distance >= NEAR * s.half)
        return taylor;
    const field plain = constants_over(c, z);
    return {sharper(taylor.u, plain.u), sharper(taylor.v, plain.v), sharper(taylor.p, plain.p),
            sharper(taylor.q, plain.q)};
}

ball J2_at(const patch &c, const complex_ball &z, const ball &f, const ball &kappa)
{
    const potentials N = c.at(z);
    return J2_of(superposed(N, f * N), kappa);
}

/* |G| and |H| are at most r = P/(pi distance) there, so that |D| <= (f + sqrt(1+f^2)) r and s^2
 * <= (1+f^2) r^2. */
ball far_J2(const patch &c, double distance, const ball &f, const ball &kappa)
{
    const ball one_f2 = sqr(f) + 1, r = c.load() / (pi() * distance);
    return sqr(r) * (sqr(sqrt(one_f2) + f) + one_f2 * kappa);
}

double lower_bound(const ball &x)
{
    arf_t bound;
    arf_init(bound);
    arb_get_lbound_arf(bound, x.raw(), bits);
    const double rounded = arf_get_d(bound, ARF_RND_FLOOR);
    arf_clear(bound);
    return rounded;
}
