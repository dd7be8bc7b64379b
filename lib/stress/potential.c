/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed form of the potential. In elliptic coordinates z = sin(zeta), zeta = v + i w, w >=
 * 0, it is Eq. (8) read at a complex angle (lib/README.md, "The potential"). With R = z - X = -i
 * exp(i zeta), X = sqrt(z^2-1) = i cos(zeta),
 *
 *     G  =  (2/pi) [ B - ((z-alpha)/alpha) A + (phi0/alpha) R ],     S+- = sin(zeta +- phi0),
 *     G' = -(2/pi) [ A/alpha + (phi0/alpha) R/X ],                   A = (i/2) ln( e^(-2i phi0) S-/S+ ),
 *     B  = i ln( -i e^(i phi0) S+/(cos(zeta) + c0) )
 *
 * for x >= 0; the other half follows by symmetry. Nothing in it is large that cancels: near z =
 * alpha, where A is infinite, it is multiplied by z - alpha, and far away A, B and R all are
 * small, as G is. sin v, cos v, sinh w, cosh w are nonnegative and each is had from z by square
 * roots to full relative accuracy.
 *
 * Points come one by one or in batches. The formula for a point is a straight line without a
 * call or a branch, so that compilers turn the loop over a batch into vector instructions. These
 * round as the others do: a batch gives the bits of its points one by one. */
#include "stress/potential.h"

#include "base/domain.h"
#include "stress/elliptic.h"
#include "base/logarithm.h"

/* Below this the fourth powers of alpha and |z| would underflow. */
static const double TINY = 0x1p-200;

/* Brings such a point nearer to TINY, if need be repeatedly; |z|^2 stays negligible beside 1. */
static const double ZOOM = 0x1p150;
static const double LN_ZOOM = 150 * RW_LN2;

/* Below this, and |z| > TINY, the wedge is sharp to the last bit; and products of alpha and z
 * might underflow. */
static const double SHARP = 0x1p-260;

/* ---- Preparation ---- */

static double reciprocal(double alpha)
{
    return alpha < SHARP ? 0 : 1 / alpha;
}

void rw_potential_init_patch(rw_potential *potential, double a, double c)
{
    const double alpha = a / c;
    potential->half_width = c;
    potential->per_half_width = 1 / c;
    potential->a = a;
    potential->alpha = alpha;
    potential->per_alpha = reciprocal(alpha);
    potential->c0 = alpha < 1 ? sqrt((c - a) / c * (1 + alpha)) : 0;
    potential->phi0_over_alpha = alpha == 0 ? 1 : rw_angle(potential->c0, fmin(alpha, 1)) / alpha;
}

void rw_potential_init(rw_potential *potential, double alpha)
{
    rw_potential_init_patch(potential, alpha, 1);
}

/* b_0, A P/(theta b) times 2/pi. */
static double first_coefficient(const rw_potential *p)
{
    return p->alpha < 1 ? 2 / RW_PI * (p->phi0_over_alpha + p->c0) : 1 / p->alpha;
}

/* b_n of the series in R, for n < RW_FAR_TERMS, from exp(i m phi0) by repeated rotation.
 * Accurate absolutely, which is all that a sum needs; rwedge_coefficient() has them relatively. */
void rw_potential_far_coefficients(const rw_potential *potential, double far[RW_FAR_TERMS])
{
#define WEIGHT(n)                                                                                  \
    (((n) % 2 ? -1 : 1) / (RW_PI * (2 * (n) + 1) * (n) * ((n) + 1))) /* 4 (-1)^n/(pi m (m^2-1)) */
    static const double weight[RW_FAR_TERMS] = {0,          WEIGHT(1),  WEIGHT(2),  WEIGHT(3),
                                                WEIGHT(4),  WEIGHT(5),  WEIGHT(6),  WEIGHT(7),
                                                WEIGHT(8),  WEIGHT(9),  WEIGHT(10), WEIGHT(11),
                                                WEIGHT(12), WEIGHT(13), WEIGHT(14), WEIGHT(15)};
#undef WEIGHT
    const double alpha = potential->alpha, c0 = potential->c0;
    far[0] = first_coefficient(potential);
    for (int n = 1; n < RW_FAR_TERMS; n++)
        far[n] = 0;
    if (alpha >= 1) /* Hertz: G = R/alpha */
        return;
    /* sin(m phi0)/alpha and cos(m phi0), m = 2n+1: with the sine divided by alpha, alpha = 0 is
     * not special. */
    double sine = 1, cosine = c0;
    const double cos2 = (1 - alpha) * (1 + alpha) - alpha * alpha;
    for (int n = 1; n < RW_FAR_TERMS; n++) {
        const double next = sine * cos2 + cosine * 2 * c0;
        cosine = cosine * cos2 - sine * alpha * (2 * c0 * alpha);
        sine = next;
        far[n] = weight[n] * ((2 * n + 1) * sine * c0 - cosine);
    }
}

