/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed form of the potential of a patch off the centre. With z from the middle in
 * half-widths, z = sin(zeta), q = exp(i zeta) = i R, X = sqrt(z^2-1) = i cos(zeta), and the ends of
 * the rounding at sin(phi_0) and sin(phi_1), 2 alpha apart,
 *
 *     h = (phi_1 - phi_0)/(2 alpha),   mu = (phi_0 + phi_1)/2,
 *     (pi/2) G  = h R - tan(mu) + i (z - sin(phi_n)) A + i l_f,
 *     (pi/2) G' = i A - (h R + tan(mu))/X,                        A = (l_0 - l_1)/(2 alpha),
 *     l_j = ln(1 - exp(-i phi_j) q) - ln(1 + exp(i phi_j) q),
 *
 * n being the end nearer to the point and f the other. Where only one end is inside,
 *     pi alpha G = w R + e (i (z - sin(phi)) l - cos(phi)),   w = pi/2 - e phi,
 * e = 1 where the flank is on its left and -1 where it is on its right; of the sharp wedge (pi/2) G
 * = i l.
 *
 * Far away the terms cancel, and the series in R is summed instead: (pi/2) G = sum (2/n) <sin n
 * psi> R^n, psi = pi/2 - phi and the mean that of patch.h. Points of the left half are those of the
 * mirror image's right half. */
#ifndef RW_ECCENTRIC_FORM_H
#define RW_ECCENTRIC_FORM_H

#include "base/complex.h"
#include "base/domain.h"
#include "base/logarithm.h"
#include "potential/eccentric.h"
#include "potential/elliptic.h"

typedef struct {
    double x, y, beyond; /* from the middle and from the edge */
    double apex;         /* x from the middle of the arc */
    double past[2];      /* from the ends of the rounding, or [0] from the one that is inside */
} rw_side_place;

/* Added to a square it is lost in rounding, unless the square is 0: at the end of a rounding, where
 * any finite logarithm will do. */
static const double ZERO_SQUARED = 0x1p-1000;

/* Quantities of a point that all ends of arcs share. */
typedef struct {
    rw_elliptic e;
    double shrink, cosh_less_1, per_cosh;
} rw_elliptic_point;

RW_INLINE rw_elliptic_point rw_elliptic_point_of(rw_elliptic e)
{
    return (rw_elliptic_point){e, rw_elliptic_shrink(&e), e.sinh_w * e.sinh_w / (1 + e.cosh_w),
                               1 / e.cosh_w};
}

/* l of one end: past is x - sine. 1 - sine sin(v) is a sum of squares. */
RW_INLINE rw_complex rw_end_logarithm(double sine, double cosine, double past, rw_elliptic_point at)
{
    const rw_elliptic *e = &at.e;
    const double apart = e->sin_v - sine, size = past * past + e->y * e->y;
    const double b = e->cos_v * cosine +
                     0.5 * (e->cos_v * e->cos_v + cosine * cosine + apart * apart) + at.cosh_less_1;
    const double d = (sine * e->sinh_w * e->sinh_w - past) * at.per_cosh;
    return (rw_complex){
        .re = 0.5 *
              rw_log_of_quotient_over(size + ZERO_SQUARED, b * b, -2 * e->cos_v * cosine * b, 1, 1),
        .im = rw_angle(cosine * cosine * e->sinh_w + sine * d,
                       -cosine * (sine * e->sinh_w * at.shrink + past) * at.per_cosh),
    };
}

/* y/X times (re + i im) */
RW_INLINE rw_complex rw_over_X(const rw_elliptic *e, double y, double re, double im)
{
    const double X_re = e->sin_v * e->sinh_w, X_im = e->cos_v * e->cosh_w, scale = y / e->cos2;
    return (rw_complex){scale * (re * X_re + im * X_im), scale * (im * X_re - re * X_im)};
}

/* A = (l_0 - l_1)/(2 alpha), a logarithm: of the quotient of eta +- cos(zeta) sin(half), whose
 * product is (z - sin(phi_0))(z - sin(phi_1)). First of its modulus, then its angle. */
RW_INLINE double log_over(const rw_arc_ends *k, const rw_half_view *v, rw_side_place at,
                          rw_complex eta, const rw_elliptic *e)
{
    const double C_re = e->cos_v * e->cosh_w, C_im = -(e->sin_v * e->sinh_w);
    const double way = (eta.re - v->sin_middle * e->sinh_w * e->sinh_w) / e->cosh_w;
    const double sign = rw_if_negative(way + 0.0, -1, 1), signed_s = sign * k->sin_half;
    const double W_re = eta.re + signed_s * C_re, W_im = eta.im + signed_s * C_im;
    const double W = W_re * W_re + W_im * W_im, y2 = at.y * at.y;
    const double product = (at.past[0] * at.past[0] + y2) * (at.past[1] * at.past[1] + y2);
    return 0.25 * sign *
           rw_log_of_quotient_over(W * W, product + ZERO_SQUARED,
                                   4 * k->sin_half_over * e->cos_v * (sign * way) * W, k->alpha,
                                   k->per_alpha);
}

