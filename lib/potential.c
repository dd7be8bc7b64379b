/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed form of the potential. In elliptic coordinates z = sin(zeta), zeta = v + i w, w >= 0, it is Eq. (8) read at a
 * complex angle (lib/README.md, "The potential"):
 *
 *     G  = 1 + (i/pi) [ 2 ln E - ((z-alpha)/alpha) l - 2 (phi0/alpha) cos(zeta) ],
 *     G' = (i/pi) [ 2 (phi0/alpha) tan(zeta) - l/alpha ],
 *     E  = S+/(cos(zeta) + c0),   l = ln(S-/S+),   S+- = sin(zeta +- phi0) = c0 z +- alpha cos(zeta),
 *
 * for x >= 0; the other half follows by symmetry. sin v, cos v, sinh w, cosh w are nonnegative there and each is had from
 * z by square roots to full relative accuracy, so that sums of their products do not cancel. */
#include "potential.h"

#include "domain.h"
#include "elliptic.h"

/* Beyond this |z|^2 the closed form cancels like 1/z^2, and |R|^2 < 0.1: the series in R is exact with RW_FAR_TERMS. */
static const double FAR_SQUARED = 3.2; /* above 2 RW_NEAR^2 */

/* Below this the fourth powers of alpha and |z| would underflow. */
static const double TINY = 0x1p-200;

/* Brings such a point nearer to TINY, if need be repeatedly; |z|^2 stays negligible beside 1. */
static const double ZOOM = 0x1p150;

/* Below this, and |z| > TINY, the wedge is sharp to the last bit; and products of alpha and z might underflow. */
static const double SHARP = 0x1p-260;

typedef struct {
    double re, im;
} complex_number;

