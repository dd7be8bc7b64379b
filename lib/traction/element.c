/* SPDX-License-Identifier: GPL-3.0-or-later */
#define RW_VECTORS
#include "traction/element.h"

#include "base/domain.h"
#include "traction/legendre.h"

/* Each of these loops gives a part of pi Omega as G, and its derivative as H, without y. It takes
 * so many lanes at a time: with RW_LANES it becomes vector instructions, with one it is quicker for
 * few places, to the same bits. */
#define RW_PARAMETERS                                                                              \
    (const rw_element *e, int count, const double x[], const double y[], rw_fields *fields)
#define RW_OF_ELEMENT(NAME, LOOP)                                                                  \
    RW_INLINE void NAME##_in_lanes RW_PARAMETERS                                                   \
    {                                                                                              \
        LOOP(RW_LANES, e, count, x, y, fields);                                                    \
    }                                                                                              \
    RW_DISPATCH(NAME##_by_vectors, NAME##_in_lanes, RW_PARAMETERS, (e, count, x, y, fields))       \
    static void NAME RW_PARAMETERS                                                                 \
    {                                                                                              \
        if (count < RW_WORTH_A_VECTOR)                                                             \
            LOOP(1, e, count, x, y, fields);                                                       \
        else                                                                                       \
            NAME##_by_vectors(e, count, x, y, fields);                                             \
    }

typedef void block(const rw_element *e, int count, const double x[], const double y[],
                   rw_fields *fields);

/* ---- Gauss's rule ---- */

/* Sums of four numbers at several places. */
typedef struct {
    double G_re[RW_LANES], G_im[RW_LANES], H_re[RW_LANES], H_im[RW_LANES];
} sums;

RW_INLINE void sum_at(int lanes, const rw_element *restrict e, int count, const double *restrict x,
                      const double *restrict y, rw_fields *restrict fields)
{
    for (int first = 0; first < count; first += lanes) {
        sums s = {{0}, {0}, {0}, {0}};
        for (int n = 0; n < RW_TERMS; n++)
            for (int i = 0; i < lanes; i++) {
                const double d = e->x[n] - x[first + i], h = y[first + i];
                const double share = 1 / (d * d + h * h), re = d * share, im = h * share;
                s.G_re[i] += e->load[n] * re;
                s.G_im[i] += e->load[n] * im;
                s.H_re[i] += e->load[n] * (re * re - im * im);
                s.H_im[i] += e->load[n] * (2 * re * im);
            }
        for (int i = 0; i < lanes; i++)
            rw_put(fields, first + i, (rw_field){s.G_re[i], s.G_im[i], s.H_re[i], s.H_im[i]});
    }
}

/* A pole's part from J and J' at zeta: the derivative by z is that by zeta over 2 scale zeta. */
RW_INLINE rw_field of_pole(const rw_element *e, rw_complex zeta, rw_complex value, rw_complex slope)
{
    const double size = fabs(e->scale), side = e->scale / size;
    const rw_complex rate = rw_quotient(slope, rw_multiple(2 * size, zeta));
    return (rw_field){side * value.re, side * value.im, rate.re, rate.im};
}

/* The places are zeta; load_i is c(u_i) du_i times twice u_i and the size of the scale. */
RW_INLINE void sum_pole_at(int lanes, const rw_element *restrict e, int count,
                           const double *restrict re, const double *restrict im,
                           rw_fields *restrict fields)
{
    const double share = 1 / (2 * fabs(e->scale));
    for (int first = 0; first < count; first += lanes) {
        sums s = {{0}, {0}, {0}, {0}};
        for (int n = 0; n < RW_TERMS; n++)
            for (int i = 0; i < lanes; i++) {
                const double d = e->u[n] - re[first + i], h = im[first + i];
                const double per = 1 / (e->u[n] * (d * d + h * h)), part = per * e->load[n];
                const double by = per * e->u[n];
                s.G_re[i] += part * d;
                s.G_im[i] += part * h;
                s.H_re[i] += part * by * (d * d - h * h);
                s.H_im[i] += part * by * (2 * d * h);
            }
        for (int i = 0; i < lanes; i++)
            rw_put(fields, first + i,
                   of_pole(e, (rw_complex){re[first + i], im[first + i]},
                           (rw_complex){share * s.G_re[i], share * s.G_im[i]},
                           (rw_complex){share * s.H_re[i], share * s.H_im[i]}));
    }
}

/* ---- Legendre's functions ---- */

/* v, and sums over Legendre's functions there, of several places. */
typedef struct {
    double re[RW_LANES], im[RW_LANES];
} numbers;

typedef struct {
    numbers v, value, rate;
} legendre_sums;

/* Adds the k-th term, and turns the function before it into the next one. */
RW_INLINE void turn(int lanes, double c, int k, const numbers *restrict now,
                    numbers *restrict before, legendre_sums *restrict s)
{
    for (int i = 0; i < lanes; i++) {
        const double re = s->v.re[i] * now->re[i] - s->v.im[i] * now->im[i];
        const double im = s->v.re[i] * now->im[i] + s->v.im[i] * now->re[i];
        s->value.re[i] += c * now->re[i];
        s->value.im[i] += c * now->im[i];
        s->rate.re[i] += k * c * (re - before->re[i]);
        s->rate.im[i] += k * c * (im - before->im[i]);
        before->re[i] = RW_LEGENDRE_RISE[k] * re - RW_LEGENDRE_FALL[k - 1] * before->re[i];
        before->im[i] = RW_LEGENDRE_RISE[k] * im - RW_LEGENDRE_FALL[k - 1] * before->im[i];
    }
}

/* Q_k' = k (v Q_k - Q_(k-1))/(v^2 - 1). */
RW_INLINE void near_pole_at(int lanes, const rw_element *restrict e, int count,
                            const double *restrict re, const double *restrict im,
                            rw_fields *restrict fields)
{
    const double per_half = 2 / (e->last - e->first);
    double c[RW_TERMS + 1] = {0};
    memcpy(c, e->coefficient, sizeof e->coefficient);
    for (int first = 0; first < count; first += lanes) {
        legendre_sums s;
        numbers q, next;
        for (int i = 0; i < lanes; i++) {
            const rw_complex v = {(re[first + i] - e->first) * per_half - 1,
                                  im[first + i] * per_half};
            const rw_complex Q = rw_first_function(v), vQ = rw_product(v, Q);
            s.v.re[i] = v.re;
            s.v.im[i] = v.im;
            q.re[i] = Q.re;
            q.im[i] = Q.im;
            next.re[i] = vQ.re - 1;
            next.im[i] = vQ.im;
            s.value.re[i] = c[0] * Q.re;
            s.value.im[i] = c[0] * Q.im;
            s.rate.re[i] = -c[0];
            s.rate.im[i] = 0;
        }
        for (int k = 1; k < e->terms; k += 2) {
            turn(lanes, c[k], k, &next, &q, &s);
            turn(lanes, c[k + 1], k + 1, &q, &next, &s);
        }
        for (int i = 0; i < lanes; i++) {
            const rw_complex v = {s.v.re[i], s.v.im[i]}, v2 = rw_product(v, v);
            const rw_complex slope = rw_quotient((rw_complex){s.rate.re[i], s.rate.im[i]},
                                                 (rw_complex){v2.re - 1, v2.im});
            rw_put(fields, first + i,
                   of_pole(e, (rw_complex){re[first + i], im[first + i]},
                           (rw_complex){-2 * s.value.re[i], -2 * s.value.im[i]},
                           rw_multiple(-2 * per_half, slope)));
        }
    }
}

/* zeta in the right half-plane, as G. */
RW_INLINE void zeta_at(int lanes, const rw_element *restrict e, int count, const double *restrict x,
                       const double *restrict y, rw_fields *restrict fields)
{
    const double per_scale = 1 / e->scale;
    for (int first = 0; first < count; first += lanes)
        for (int i = first; i < first + lanes; i++) {
            const double re = (x[i] - e->end) * per_scale, im = y[i] * per_scale;
            const double large = sqrt((sqrt(re * re + im * im) + fabs(re)) / 2),
                         small = fabs(im) / (2 * large + DBL_MIN);
            rw_put(fields, i,
                   (rw_field){rw_if_negative(re, small, large),
                              copysign(rw_if_negative(re, large, small), im), 0, 0});
        }
}

RW_OF_ELEMENT(sum_of, sum_at)
RW_OF_ELEMENT(sum_of_pole, sum_pole_at)
RW_OF_ELEMENT(near_pole, near_pole_at)
RW_OF_ELEMENT(zeta_of, zeta_at)

/* ---- Places ---- */

static void add(block *part_of, const rw_element *e, const rw_places *some, const double re[],
                const double im[], const double y[], rw_fields *sum)
{
    double own_re[RW_BATCH], own_im[RW_BATCH];
    rw_fields own;
    if (some->count == 0)
        return;
    rw_places_read(some, re, own_re);
    rw_places_read(some, im, own_im);
    part_of(e, some->count, own_re, own_im, &own);
    for (int i = 0; i < some->count; i++) {
        const double part = 1 / RW_PI, of_H = part * y[some->place[i]];
        rw_places_add(some, i,
                      (rw_field){part * own.G_re[i], part * own.G_im[i], of_H * own.H_re[i],
                                 of_H * own.H_im[i]},
                      sum);
    }
}

/* Where zeta is not near, -zeta is not either, and both poles are as one. */
void rw_add_element(const rw_element *e, const rw_places *places, const double x[],
                    const double y[], rw_fields *sum)
{
    double place_x[RW_BATCH], place_y[RW_BATCH], zeta[2][2][RW_BATCH];
    rw_places far, near[2], other;
    rw_fields root;
    far.count = near[0].count = near[1].count = other.count = 0; /* their places are not set */
    rw_places_read(places, x, place_x);
    rw_places_read(places, y, place_y);
    zeta_of(e, places->count, place_x, place_y, &root);
    for (int i = 0; i < places->count; i++) {
        const int place = places->place[i];
        const bool is_far = rw_is_far_from_element(e, place_x[i], place_y[i]);
        bool is_near[2];
        for (int k = 0; k < 2; k++) {
            const rw_complex pole =
                rw_multiple(k == 0 ? 1 : -1, (rw_complex){root.G_re[i], root.G_im[i]});
            zeta[k][0][place] = pole.re;
            zeta[k][1][place] = pole.im;
            is_near[k] = !is_far && rw_is_near_pole(rw_pole_place(e, pole));
        }
        rw_places_put(&far, place, !is_near[0]);
        rw_places_put(&near[0], place, is_near[0]);
        rw_places_put(&near[1], place, is_near[0] && is_near[1]);
        rw_places_put(&other, place, is_near[0] && !is_near[1]);
    }
    add(sum_of, e, &far, x, y, y, sum);
    add(near_pole, e, &near[0], zeta[0][0], zeta[0][1], y, sum);
    add(near_pole, e, &near[1], zeta[1][0], zeta[1][1], y, sum);
    add(sum_of_pole, e, &other, zeta[1][0], zeta[1][1], y, sum);
}