RW_INLINE double turn_over(const rw_arc_ends *k, const rw_half_view *v, rw_complex eta,
                           double cosh_less_1, const rw_elliptic *e)
{
    const double s = k->sin_half, c = k->cos_half, cos_whole = c * c - s * s;
    const double turn =
        e->sinh_w * (c * cosh_less_1 + v->clearance +
                     v->above * (e->cos_v * e->cos_v / (1 + e->sin_v)) + v->beside * e->sin_v);
    const double eta2 = eta.re * eta.re + eta.im * eta.im;
    const double inner = eta2 - s * s * (e->cos_v * e->cos_v + e->sinh_w * e->sinh_w);
    const double x = inner * cos_whole + 4 * s * s * c * turn;
    const double y_over = 2 * k->sin_half_over * (c * inner - cos_whole * turn);
    return 0.5 * rw_angle_over(x, y_over, k->alpha, k->per_alpha);
}

RW_INLINE rw_complex difference_over(const rw_arc_ends *k, const rw_half_view *v, rw_side_place at,
                                     double cosh_less_1, const rw_elliptic *e)
{
    const double s = k->sin_half, c = k->cos_half;
    const rw_complex eta = {c * at.apex - v->sin_middle * s * s, c * at.y};
    return (rw_complex){log_over(k, v, at, eta, e), turn_over(k, v, eta, cosh_less_1, e)};
}

/* Hertz: G = R/alpha. */
RW_INLINE rw_field rw_side_hertz_field(const rw_eccentric *p, const rw_half_view *v,
                                       rw_side_place at)
{
    (void)v;
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e), per = p->half_width / p->a;
    const double R_re = per * (shrink * e.sin_v), R_im = -per * (shrink * e.cos_v);
    const rw_complex steep = rw_over_X(&e, at.y, R_re, R_im);
    return (rw_field){R_re, R_im, -steep.re, -steep.im};
}

RW_INLINE rw_field rw_side_rounded_field(const rw_eccentric *p, const rw_half_view *v,
                                         rw_side_place at)
{
    const rw_arc_ends *k = &p->ends;
    const rw_elliptic_point point = rw_elliptic_point_of(rw_elliptic_at(at.x, at.y, at.beyond));
    const rw_elliptic e = point.e;
    const double shrink = point.shrink;
    const rw_complex A = difference_over(k, v, at, point.cosh_less_1, &e);
    /* the end that is nearer, and the other */
    const double side = at.apex + 0.0, near = rw_if_negative(side, at.past[0], at.past[1]),
                 far = rw_if_negative(side, at.past[1], at.past[0]);
    const rw_complex l =
        rw_end_logarithm(rw_if_negative(side, v->sine[1], v->sine[0]),
                         rw_if_negative(side, v->cosine[1], v->cosine[0]), far, point);
    const double R_re = k->half_over * (shrink * e.sin_v),
                 R_im = -k->half_over * (shrink * e.cos_v);
    const rw_complex edge = rw_over_X(&e, at.y, R_re + v->slant, R_im);
    return (rw_field){2 / RW_PI * (R_re - v->slant - (near * A.im + at.y * A.re) - l.im),
                      2 / RW_PI * (R_im + (near * A.re - at.y * A.im) + l.re),
                      2 / RW_PI * (-at.y * A.im - edge.re), 2 / RW_PI * (at.y * A.re - edge.im)};
}

RW_INLINE rw_field rw_side_half_rounded_field(const rw_eccentric *p, const rw_half_view *v,
                                              rw_side_place at)
{
    const rw_elliptic_point point = rw_elliptic_point_of(rw_elliptic_at(at.x, at.y, at.beyond));
    const rw_elliptic e = point.e;
    const double shrink = point.shrink;
    const rw_complex l = rw_end_logarithm(v->sine[0], v->cosine[0], at.past[0], point);
    const double w = v->arc_over, per = v->side * p->ends.per_alpha, c = per * v->cosine[0];
    const double R_re = w * (shrink * e.sin_v), R_im = -w * (shrink * e.cos_v);
    const double l_re = per * l.re, l_im = per * l.im;
    const rw_complex edge = rw_over_X(&e, at.y, R_re + c, R_im);
    return (rw_field){1 / RW_PI * (R_re - c - (at.past[0] * l_im + at.y * l_re)),
                      1 / RW_PI * (R_im + (at.past[0] * l_re - at.y * l_im)),
                      1 / RW_PI * (-at.y * l_im - edge.re), 1 / RW_PI * (at.y * l_re - edge.im)};
}

