/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed form of the potential of a patch off the centre. With z from the middle in half-widths,
 * z = sin(zeta), q = exp(i zeta) = i R, X = sqrt(z^2-1) = i cos(zeta), and the ends of the rounding
 * at sin(phi_0) and sin(phi_1), 2 alpha apart,
 *
 *     (pi/2) G  = h R - tan(mu) + i (z - sin(phi_n)) A + i l_f,   h = (phi_1 - phi_0)/(2 alpha), mu = (phi_0 + phi_1)/2,
 *     (pi/2) G' = i A - (h R + tan(mu))/X,                        A = (l_0 - l_1)/(2 alpha),
 *     l_j = ln(1 - exp(-i phi_j) q) - ln(1 + exp(i phi_j) q),
 *
 * n being the end nearer to the point and f the other. Where only one end is inside,
 *     pi alpha G = w R + e (i (z - sin(phi)) l - cos(phi)),   w = pi/2 - e phi,
 * e = 1 where the flank is on its left and -1 where it is on its right; of the sharp wedge (pi/2) G = i l.
 *
 * Far away the terms cancel, and the series in R is summed instead: (pi/2) G = sum (2/n) <sin n psi>
 * R^n, psi = pi/2 - phi and the mean that of patch.h. Points of the left half are those of the
 * mirror image's right half. */
#include "eccentric.h"

#include "domain.h"
#include "elliptic.h"
#include "logarithm.h"

/* ---- Preparation ---- */

static double square(double v)
{
    return v * v;
}

/* Of a patch within the rounding, which sees no more than its edges. */
static rw_half_view plain_view(const rw_eccentric *p, double side)
{
    return (rw_half_view){.edge = side > 0 ? p->patch.right : -p->patch.left};
}

static rw_half_view view_of(const rw_eccentric *p, double side)
{
    const rw_corners *k = &p->corners;
    const int first = side > 0 ? 0 : 1;
    const double sin_middle = side * k->sin_middle, up = fmax(sin_middle, 0);
    rw_half_view v = {
        .edge = side > 0 ? p->patch.right : -p->patch.left,
        .sine = {side * k->sine[first], side * k->sine[1 - first]},
        .cosine = {k->cosine[first], k->cosine[1 - first]},
        .sin_middle = sin_middle,
        .slant = sin_middle / k->cos_middle,
        .above = up,
        .beside = fmax(-sin_middle, 0),
        .clearance = sin_middle > 0 ? k->cosine[0] * k->cosine[1] / (k->cos_half + up) : k->cos_half,
    };
    v.end = -p->a;
    if (p->inside == 1) {
        const int in = v.cosine[1] > 0;
        v.end = in ? p->a : -p->a;
        v.side = in ? -1 : 1;
        v.sine[0] = v.sine[in];
        v.cosine[0] = v.cosine[in];
        v.arc_over = rw_angle(v.side * v.sine[0], v.cosine[0]) * k->per_alpha;
    }
    return v;
}

/* <sin n psi> is had from the sines and cosines of multiples of half the angle between the ends, and
 * of psi midway: (1/2 alpha) [cos((n-1) psi) sin((n-1) half)/(n-1) - cos((n+1) psi) sin((n+1) half)/(n+1)]. */
static void make_series(rw_eccentric *p)
{
    const rw_corners *k = &p->corners;
    double part[RW_SERIES_TERMS + 2]; /* cos(n psi) sin(n half)/(n alpha) */
    double cosine = 1, sine = 0, wave = 0, before = -1; /* wave: sin(n half)/sin(half) */
    part[0] = k->half_over;
    for (int n = 1; n < RW_SERIES_TERMS + 2; n++) {
        const double next = 2 * k->cos_half * wave - before;
        before = wave;
        wave = next;
        const double turned = cosine * k->sin_middle - sine * k->cos_middle;
        sine = sine * k->sin_middle + cosine * k->cos_middle;
        cosine = turned;
        part[n] = cosine * wave * k->sin_half_over / n;
    }
    for (int n = 1; n <= RW_SERIES_TERMS; n++)
        p->far[n - 1] = (part[n - 1] - part[n + 1]) / n;
}

