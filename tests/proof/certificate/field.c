/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "field.h"

#include "curvature.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

void contact_init(contact *c, const arb_t alpha)
{
    arb_t one;
    arb_init(one);
    arb_one(one);
    ball_patch_init(&c->patch, alpha, one, BITS);
    arb_init(c->load);
    arb_div(c->load, c->patch.phi0, alpha, BITS); /* (phi0 + alpha c0)/alpha; c0 = 0 for Hertz */
    arb_add(c->load, c->load, c->patch.c0, BITS);
    arb_clear(one);
}

void contact_clear(contact *c)
{
    arb_clear(c->load);
    ball_patch_clear(&c->patch);
}

/* The ball's middle, rounded; *rest grows by how far the ball reaches from it. */
static double middle(const arb_t ball, double *rest)
{
    const double m = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
    *rest += mag_get_d(arb_radref(ball)) + DBL_EPSILON * fabs(m);
    return m;
}

typedef struct {
    double re, im;
} complex_number;

static complex_number middle_complex(const acb_t ball, double *rest)
{
    return (complex_number){middle(acb_realref(ball), rest), middle(acb_imagref(ball), rest)};
}

static double modulus(const acb_t ball)
{
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, ball);
    const double m = mag_get_d(bound) * (1 + DBL_EPSILON);
    mag_clear(bound);
    return m;
}

static model constant(const arb_t ball)
{
    double rest = 0;
    const double one = middle(ball, &rest);
    return (model){.one = one, .rest = rest};
}

/* Near a singularity, where derivatives are of no use: constants. */
static void enclose_plainly(field *over, const contact *c, const acb_t z)
{
    acb_t G, H;
    acb_init(G), acb_init(H);
    ball_potential(G, &c->patch, z, BITS);
    ball_potential_slope_by_depth(H, &c->patch, z, BITS);
    *over = (field){constant(acb_realref(G)), constant(acb_imagref(G)), constant(acb_realref(H)),
                    constant(acb_imagref(H))};
    acb_clear(G), acb_clear(H);
}

/* The models of the real and the imaginary part, from complex coefficients of 1, xi, eta, xi^2,
 * xi eta, eta^2. */
static void split_parts(model *re, model *im, const complex_number k[6], double rest)
{
    *re = (model){k[0].re, k[1].re, k[2].re, k[3].re, k[4].re, k[5].re, rest};
    *im = (model){k[0].im, k[1].im, k[2].im, k[3].im, k[4].im, k[5].im, rest};
}

static complex_number scaled(double factor, complex_number a)
{
    return (complex_number){factor * a.re, factor * a.im};
}

static complex_number turned(complex_number a)
{
    return (complex_number){-a.im, a.re};
}

static complex_number sum(complex_number a, complex_number b)
{
    return (complex_number){a.re + b.re, a.im + b.im};
}

/* What Taylor's formula of a square needs: G, G', G'', G''' at the centre, to `rounded`, and the
 * largest moduli of G''' and G'''' anywhere in it. */
typedef struct {
    complex_number at[4];
    double rounded[4];
    double third, fourth;
} derivatives;

static derivatives derivatives_over(const contact *c, const acb_t z)
{
    derivatives d = {.rounded = {0}};
    acb_t centre, ball;
    curvature at, around;
    acb_init(centre), acb_init(ball), curvature_init(&at), curvature_init(&around);
    acb_get_mid(centre, z);
    ball_potential(ball, &c->patch, centre, BITS);
    d.at[0] = middle_complex(ball, &d.rounded[0]);
    ball_potential_slope(ball, &c->patch, centre, BITS);
    d.at[1] = middle_complex(ball, &d.rounded[1]);
    curvature_enclose(&at, &c->patch, centre, BITS);
    d.at[2] = middle_complex(at.second, &d.rounded[2]);
    d.at[3] = middle_complex(at.third, &d.rounded[3]);
    curvature_enclose(&around, &c->patch, z, BITS);
    d.third = modulus(around.third);
    d.fourth = modulus(around.fourth);
    acb_clear(centre), acb_clear(ball), curvature_clear(&at), curvature_clear(&around);
    return d;
}

/* With z - centre = h omega, |omega| <= sqrt(2), what Taylor's formula leaves along the straight
 * line from the centre is at most this times h^3 and the largest next derivative: 2 sqrt(2)/6,
 * rounded up. */
static const double TAYLOR = 0.4714046;

/* For the rounding of the handful of positive terms that make up a rest. */
static const double ROUNDED_UP = 1 + 1e-12;

static void expand_G(field *over, const derivatives *d, double h)
{
    const double h2 = h * h;
    const complex_number G1 = d->at[1], G2 = d->at[2];
    const complex_number k[6] = {d->at[0],           scaled(h, G1),          scaled(h, turned(G1)),
                                 scaled(h2 / 2, G2), scaled(h2, turned(G2)), scaled(-h2 / 2, G2)};
    const double rest =
        d->rounded[0] + 2 * h * d->rounded[1] + 2 * h2 * d->rounded[2] + TAYLOR * h2 * h * d->third;
    split_parts(&over->u, &over->v, k, rest * ROUNDED_UP);
}