static complex_number product(complex_number a, complex_number b)
{
    return (complex_number){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static complex_number scaled(double factor, complex_number a)
{
    return (complex_number){factor * a.re, factor * a.im};
}

static complex_number sum(complex_number a, complex_number b)
{
    return (complex_number){a.re + b.re, a.im + b.im};
}

static double squared_modulus(complex_number a)
{
    return a.re * a.re + a.im * a.im;
}

/* b_n of the series in R, for n < RW_FAR_TERMS, from exp(i m phi0) by repeated rotation. Accurate absolutely, which is all
 * that a sum needs; rwedge_coefficient() has them relatively. */
static void far_coefficients(rw_potential *potential)
{
#define WEIGHT(n) (((n) % 2 ? -1 : 1) / (RW_PI * (2 * (n) + 1) * (n) * ((n) + 1))) /* 4 (-1)^n/(pi m (m^2-1)) */
    static const double weight[RW_FAR_TERMS] = {
        0,         WEIGHT(1), WEIGHT(2),  WEIGHT(3),  WEIGHT(4),  WEIGHT(5),  WEIGHT(6),  WEIGHT(7),
        WEIGHT(8), WEIGHT(9), WEIGHT(10), WEIGHT(11), WEIGHT(12), WEIGHT(13), WEIGHT(14), WEIGHT(15)};
#undef WEIGHT
    const double alpha = potential->alpha, c0 = potential->c0;
    potential->far[0] = 2 / RW_PI * (potential->phi0_over_alpha + c0);
    /* sin(m phi0)/alpha and cos(m phi0), m = 2n+1: with the sine divided by alpha, alpha = 0 is not special. */
    double sine = 1, cosine = c0;
    const double cos2 = (1 - alpha) * (1 + alpha) - alpha * alpha;
    for (int n = 1; n < RW_FAR_TERMS; n++) {
        const double next = sine * cos2 + cosine * 2 * c0;
        cosine = cosine * cos2 - sine * alpha * (2 * c0 * alpha);
        sine = next;
        potential->far[n] = weight[n] * ((2 * n + 1) * sine * c0 - cosine);
    }
}

void rw_potential_init_near(rw_potential *potential, double a, double c)
{
    const double alpha = a / c;
    potential->half_width = c;
    potential->per_half_width = 1 / c;
    potential->a = a;
    potential->alpha = alpha;
    potential->c0 = alpha < 1 ? sqrt((c - a) / c * (1 + alpha)) : 0;
    potential->phi0_over_alpha = alpha == 0 ? 1 : atan2(fmin(alpha, 1), potential->c0) / alpha;
}

void rw_potential_init(rw_potential *potential, double alpha)
{
    rw_potential_init_patch(potential, alpha, 1);
}

void rw_potential_init_patch(rw_potential *potential, double a, double c)
{
    rw_potential_init_near(potential, a, c);
    if (potential->alpha < 1) {
        far_coefficients(potential);
        return;
    }
    potential->far[0] = 1 / potential->alpha; /* Hertz: G = R/alpha */
    for (int n = 1; n < RW_FAR_TERMS; n++)
        potential->far[n] = 0;
}

/* Hertz: G = R/alpha, y G' = -y R/(X alpha), with R = -i exp(i zeta) and X = i cos(zeta). */
static rw_field hertz(double alpha, const rw_elliptic *e)
{
    const double shrink = rw_elliptic_shrink(e);
    const complex_number R = {shrink * e->sin_v, -shrink * e->cos_v};
    const complex_number X_conj = {e->sin_v * e->sinh_w, -e->cos_v * e->cosh_w};
    const complex_number R_over_X = product(R, X_conj);
    const double factor = -e->y / (e->cos_v * e->cos_v + e->sinh_w * e->sinh_w) / alpha;
    return (rw_field){R.re / alpha, R.im / alpha, factor * R_over_X.re, factor * R_over_X.im};
}

/* S+ and l/alpha, l = ln(S-/S+), S+- = A +- B, A = c0 z, B = alpha cos(zeta). */
typedef struct {
    complex_number total; /* S+: the factor of larger modulus, as x >= 0 */
    complex_number over_alpha;
} ratio_logarithm;

/* Far from the rounding, |B| < |A|/2, l is small and needs relative accuracy because it is divided by alpha. Nearer,
 * (A-B)(A+B) = (z-alpha)(z+alpha) gives the small factor from differences that are exact; past is x - alpha. */
static ratio_logarithm log_of_ratio(const rw_potential *p, const rw_elliptic *e, double past, complex_number cos_zeta)
{
    const double alpha = p->alpha, c0 = p->c0;
    const complex_number A = {c0 * e->x, c0 * e->y};
    const complex_number B = {alpha * cos_zeta.re, alpha * cos_zeta.im};
    ratio_logarithm r;
    r.total = (complex_number){A.re + B.re, e->sinh_w * (c0 * e->cos_v - alpha * e->sin_v)};
    if (alpha < SHARP) { /* the limit of l/alpha is -2 cos(zeta)/z */
        const double per_z2 = -2 / squared_modulus((complex_number){e->x, e->y});
        r.over_alpha = product(cos_zeta, (complex_number){e->x * per_z2, -e->y * per_z2});
        return r;
    }
    double log_re, log_im;
    if (4 * squared_modulus(B) < squared_modulus(A)) {
        const complex_number difference = {A.re - B.re, A.im - B.im};
        const double cross = c0 * alpha;
        log_re = -0.5 * log1p(4 * cross * e->sin_v * e->cos_v / squared_modulus(difference));
        log_im = atan2(2 * cross * e->sinh_w * e->cosh_w, squared_modulus(A) - squared_modulus(B));
    } else {
        const complex_number minus = {past, e->y}, plus = {e->x + alpha, e->y};
        const complex_number conj = {r.total.re, -r.total.im};
        const complex_number factors = product(minus, plus);
        const complex_number ratio = product(product(factors, conj), conj);
        const double small = squared_modulus(factors), large = squared_modulus(r.total);
        if (small < DBL_MIN) { /* z = alpha: finite there, as l is multiplied by z - alpha or y */
            r.over_alpha = (complex_number){0, 0};
            return r;
        }
        log_re = 0.5 * log(small / (large * large));
        log_im = atan2(ratio.im, ratio.re);
    }
    r.over_alpha = (complex_number){log_re / alpha, log_im / alpha};
    return r;
}

/* alpha < 1, |z| of a few at most. */
static rw_field near_field(const rw_potential *p, const rw_elliptic *e, double past)
{
    const complex_number cos_zeta = {e->cos_v * e->cosh_w, -e->sin_v * e->sinh_w};
    const ratio_logarithm l = log_of_ratio(p, e, past, cos_zeta);
    const complex_number denominator = {cos_zeta.re + p->c0, cos_zeta.im};
    const complex_number E = product(l.total, (complex_number){denominator.re, -denominator.im});
    const double log_E2 = log(squared_modulus(l.total) / squared_modulus(denominator));
    const double arg_E = atan2(E.im, E.re);
    const complex_number z_l = product((complex_number){past, e->y}, l.over_alpha);
    const double twice = 2 * p->phi0_over_alpha;
    const double W_re = log_E2 - z_l.re - twice * cos_zeta.re;
    const double W_im = 2 * arg_E - z_l.im - twice * cos_zeta.im;
    const double per_cos2 = twice / (e->cos_v * e->cos_v + e->sinh_w * e->sinh_w);
    const double V_re = per_cos2 * e->sin_v * e->cos_v - l.over_alpha.re;
    const double V_im = per_cos2 * e->sinh_w * e->cosh_w - l.over_alpha.im;
    const double y_per_pi = e->y / RW_PI;
    return (rw_field){1 - W_im / RW_PI, W_re / RW_PI, -y_per_pi * V_im, y_per_pi * V_re};
}

/* G = sum b_n R^(2n+1), G' = -sum (2n+1) b_n R^(2n+1)/X. */
static rw_field far_field(const rw_potential *p, const rw_elliptic *e)
{
    const double shrink = rw_elliptic_shrink(e);
    const complex_number R = {shrink * e->sin_v, -shrink * e->cos_v};
    const complex_number R2 = product(R, R);
    complex_number plain = {0, 0}, weighted = {0, 0};
    for (int n = RW_FAR_TERMS - 1; n >= 0; n--) {
        plain = product(plain, R2);
        plain.re += p->far[n];
        weighted = product(weighted, R2);
        weighted.re += (2 * n + 1) * p->far[n];
    }
    const complex_number X_conj = {e->sin_v * e->sinh_w, -e->cos_v * e->cosh_w};
    const double factor = -e->y / squared_modulus(X_conj);
    const complex_number G = product(plain, R);
    const complex_number dG = product(product(weighted, R), X_conj);
    return (rw_field){G.re, G.im, factor * dG.re, factor * dG.im};
}

/* G = b_0 R, y G' = -y b_0 R/z. */
static rw_field remote_field(const rw_potential *p, double x, double y)
{
    const rw_ray ray = rw_ray_to(x, y);
    const complex_number G = scaled(p->far[0], (complex_number){ray.R_re, ray.R_im});
    const complex_number H = scaled(-ray.sine, product(G, (complex_number){ray.cosine, -ray.sine}));
    return (rw_field){G.re, G.im, H.re, H.im};
}

/* A point of the right half, over the half-width, and the differences that count where they are small. */
typedef struct {
    double x, y;
    double beyond, past; /* x - 1, x - alpha */
} place;

static place place_of(const rw_potential *p, double x, double y)
{
    const double per_c = p->per_half_width, right = fabs(x);
    return (place){.x = right * per_c,
                   .y = y * per_c,
                   .beyond = (right - p->half_width) * per_c,
                   .past = (right - p->a) * per_c};
}

static bool is_at_apex(const rw_potential *p, place at)
{
    return p->alpha < TINY && at.x < TINY && at.y < TINY;
}

static place zoomed_place(place at)
{
    return (place){.x = at.x * ZOOM, .y = at.y * ZOOM, .beyond = -1, .past = at.past * ZOOM};
}

static rw_field field_right(const rw_potential *p, place at);

/* alpha and |z| so small that their squares underflow: the fields depend on z/alpha and ln(alpha) alone there, and only
 * Im G has the logarithm. */
static rw_field apex_field(const rw_potential *p, place at)
{
    rw_potential zoomed = *p;
    zoomed.alpha *= ZOOM;
    rw_field field = field_right(&zoomed, zoomed_place(at));
    field.G_im -= 2 / RW_PI * log(ZOOM);
    return field;
}

static rw_field field_right(const rw_potential *p, place at)
{
    if (rw_is_remote(at.x, at.y))
        return remote_field(p, at.x, at.y);
    if (is_at_apex(p, at))
        return apex_field(p, at);
    rw_elliptic e;
    if (!rw_elliptic_coordinates(at.x, at.y, at.beyond, &e))
        return (rw_field){p->alpha > 1 ? 1 / p->alpha : 1, 0, 0, 0};
    if (p->alpha >= 1)
        return hertz(p->alpha, &e);
    if (at.x * at.x + at.y * at.y > FAR_SQUARED)
        return far_field(p, &e);
    return near_field(p, &e, at.past);
}

rw_field rw_potential_at(const rw_potential *potential, double x, double y)
{
    rw_field field = field_right(potential, place_of(potential, x, y));
    if (x < 0) { /* p is even: G(-conj z) = -conj G(z) */
        field.G_re = -field.G_re;
        field.H_im = -field.H_im;
    }
    if (y == 0 && fabs(x) >= potential->half_width)
        field.G_im = 0; /* no pressure, to the last bit */
    return field;
}

static complex_number y_over(double y, complex_number a)
{
    return scaled(y / squared_modulus(a), (complex_number){a.re, -a.im});
}

/* G''  =  (2/pi) [ c0/(X q) + (phi0/alpha)/X^3 ],   q = (z-alpha)(z+alpha),
 * G''' = -(2/pi) z [ c0/(X^3 q) + 2 c0/(X q^2) + 3 (phi0/alpha)/X^5 ],   made of ratios of y, which neither under- nor
 * overflow. For Hertz c0 = 0. */
static rw_curvature curvature_right(const rw_potential *potential, place at)
{
    if (is_at_apex(potential, at)) { /* K and L depend on z/alpha alone */
        rw_potential zoomed = *potential;
        zoomed.alpha *= ZOOM;
        return curvature_right(&zoomed, zoomed_place(at));
    }
    const double x = at.x, y = at.y;
    rw_elliptic e;
    if (!rw_elliptic_coordinates(x, y, at.beyond, &e))
        return (rw_curvature){0, 0, 0, 0};
    const complex_number per_X = y_over(1, (complex_number){e.sin_v * e.sinh_w, e.cos_v * e.cosh_w});
    const complex_number y2_per_X2 = scaled(y * y, product(per_X, per_X));
    const complex_number y2_per_q =
        product(y_over(y, (complex_number){at.past, y}), y_over(y, (complex_number){x + potential->alpha, y}));
    const complex_number z_per_y = {x / y, 1};
    const complex_number corner = scaled(potential->c0, y2_per_q);
    const complex_number edge = scaled(potential->phi0_over_alpha, y2_per_X2);
    const complex_number K = scaled(2 / RW_PI, product(sum(corner, edge), per_X));
    const complex_number steepness = sum(product(corner, sum(y2_per_X2, scaled(2, y2_per_q))),
                                         scaled(3, product(edge, y2_per_X2)));
    const complex_number L = scaled(-2 / RW_PI, product(product(steepness, z_per_y), per_X));
    return (rw_curvature){K.re, K.im, L.re, L.im};
}

rw_curvature rw_potential_curvature(const rw_potential *potential, double x, double y)
{
    return curvature_right(potential, place_of(potential, x, y));
}