void rw_eccentric_init(rw_eccentric *p, double a, rw_patch patch)
{
    const double s = rw_patch_half_width(patch);
    *p = (rw_eccentric){.patch = patch,
                        .middle = rw_patch_middle(patch),
                        .half_width = s,
                        .per_half_width = 1 / s,
                        .a = a};
    rw_potential_init_patch(&p->centred, a, s);
    p->is_centred = p->middle == 0;
    if (p->is_centred)
        return;
    if (patch.left >= -a && patch.right <= a) {
        p->view[0] = plain_view(p, 1);
        p->view[1] = plain_view(p, -1);
        p->far[0] = RW_HALF_PI * (s / a);
        return;
    }
    p->corners = rw_corners_of(a, patch);
    p->inside = p->corners.is_inside[0] + p->corners.is_inside[1];
    p->view[0] = view_of(p, 1);
    p->view[1] = view_of(p, -1);
    make_series(p);
}

/* ---- The formulas, for the right half ---- */

typedef struct {
    double x, y, beyond; /* from the middle and from the edge */
    double apex;         /* x from the apex */
    double past[2];      /* from the ends of the rounding, or [0] from the one that is inside */
} place;

/* l of one end: past is x - sine. 1 - sine sin(v) is a sum of squares. */
typedef struct {
    double re, im;
} complex_number;

RW_INLINE complex_number end_logarithm(double sine, double cosine, double past, double cosh_less_1,
                                       double shrink, const rw_elliptic *e)
{
    const double apart = e->sin_v - sine, size = past * past + e->y * e->y;
    const double b = e->cos_v * cosine +
                     0.5 * (e->cos_v * e->cos_v + cosine * cosine + apart * apart) + cosh_less_1;
    const double per_cosh = 1 / e->cosh_w;
    const double d = (sine * e->sinh_w * e->sinh_w - past) * per_cosh;
    static const double ZERO_SQUARED = 0x1p-1000;
    return (complex_number){
        .re = 0.5 * rw_log_of_quotient_over(size > ZERO_SQUARED ? size : ZERO_SQUARED, b * b,
                                            -2 * e->cos_v * cosine * b, 1, 1),
        .im = rw_angle(cosine * cosine * e->sinh_w + sine * d,
                       -cosine * (sine * e->sinh_w * shrink + past) * per_cosh),
    };
}

/* y/X times (re + i im) */
RW_INLINE complex_number over_X(const rw_elliptic *e, double y, double re, double im)
{
    const double X_re = e->sin_v * e->sinh_w, X_im = e->cos_v * e->cosh_w, scale = y / e->cos2;
    return (complex_number){scale * (re * X_re + im * X_im), scale * (im * X_re - re * X_im)};
}

/* A = (l_0 - l_1)/(2 alpha). With eta = (z - sin(phi_0)) ... the quotient of whose factors eta +- cos(zeta) sin(half)
 * l_0 - l_1 is the logarithm of, their product being (z - sin(phi_0))(z - sin(phi_1)). */
RW_INLINE complex_number difference_over(const rw_corners *k, const rw_half_view *v, place at,
                                         double cosh_less_1, const rw_elliptic *e)
{
    static const double ZERO_SQUARED = 0x1p-1000;
    const double s = k->sin_half, c = k->cos_half, cos_whole = c * c - s * s;
    const double eta_re = c * at.apex - v->sin_middle * s * s, eta_im = c * at.y;
    const double C_re = e->cos_v * e->cosh_w, C_im = -(e->sin_v * e->sinh_w);
    const double way = (eta_re - v->sin_middle * e->sinh_w * e->sinh_w) / e->cosh_w;
    const double sign = way < 0 ? -1 : 1, signed_s = sign * s;
    const double W_re = eta_re + signed_s * C_re, W_im = eta_im + signed_s * C_im;
    const double W = W_re * W_re + W_im * W_im, y2 = at.y * at.y;
    const double product = (at.past[0] * at.past[0] + y2) * (at.past[1] * at.past[1] + y2);
    const double log_over = rw_log_of_quotient_over(
        W * W, product > ZERO_SQUARED ? product : ZERO_SQUARED,
        4 * k->sin_half_over * e->cos_v * (sign * way) * W, k->alpha, k->per_alpha);
    const double turn =
        e->sinh_w * (c * cosh_less_1 + v->clearance +
                     v->above * (e->cos_v * e->cos_v / (1 + e->sin_v)) + v->beside * e->sin_v);
    const double eta2 = eta_re * eta_re + eta_im * eta_im;
    const double inner = eta2 - s * s * (e->cos_v * e->cos_v + e->sinh_w * e->sinh_w);
    const double x = inner * cos_whole + 4 * s * s * c * turn;
    const double y_over = 2 * k->sin_half_over * (c * inner - cos_whole * turn);
    return (complex_number){0.25 * sign * log_over, 0.5 * rw_angle_over(x, y_over, k->alpha, k->per_alpha)};
}