/* ---- The formulas, for x >= 0 ---- */

/* A point of the right half, over the half-width, and the differences that count where they are
 * small. */
typedef struct {
    double x, y;
    double beyond, past; /* x - 1, x - alpha */
} place;

/* Hertz: G = R/alpha, y G' = -y R/(X alpha). */
RW_INLINE rw_field hertz_field_at(const rw_potential *p, place at, rw_elliptic e)
{
    const double shrink = rw_elliptic_shrink(&e), factor = -at.y / e.cos2 * p->per_alpha;
    return (rw_field){shrink * e.sin_v * p->per_alpha, -shrink * e.cos_v * p->per_alpha,
                      factor * rw_elliptic_RX_re(&e, shrink), factor * -(e.sin_v * e.cos_v)};
}

/* The imaginary part of A over alpha, (1/2) ln|S-/S+|. S+ S- is (z-alpha)(z+alpha), whose
 * factors are exact differences, and |sin(v + i w)|^2 = sin(v)^2 + sinh(w)^2, so that |S+|^2 -
 * |S-|^2 = 4 c0 alpha sin(v) cos(v). */
RW_INLINE double log_part_of_A(const rw_potential *p, const rw_elliptic *e, double past)
{
    /* for the logarithm at z = alpha any positive number will do */
    static const double ZERO_SQUARED = 0x1p-1000;
    const double plus = e->x + p->alpha, y2 = e->y * e->y;
    const double sine = p->c0 * e->sin_v + p->alpha * e->cos_v;
    const double sum2 = sine * sine + e->sinh_w * e->sinh_w;
    const double product2 = (past * past + y2) * (plus * plus + y2);
    return -0.25 *
           rw_log_of_quotient_over(sum2 * sum2, product2 > ZERO_SQUARED ? product2 : ZERO_SQUARED,
                                   4 * p->c0 * e->sin_v * e->cos_v * sum2, p->alpha, p->per_alpha);
}

/* The real part of A over alpha, phi0/alpha less half the angle of S-/S+. As sums over cosh(w)
 * and sinh(w) of which cosh(w) - sinh(w) is `shrink`, neither side of the triangle cancels for
 * large w. */
RW_INLINE double angle_part_of_A(const rw_potential *p, const rw_elliptic *e, double shrink)
{
    const double alpha = p->alpha, c0 = p->c0, cos_2phi0 = 1 - 2 * alpha * alpha,
                 sin_2phi0 = 2 * alpha * c0;
    const double from_corner = e->sin_v * e->sin_v - alpha * alpha;
    const double x = cos_2phi0 * (from_corner + cos_2phi0 * (e->sinh_w * e->sinh_w)) +
                     sin_2phi0 * sin_2phi0 * (e->sinh_w * e->cosh_w);
    const double y = 2 * c0 * (from_corner - cos_2phi0 * (e->sinh_w * shrink));
    return 0.5 * rw_angle_over(x, y, alpha, p->per_alpha);
}

/* alpha < 1. With half the angles E = S+/(cos(zeta) + c0) is (E_re + i E_im)/E_size, all of it
 * nonnegative, and |E|^2 - 1 = -2 c0 cos(v)/E_size. */
RW_INLINE rw_field rounded_field_at(const rw_potential *p, place at, rw_elliptic e)
{
    const double shrink = rw_elliptic_shrink(&e), alpha = p->alpha, c0 = p->c0;
    const double A_im = log_part_of_A(p, &e, at.past), A_re = angle_part_of_A(p, &e, shrink);

    const double E_re = e.sin_v + alpha * e.cosh_w, E_im = c0 * e.sinh_w;
    const double E_size = e.cosh_w + c0 * e.cos_v + alpha * e.sin_v;
    const double B_im = 0.5 * rw_log_of_quotient_over(E_re * E_re + E_im * E_im, E_size * E_size,
                                                      -2 * c0 * e.cos_v * E_size, 1, 1);
    const double B_re = rw_angle(alpha * E_re + c0 * E_im, c0 * (e.sin_v + alpha * shrink));

    const double per = p->phi0_over_alpha, per_cos2 = per / e.cos2;
    const double G_re = B_re - (at.past * A_re - at.y * A_im) + per * (shrink * e.sin_v);
    const double G_im = B_im - (at.past * A_im + at.y * A_re) - per * (shrink * e.cos_v);
    const double D_re = A_re + per_cos2 * rw_elliptic_RX_re(&e, shrink);
    const double D_im = A_im - per_cos2 * (e.sin_v * e.cos_v);
    const double y = -(2 / RW_PI) * at.y;
    return (rw_field){2 / RW_PI * G_re, 2 / RW_PI * G_im, y * D_re, y * D_im};
}

