/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "field.hpp"

#include <complex>
#include <float.h>
#include <math.h>

using complex_number = std::complex<double>;

/* The load is (phi0 + alpha c0)/alpha; c0 = 0 for Hertz. */
contact::contact(const ball &alpha) : shape(alpha, 1), load(shape.phi0 / alpha + shape.c0)
{
}

/* The ball's middle, rounded; *rest grows by how far the ball reaches from it. */
static double middle_of(const ball &x, double *rest)
{
    const double m = middle(x);
    *rest += radius(x) + DBL_EPSILON * fabs(m);
    return m;
}

static complex_number middle_of(const complex_ball &z, double *rest)
{
    const double x = middle_of(re(z), rest), y = middle_of(im(z), rest);
    return {x, y};
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

static model constant(const ball &x)
{
    model m = {};
    m.one = middle_of(x, &m.rest);
    return m;
}

/* Near a singularity, where derivatives are of no use: constants. */
static field constants_over(const contact &c, const complex_ball &z)
{
    const potentials p = c.shape.at(z);
    return {constant(re(p.G)), constant(im(p.G)), constant(re(p.H)), constant(im(p.H))};
}

/* The models of the real and the imaginary part, from complex coefficients of 1, xi, eta, xi^2,
 * xi eta, eta^2. */
static void split_parts(model *re, model *im, const complex_number k[6], double rest)
{
    *re = {k[0].real(), k[1].real(), k[2].real(), k[3].real(), k[4].real(), k[5].real(), rest};
    *im = {k[0].imag(), k[1].imag(), k[2].imag(), k[3].imag(), k[4].imag(), k[5].imag(), rest};
}

/* Times i. */
static complex_number turned(complex_number a)
{
    return {-a.imag(), a.real()};
}

static double size_of(complex_number a)
{
    return fabs(a.real()) + fabs(a.imag());
}

/* What Taylor's formula of a square needs: G, G', G'', G''' at the centre, to `rounded`, and the
 * largest moduli of G''' and G'''' anywhere in it. */
struct derivatives {
    complex_number at[4];
    double rounded[4];
    double third, fourth;
};

static derivatives derivatives_over(const contact &c, const complex_ball &z)
{
    const complex_ball centre = midpoint(z);
    const higher_derivatives bends = c.shape.bends(centre), around = c.shape.bends(z);
    const complex_ball at[4] = {c.shape.potential(centre), c.shape.slope(centre), bends.second,
                                bends.third};
    derivatives d = {};
    for (int i = 0; i < 4; i++)
        d.at[i] = middle_of(at[i], &d.rounded[i]);
    d.third = modulus(around.third);
    d.fourth = modulus(around.fourth);
    return d;
}

/* With z - centre = h omega, |omega| <= sqrt(2), what Taylor's formula leaves along the straight
 * line from the centre is at most this times h^3 and the largest next derivative: 2 sqrt(2)/6,
 * rounded up. */
static const double TAYLOR = 0.4714046;

/* For the rounding of the handful of positive terms that make up a rest. */
static const double ROUNDED_UP = 1 + 1e-12;

static void expand_G(field *over, const derivatives &d, double h)
{
    const double h2 = h * h;
    const complex_number G1 = d.at[1], G2 = d.at[2];
    const complex_number k[6] = {d.at[0],     h * G1,          h * turned(G1),
                                 h2 / 2 * G2, h2 * turned(G2), -h2 / 2 * G2};
    const double rest =
        d.rounded[0] + 2 * h * d.rounded[1] + 2 * h2 * d.rounded[2] + TAYLOR * h2 * h * d.third;
    split_parts(&over->u, &over->v, k, rest * ROUNDED_UP);
}

/* H = (y + h eta) G', y that of the centre. */
static void expand_H(field *over, const derivatives &d, double y, double h)
{
    const double h2 = h * h;
    const complex_number G1 = d.at[1], G2 = d.at[2], G3 = d.at[3];
    const complex_number k[6] = {y * G1,
                                 y * h * G2,
                                 y * h * turned(G2) + h * G1,
                                 y * h2 / 2 * G3,
                                 y * h2 * turned(G3) + h2 * G2,
                                 -y * h2 / 2 * G3 + h2 * turned(G2)};
    double size = 0;
    for (const complex_number &coefficient : k)
        size += size_of(coefficient);
    const double cut_off = h2 * h * (TAYLOR * (y + h) * d.fourth + size_of(G3) + d.rounded[3]);
    const double rounded = (y + h) * (d.rounded[1] + 2 * h * d.rounded[2] + 2 * h2 * d.rounded[3]) +
                           8 * DBL_EPSILON * size;
    split_parts(&over->p, &over->q, k, (cut_off + rounded) * ROUNDED_UP);
}

static field taylor_over(const contact &c, square s, const complex_ball &z)
{
    const derivatives d = derivatives_over(c, z);
    field over;
    expand_G(&over, d, s.half);
    expand_H(&over, d, s.y, s.half);
    return over;
}

/* How far the square's centre is from the next of ±1, ±alpha, roughly. */
static double distance_of_singularity(const contact &c, square s)
{
    const double alpha = fmin(1, middle(c.shape.alpha)), x = fabs(s.x);
    return fmin(hypot(x - alpha, s.y), hypot(x - 1, s.y));
}

static const model &sharper(const model &a, const model &b)
{
    return b.rest < a.rest ? b : a;
}

field field_over(const contact &c, square s)
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

ball J2_at(const contact &c, const complex_ball &z, const ball &f, const ball &kappa)
{
    const potentials N = c.shape.at(z);
    return J2_of(superposed(N, f * N), kappa);
}

/* |G| and |H| are at most r = P/(pi distance) there, so that |D| <= (f + sqrt(1+f^2)) r and s^2
 * <= (1+f^2) r^2. */
ball far_J2(const contact &c, double distance, const ball &f, const ball &kappa)
{
    const ball one_f2 = sqr(f) + 1, r = c.load / (pi() * distance);
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