RW_INLINE rw_field rw_side_sharp_field(const rw_eccentric *p, const rw_half_view *v,
                                       rw_side_place at)
{
    (void)p;
    const rw_elliptic_point point = rw_elliptic_point_of(rw_elliptic_at(at.x, at.y, at.beyond));
    const rw_elliptic e = point.e;
    const rw_complex l = rw_end_logarithm(v->sine[0], v->cosine[0], at.apex, point);
    const double scale = v->cosine[0] / (at.apex * at.apex + at.y * at.y);
    const rw_complex steep = rw_over_X(&e, at.y, scale * at.apex, -scale * at.y);
    return (rw_field){-2 / RW_PI * l.im, 2 / RW_PI * l.re, -2 / RW_PI * steep.re,
                      -2 / RW_PI * steep.im};
}

/* The view from the side on which `from_middle` is. */
RW_INLINE rw_half_view blended(const rw_half_view *r, const rw_half_view *l, double from_middle)
{
    return (rw_half_view){
        .edge = rw_if_negative(from_middle, l->edge, r->edge),
        .end = rw_if_negative(from_middle, l->end, r->end),
        .other_end = rw_if_negative(from_middle, l->other_end, r->other_end),
        .centre = rw_if_negative(from_middle, l->centre, r->centre),
        .centre_low = rw_if_negative(from_middle, l->centre_low, r->centre_low),
        .sine = {rw_if_negative(from_middle, l->sine[0], r->sine[0]),
                 rw_if_negative(from_middle, l->sine[1], r->sine[1])},
        .cosine = {rw_if_negative(from_middle, l->cosine[0], r->cosine[0]),
                   rw_if_negative(from_middle, l->cosine[1], r->cosine[1])},
        .sin_middle = rw_if_negative(from_middle, l->sin_middle, r->sin_middle),
        .slant = rw_if_negative(from_middle, l->slant, r->slant),
        .above = rw_if_negative(from_middle, l->above, r->above),
        .beside = rw_if_negative(from_middle, l->beside, r->beside),
        .clearance = rw_if_negative(from_middle, l->clearance, r->clearance),
        .side = rw_if_negative(from_middle, l->side, r->side),
        .arc_over = rw_if_negative(from_middle, l->arc_over, r->arc_over),
    };
}

RW_INLINE rw_side_place rw_side_place_of(const rw_eccentric *p, const rw_half_view *v, double sign,
                                         double x, double y)
{
    const double per_s = p->per_half_width, right = sign * x;
    return (rw_side_place){.x = (right - sign * p->middle) * per_s,
                           .y = y * per_s,
                           .beyond = (right - v->edge) * per_s,
                           .apex = ((right - v->centre) - v->centre_low) * per_s,
                           .past = {(right - v->end) * per_s, (right - v->other_end) * per_s}};
}

/* From the right half to where the point is: G(-conj z) = -conj G'(z), G' being that of the mirror
 * image. On the surface outside the contact there is no pressure, to the last bit. */
RW_INLINE rw_field rw_side_mirrored(double sign, rw_side_place at, rw_field right)
{
    const double pressed = rw_if_negative(at.beyond + 0.0, -1, 0 - at.y);
    return (rw_field){sign * right.G_re, rw_if_negative(pressed, right.G_im, 0), right.H_re,
                      sign * right.H_im};
}

typedef rw_field rw_side_formula(const rw_eccentric *p, const rw_half_view *v, rw_side_place at);

RW_INLINE rw_field rw_eccentric_by(rw_side_formula *right_field, const rw_eccentric *p,
                                   const rw_half_view *r, const rw_half_view *l, double x, double y)
{
    const double from_middle = (x - p->middle) + 0.0, sign = rw_if_negative(from_middle, -1, 1);
    const rw_half_view v = blended(r, l, from_middle);
    const rw_side_place at = rw_side_place_of(p, &v, sign, x, y);
    return rw_side_mirrored(sign, at, right_field(p, &v, at));
}

/* |R| < 1/4 */
static inline bool rw_eccentric_is_far(const rw_eccentric *p, double x, double y)
{
    const double far = 2.125 * p->half_width, dx = x - p->middle;
    return fabs(dx) > far || y > far || dx * dx + y * y > far * far;
}

/* The points, with the edge of the patch in place of far points and as filling of the last vector.
 * Returns how many are far. */
static inline int rw_near_points(const rw_eccentric *p, int count, const double x[],
                                 const double y[], double near_x[RW_BATCH], double near_y[RW_BATCH])
{
    int far = 0;
    for (int i = 0; i < RW_BATCH; i++) {
        const bool is_far = i < count && rw_eccentric_is_far(p, x[i], y[i]);
        const bool is_near = i < count && !is_far;
        near_x[i] = is_near ? x[i] : p->patch.right;
        near_y[i] = is_near ? y[i] : 0;
        far += is_far;
    }
    return far;
}

#endif