/* Hertz: G = R/alpha. */
RW_INLINE rw_field hertz_field(const rw_eccentric *p, const rw_half_view *v, place at)
{
    (void)v;
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e), per = p->half_width / p->a;
    const double R_re = per * (shrink * e.sin_v), R_im = -per * (shrink * e.cos_v);
    const complex_number steep = over_X(&e, at.y, R_re, R_im);
    return (rw_field){R_re, R_im, -steep.re, -steep.im};
}

RW_INLINE rw_field rounded_field(const rw_eccentric *p, const rw_half_view *v, place at)
{
    const rw_corners *k = &p->corners;
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e),
                 cosh_less_1 = e.sinh_w * e.sinh_w / (1 + e.cosh_w);
    const complex_number A = difference_over(k, v, at, cosh_less_1, &e);
    const bool second = at.apex >= 0; /* is nearer */
    const double near = second ? at.past[1] : at.past[0], far = second ? at.past[0] : at.past[1];
    const complex_number l = end_logarithm(second ? v->sine[0] : v->sine[1],
                                           second ? v->cosine[0] : v->cosine[1], far, cosh_less_1,
                                           shrink, &e);
    const double R_re = k->half_over * (shrink * e.sin_v), R_im = -k->half_over * (shrink * e.cos_v);
    const complex_number edge = over_X(&e, at.y, R_re + v->slant, R_im);
    return (rw_field){2 / RW_PI * (R_re - v->slant - (near * A.im + at.y * A.re) - l.im),
                      2 / RW_PI * (R_im + (near * A.re - at.y * A.im) + l.re),
                      2 / RW_PI * (-at.y * A.im - edge.re), 2 / RW_PI * (at.y * A.re - edge.im)};
}

RW_INLINE rw_field half_rounded_field(const rw_eccentric *p, const rw_half_view *v, place at)
{
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e),
                 cosh_less_1 = e.sinh_w * e.sinh_w / (1 + e.cosh_w);
    const complex_number l =
        end_logarithm(v->sine[0], v->cosine[0], at.past[0], cosh_less_1, shrink, &e);
    const double w = v->arc_over, per = v->side * p->corners.per_alpha, c = per * v->cosine[0];
    const double R_re = w * (shrink * e.sin_v), R_im = -w * (shrink * e.cos_v);
    const double l_re = per * l.re, l_im = per * l.im;
    const complex_number edge = over_X(&e, at.y, R_re + c, R_im);
    return (rw_field){1 / RW_PI * (R_re - c - (at.past[0] * l_im + at.y * l_re)),
                      1 / RW_PI * (R_im + (at.past[0] * l_re - at.y * l_im)),
                      1 / RW_PI * (-at.y * l_im - edge.re), 1 / RW_PI * (at.y * l_re - edge.im)};
}

RW_INLINE rw_field sharp_field(const rw_eccentric *p, const rw_half_view *v, place at)
{
    (void)p;
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e),
                 cosh_less_1 = e.sinh_w * e.sinh_w / (1 + e.cosh_w);
    const complex_number l =
        end_logarithm(v->sine[0], v->cosine[0], at.apex, cosh_less_1, shrink, &e);
    const double scale = v->cosine[0] / (at.apex * at.apex + at.y * at.y);
    const complex_number steep = over_X(&e, at.y, scale * at.apex, -scale * at.y);
    return (rw_field){-2 / RW_PI * l.im, 2 / RW_PI * l.re, -2 / RW_PI * steep.re,
                      -2 / RW_PI * steep.im};
}