/* H = (y + h eta) G', y that of the centre. */
static void expand_H(field *over, const derivatives *d, double y, double h)
{
    const double h2 = h * h;
    const complex_number G1 = d->at[1], G2 = d->at[2], G3 = d->at[3];
    const complex_number k[6] = {scaled(y, G1),
                                 scaled(y * h, G2),
                                 sum(scaled(y * h, turned(G2)), scaled(h, G1)),
                                 scaled(y * h2 / 2, G3),
                                 sum(scaled(y * h2, turned(G3)), scaled(h2, G2)),
                                 sum(scaled(-y * h2 / 2, G3), scaled(h2, turned(G2)))};
    double size = 0;
    for (int i = 0; i < 6; i++)
        size += fabs(k[i].re) + fabs(k[i].im);
    const double cut_off =
        h2 * h * (TAYLOR * (y + h) * d->fourth + fabs(G3.re) + fabs(G3.im) + d->rounded[3]);
    const double rounded =
        (y + h) * (d->rounded[1] + 2 * h * d->rounded[2] + 2 * h2 * d->rounded[3]) +
        8 * DBL_EPSILON * size;
    split_parts(&over->p, &over->q, k, (cut_off + rounded) * ROUNDED_UP);
}

static void enclose_by_taylor(field *over, const contact *c, square s, const acb_t z)
{
    const derivatives d = derivatives_over(c, z);
    expand_G(over, &d, s.half);
    expand_H(over, &d, s.y, s.half);
}

/* How far the square's centre is from the next of ±1, ±alpha, roughly. */
static double distance_of_singularity(const contact *c, square s)
{
    double ignored = 0;
    const double alpha = fmin(1, middle(c->patch.alpha, &ignored)), x = fabs(s.x);
    return fmin(hypot(x - alpha, s.y), hypot(x - 1, s.y));
}

static void take_sharper(model *m, const model *other)
{
    if (other->rest < m->rest)
        *m = *other;
}

void field_enclose(field *over, const contact *c, square s)
{
    /* halves of the square: between, now this is sharper, now that */
    static const double TOUCHING = 3, NEAR = 12;
    const double distance = distance_of_singularity(c, s);
    acb_t z;
    acb_init(z);
    acb_set_d_d(z, s.x, s.y);
    mag_set_d(arb_radref(acb_realref(z)), s.half);
    mag_set_d(arb_radref(acb_imagref(z)), s.half);
    if (distance < TOUCHING * s.half) {
        enclose_plainly(over, c, z);
    } else {
        enclose_by_taylor(over, c, s, z);
        if (distance < NEAR * s.half) {
            field plain;
            enclose_plainly(&plain, c, z);
            take_sharper(&over->u, &plain.u);
            take_sharper(&over->v, &plain.v);
            take_sharper(&over->p, &plain.p);
            take_sharper(&over->q, &plain.q);
        }
    }
    acb_clear(z);
}

void ball_J2(arb_t J2, const contact *c, const acb_t z, const arb_t f, const arb_t kappa)
{
    acb_t G, H, D;
    arb_t s;
    acb_init(G), acb_init(H), acb_init(D), arb_init(s);
    ball_potential(G, &c->patch, z, BITS);
    ball_potential_slope_by_depth(H, &c->patch, z, BITS);
    acb_mul_onei(D, H); /* D = f (G + i H) - H, s = Im G - f Re G */
    acb_add(D, D, G, BITS);
    acb_mul_arb(D, D, f, BITS);
    acb_sub(D, D, H, BITS);
    arb_mul(s, f, acb_realref(G), BITS);
    arb_sub(s, acb_imagref(G), s, BITS);
    arb_mul(s, s, s, BITS);
    arb_mul(J2, s, kappa, BITS);
    arb_addmul(J2, acb_realref(D), acb_realref(D), BITS);
    arb_addmul(J2, acb_imagref(D), acb_imagref(D), BITS);
    acb_clear(G), acb_clear(H), acb_clear(D), arb_clear(s);
}

/* |G| and |H| are at most r = P/(pi distance) there, so that |D| <= (f + sqrt(1+f^2)) r and s^2
 * <= (1+f^2) r^2. */
void ball_far_J2(arb_t J2, const contact *c, ulong distance, const arb_t f, const arb_t kappa)
{
    arb_t r, one_f2, sum;
    arb_init(r), arb_init(one_f2), arb_init(sum);
    arb_mul(one_f2, f, f, BITS);
    arb_add_ui(one_f2, one_f2, 1, BITS);
    arb_sqrt(sum, one_f2, BITS);
    arb_add(sum, sum, f, BITS);
    arb_mul(sum, sum, sum, BITS);
    arb_addmul(sum, one_f2, kappa, BITS);
    arb_const_pi(r, BITS);
    arb_mul_ui(r, r, distance, BITS);
    arb_div(r, c->load, r, BITS);
    arb_mul(r, r, r, BITS);
    arb_mul(J2, r, sum, BITS);
    arb_clear(r), arb_clear(one_f2), arb_clear(sum);
}

double ball_lower(const arb_t ball)
{
    arf_t bound;
    arf_init(bound);
    arb_get_lbound_arf(bound, ball, BITS);
    const double rounded = arf_get_d(bound, ARF_RND_FLOOR);
    arf_clear(bound);
    return rounded;
}