RW_INLINE rw_field hertz_field(const rw_potential *p, place at)
{
    return hertz_field_at(p, at, rw_elliptic_at(at.x, at.y, at.beyond));
}

RW_INLINE rw_field rounded_field(const rw_potential *p, place at)
{
    return rounded_field_at(p, at, rw_elliptic_at(at.x, at.y, at.beyond));
}

/* G = b_0 R, y G' = -y b_0 R/z. */
static rw_field remote_field(const rw_potential *p, place at)
{
    const rw_ray ray = rw_ray_to(at.x, at.y);
    const double b0 = first_coefficient(p);
    const double G_re = b0 * ray.R_re, G_im = b0 * ray.R_im;
    return (rw_field){G_re, G_im, -ray.sine * (G_re * ray.cosine + G_im * ray.sine),
                      -ray.sine * (G_im * ray.cosine - G_re * ray.sine)};
}

static bool is_at_apex(const rw_potential *p, place at)
{
    return p->alpha < TINY && at.x < TINY && at.y < TINY;
}

static place zoomed_place(place at)
{
    return (place){.x = at.x * ZOOM, .y = at.y * ZOOM, .beyond = -1, .past = at.past * ZOOM};
}

static rw_potential zoomed_potential(const rw_potential *p)
{
    rw_potential zoomed = *p;
    zoomed.alpha *= ZOOM;
    zoomed.per_alpha = reciprocal(zoomed.alpha);
    return zoomed;
}

/* alpha and |z| so small that their squares underflow: the fields depend on z/alpha and
 * ln(alpha) alone there, and only Im G has the logarithm. */
static rw_field apex_field(const rw_potential *p, place at)
{
    if (!is_at_apex(p, at))
        return rounded_field(p, at);
    const rw_potential zoomed = zoomed_potential(p);
    rw_field field = apex_field(&zoomed, zoomed_place(at));
    field.G_im -= 2 / RW_PI * LN_ZOOM;
    return field;
}

/* ---- Points ---- */

RW_INLINE place place_of(const rw_potential *p, double x, double y)
{
    const double per_c = p->per_half_width, right = fabs(x);
    return (place){.x = right * per_c,
                   .y = y * per_c,
                   .beyond = (right - p->half_width) * per_c,
                   .past = (right - p->a) * per_c};
}

/* From the right half to where the point is: p is even, G(-conj z) = -conj G(z). On the surface
 * outside the contact there is no pressure, to the last bit. */
RW_INLINE rw_field mirrored(const rw_potential *p, double x, double y, rw_field right)
{
    const double sign = x < 0 ? -1 : 1, inside = fabs(x) < p->half_width ? 1 : y;
    return (rw_field){sign * right.G_re, inside == 0 ? 0 : right.G_im, right.H_re,
                      sign * right.H_im};
}

rw_field rw_potential_at(const rw_potential *potential, double x, double y)
{
    const place at = place_of(potential, x, y);
    if (rw_is_remote(at.x, at.y))
        return mirrored(potential, x, y, remote_field(potential, at));
    if (potential->alpha >= 1)
        return mirrored(potential, x, y, hertz_field(potential, at));
    if (is_at_apex(potential, at))
        return mirrored(potential, x, y, apex_field(potential, at));
    return mirrored(potential, x, y, rounded_field(potential, at));
}

/* ---- Batches ---- */

enum { LANES = 8 };          /* a multiple of what vector units hold */
enum { WORTH_A_VECTOR = 3 }; /* two points are quicker one by one */

RW_INLINE void put(rw_fields *fields, int i, rw_field field)
{
    fields->G_re[i] = field.G_re;
    fields->G_im[i] = field.G_im;
    fields->H_re[i] = field.H_re;
    fields->H_im[i] = field.H_im;
}

typedef rw_field formula(const rw_potential *p, place at);

/* Inlined for each formula and processor, the loop becomes vector instructions. */
RW_INLINE void apply(formula *right_field, const rw_potential *restrict p, int count,
                     const double *restrict x, const double *restrict y, rw_fields *restrict fields)
{
    for (int first = 0; first < count; first += LANES)
        for (int i = first; i < first + LANES; i++) {
            const rw_field right = right_field(p, place_of(p, x[i], y[i]));
            put(fields, i, mirrored(p, x[i], y[i], right));
        }
}