/* The sums of far[n] R^n and of n far[n] R^n, by Horner. */
static rw_field series_field(const rw_eccentric *p, double R_re, double R_im,
                             complex_number y_over_X)
{
    complex_number sum = {0, 0}, steep = {0, 0};
    for (int n = RW_SERIES_TERMS; n > 0; n--) {
        sum = (complex_number){p->far[n - 1] + (sum.re * R_re - sum.im * R_im),
                               sum.re * R_im + sum.im * R_re};
        steep = (complex_number){n * p->far[n - 1] + (steep.re * R_re - steep.im * R_im),
                                 steep.re * R_im + steep.im * R_re};
    }
    const complex_number G = {sum.re * R_re - sum.im * R_im, sum.re * R_im + sum.im * R_re};
    const complex_number D = {steep.re * R_re - steep.im * R_im, steep.re * R_im + steep.im * R_re};
    const double u = y_over_X.re, v = y_over_X.im;
    return (rw_field){2 / RW_PI * G.re, 2 / RW_PI * G.im, -2 / RW_PI * (D.re * u - D.im * v),
                      -2 / RW_PI * (D.re * v + D.im * u)};
}

static rw_field far_field(const rw_eccentric *p, place at)
{
    if (rw_is_remote(at.x, at.y)) {
        const rw_ray ray = rw_ray_to(at.x, at.y);
        const complex_number y_over_z = {ray.sine * ray.cosine, -square(ray.sine)};
        return series_field(p, ray.R_re, ray.R_im, y_over_z);
    }
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    const double shrink = rw_elliptic_shrink(&e);
    return series_field(p, shrink * e.sin_v, -shrink * e.cos_v, over_X(&e, at.y, 1, 0));
}

/* ---- Points ---- */

RW_INLINE double either(bool left, double of_left, double of_right)
{
    return left ? of_left : of_right;
}

/* The view from one side: selections, which vector instructions have, and no choice of addresses. */
RW_INLINE rw_half_view blended(const rw_half_view *r, const rw_half_view *l, bool left)
{
    return (rw_half_view){
        .edge = either(left, l->edge, r->edge),
        .end = either(left, l->end, r->end),
        .sine = {either(left, l->sine[0], r->sine[0]), either(left, l->sine[1], r->sine[1])},
        .cosine = {either(left, l->cosine[0], r->cosine[0]),
                   either(left, l->cosine[1], r->cosine[1])},
        .sin_middle = either(left, l->sin_middle, r->sin_middle),
        .slant = either(left, l->slant, r->slant),
        .above = either(left, l->above, r->above),
        .beside = either(left, l->beside, r->beside),
        .clearance = either(left, l->clearance, r->clearance),
        .side = either(left, l->side, r->side),
        .arc_over = either(left, l->arc_over, r->arc_over),
    };
}

RW_INLINE place place_of(const rw_eccentric *p, const rw_half_view *v, double sign, double x,
                         double y)
{
    const double per_s = p->per_half_width, right = sign * x;
    return (place){.x = (right - sign * p->middle) * per_s,
                   .y = y * per_s,
                   .beyond = (right - v->edge) * per_s,
                   .apex = right * per_s,
                   .past = {(right - v->end) * per_s, (right - p->a) * per_s}};
}

/* From the right half to where the point is: G(-conj z) = -conj G'(z), G' being that of the mirror
 * image. On the surface outside the contact there is no pressure, to the last bit. */
RW_INLINE rw_field mirrored(double sign, place at, rw_field right)
{
    const double inside = at.beyond < 0 ? 1 : at.y;
    return (rw_field){sign * right.G_re, inside == 0 ? 0 : right.G_im, right.H_re,
                      sign * right.H_im};
}

typedef rw_field formula(const rw_eccentric *p, const rw_half_view *v, place at);

RW_INLINE rw_field field_of(formula *right_field, const rw_eccentric *p, const rw_half_view *r,
                            const rw_half_view *l, double x, double y)
{
    const bool left = x < p->middle;
    const double sign = left ? -1 : 1;
    const rw_half_view v = blended(r, l, left);
    const place at = place_of(p, &v, sign, x, y);
    return mirrored(sign, at, right_field(p, &v, at));
}

/* |R| < 1/4 */
static bool is_far(const rw_eccentric *p, double x, double y)
{
    const double far = 2.125 * p->half_width, dx = x - p->middle;
    return fabs(dx) > far || y > far || dx * dx + y * y > far * far;
}

static rw_field series_at(const rw_eccentric *p, double x, double y)
{
    const bool left = x < p->middle;
    const double sign = left ? -1 : 1;
    const place at = place_of(p, &p->view[left], sign, x, y);
    rw_eccentric one = *p; /* the coefficients of even powers change their sign */
    if (left)
        for (int n = 1; n < RW_SERIES_TERMS; n += 2)
            one.far[n] = -one.far[n];
    return mirrored(sign, at, far_field(&one, at));
}

rw_field rw_eccentric_at(const rw_eccentric *p, double x, double y)
{
    if (p->is_centred)
        return rw_potential_at(&p->centred, x, y);
    if (is_far(p, x, y))
        return series_at(p, x, y);
    if (p->inside == 0)
        return field_of(hertz_field, p, &p->view[0], &p->view[1], x, y);
    if (p->inside == 1)
        return field_of(half_rounded_field, p, &p->view[0], &p->view[1], x, y);
    return field_of(p->corners.per_alpha == 0 ? sharp_field : rounded_field, p, &p->view[0],
                    &p->view[1], x, y);
}

/* ---- Batches ---- */

enum { LANES = 8 };

/* Inlined for each formula and processor, the loop becomes vector instructions. */
RW_INLINE void apply(formula *right_field, const rw_eccentric *restrict p, int count,
                     const double *restrict x, const double *restrict y, rw_fields *restrict fields)
{
    const rw_eccentric own = *p;
    const rw_half_view right = p->view[0], left = p->view[1];
    for (int first = 0; first < count; first += LANES)
        for (int i = first; i < first + LANES; i++) {
            const rw_field field = field_of(right_field, &own, &right, &left, x[i], y[i]);
            fields->G_re[i] = field.G_re;
            fields->G_im[i] = field.G_im;
            fields->H_re[i] = field.H_re;
            fields->H_im[i] = field.H_im;
        }
}

RW_INLINE void apply_its_formula(const rw_eccentric *p, int count, const double x[],
                                 const double y[], rw_fields *fields)
{
    if (p->inside == 0)
        apply(hertz_field, p, count, x, y, fields);
    else if (p->inside == 1)
        apply(half_rounded_field, p, count, x, y, fields);
    else if (p->corners.per_alpha == 0)
        apply(sharp_field, p, count, x, y, fields);
    else
        apply(rounded_field, p, count, x, y, fields);
}

static void apply_baseline(const rw_eccentric *p, int count, const double x[], const double y[],
                           rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(RW_BASELINE)
__attribute__((target("avx2"))) static void apply_avx2(const rw_eccentric *p, int count,
                                                       const double x[], const double y[],
                                                       rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

static void apply_best(const rw_eccentric *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    (__builtin_cpu_supports("avx2") ? apply_avx2 : apply_baseline)(p, count, x, y, fields);
}
#else
static void apply_best(const rw_eccentric *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    apply_baseline(p, count, x, y, fields);
}
#endif

void rw_eccentric_fields(const rw_eccentric *p, int count, const double x[], const double y[],
                         rw_fields *fields)
{
    if (p->is_centred) {
        rw_potential_fields(&p->centred, count, x, y, fields);
        return;
    }
    double near_x[RW_BATCH], near_y[RW_BATCH];
    for (int i = 0; i < count; i++) {
        const bool far = is_far(p, x[i], y[i]);
        near_x[i] = far ? p->patch.right : x[i];
        near_y[i] = far ? 0 : y[i];
    }
    for (int i = count; i % LANES != 0; i++) { /* fills the last vector */
        near_x[i] = p->patch.right;
        near_y[i] = 0;
    }
    apply_best(p, count, near_x, near_y, fields);
    for (int i = 0; i < count; i++)
        if (is_far(p, x[i], y[i])) {
            const rw_field field = series_at(p, x[i], y[i]);
            fields->G_re[i] = field.G_re;
            fields->G_im[i] = field.G_im;
            fields->H_re[i] = field.H_re;
            fields->H_im[i] = field.H_im;
        }
}