RW_INLINE void apply_its_formula(const rw_potential *p, int count, const double x[],
                                 const double y[], rw_fields *fields)
{
    if (p->alpha >= 1)
        apply(hertz_field, p, count, x, y, fields);
    else
        apply(rounded_field, p, count, x, y, fields);
}

static void apply_baseline(const rw_potential *p, int count, const double x[], const double y[],
                           rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

/* The same for processors with vectors of four numbers, which the baseline of x86-64 does not
 * have. */
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(RW_BASELINE)
__attribute__((target("avx2"))) static void
apply_avx2(const rw_potential *p, int count, const double x[], const double y[], rw_fields *fields)
{
    apply_its_formula(p, count, x, y, fields);
}

static void apply_best(const rw_potential *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    (__builtin_cpu_supports("avx2") ? apply_avx2 : apply_baseline)(p, count, x, y, fields);
}
#else
static void apply_best(const rw_potential *p, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    apply_baseline(p, count, x, y, fields);
}
#endif

/* Remote, or at the apex of a tip so small that its squares underflow. */
static bool is_extreme(const rw_potential *p, double x, double y)
{
    const place at = place_of(p, x, y);
    return rw_is_remote(at.x, at.y) || is_at_apex(p, at);
}

void rw_potential_fields(const rw_potential *potential, int count, const double x[],
                         const double y[], rw_fields *fields)
{
    if (count < WORTH_A_VECTOR) {
        for (int i = 0; i < count; i++)
            put(fields, i, rw_potential_at(potential, x[i], y[i]));
        return;
    }
    double usual_x[RW_BATCH], usual_y[RW_BATCH];
    bool extreme = false;
    for (int i = 0; i < count; i++) {
        const bool is_usual = !is_extreme(potential, x[i], y[i]);
        usual_x[i] = is_usual ? x[i] : potential->half_width;
        usual_y[i] = is_usual ? y[i] : 0;
        extreme = extreme || !is_usual;
    }
    for (int i = count; i % LANES != 0; i++) { /* fills the last vector */
        usual_x[i] = usual_x[count - 1];
        usual_y[i] = usual_y[count - 1];
    }
    apply_best(potential, count, usual_x, usual_y, fields);
    for (int i = 0; extreme && i < count; i++)
        if (is_extreme(potential, x[i], y[i]))
            put(fields, i, rw_potential_at(potential, x[i], y[i]));
}

/* ---- Curvature ---- */

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

static complex_number y_over(double y, complex_number a)
{
    return scaled(y / squared_modulus(a), (complex_number){a.re, -a.im});
}

/* G''  =  (2/pi) [ c0/(X q) + (phi0/alpha)/X^3 ],   q = (z-alpha)(z+alpha),
 * G''' = -(2/pi) z [ c0/(X^3 q) + 2 c0/(X q^2) + 3 (phi0/alpha)/X^5 ],   made of ratios of y, which neither under- nor
 * overflow. For Hertz c0 = 0. */
static rw_curvature curvature_at(const rw_potential *p, place at, rw_elliptic e)
{
    const complex_number per_X =
        y_over(1, (complex_number){e.sin_v * e.sinh_w, e.cos_v * e.cosh_w});
    const complex_number y2_per_X2 = scaled(at.y * at.y, product(per_X, per_X));
    const complex_number y2_per_q = product(y_over(at.y, (complex_number){at.past, at.y}),
                                            y_over(at.y, (complex_number){at.x + p->alpha, at.y}));
    const complex_number z_per_y = {at.x / at.y, 1};
    const complex_number corner = scaled(p->c0, y2_per_q);
    const complex_number edge = scaled(p->phi0_over_alpha, y2_per_X2);
    const complex_number K = scaled(2 / RW_PI, product(sum(corner, edge), per_X));
    const complex_number steepness = sum(product(corner, sum(y2_per_X2, scaled(2, y2_per_q))),
                                         scaled(3, product(edge, y2_per_X2)));
    const complex_number L = scaled(-2 / RW_PI, product(product(steepness, z_per_y), per_X));
    return (rw_curvature){K.re, K.im, L.re, L.im};
}

rw_field rw_potential_with_curvature(const rw_potential *potential, double x, double y,
                                     rw_curvature *curvature)
{
    const place at = place_of(potential, x, y);
    const rw_elliptic e = rw_elliptic_at(at.x, at.y, at.beyond);
    *curvature = curvature_at(potential, at, e);
    if (potential->alpha >= 1)
        return hertz_field_at(potential, at, e);
    return rounded_field_at(potential, at, e);
}
