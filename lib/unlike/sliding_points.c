/* SPDX-License-Identifier: GPL-3.0-or-later */
#define RW_VECTORS
#include "unlike/sliding_points.h"

#include "base/domain.h"
#include "base/exponential.h"
#include "unlike/real_series.h"

/* Beyond so many half-widths from the middle the terms would cancel: it is a series in 1/z
 * there. */
static const double FAR = 3;

/* The square of a distance that is none. */
static const double NONE = 1e-290;

/* ---- Before the parts ---- */

RW_INLINE void begin_at(double a, rw_sliding_points *restrict p, int i)
{
    const rw_complex left = {p->from_left[i], p->height[i]},
                     right = {p->from_right[i], p->height[i]};
    const double size_left = left.re * left.re + left.im * left.im + NONE,
                 size_right = right.re * right.re + right.im * right.im + NONE;
    const double angle_left = rw_angle(left.re, left.im),
                 angle_right = rw_angle(right.re, right.im);
    const double nearness = rw_log_of_quotient(size_left, size_right) / 2;
    const rw_complex V =
        rw_multiple(rw_exponential(a * nearness), rw_direction(a * (angle_left - angle_right)));
    const double per_left = 1 / size_left, per_right = 1 / size_right;
    const rw_complex over_left = {left.re * per_left, -left.im * per_left},
                     over_right = {right.re * per_right, -right.im * per_right};
    const rw_complex other = rw_product(V, rw_product(right, over_left));
    const rw_complex X_left = rw_product(V, right), X_right = rw_product(other, left),
                     Y_left = rw_product(V, over_left), Y_right = rw_product(other, over_right);
    p->size_left[i] = size_left;
    p->size_right[i] = size_right;
    p->angle_left[i] = angle_left;
    p->angle_right[i] = angle_right;
    p->V_re[i] = V.re;
    p->V_im[i] = V.im;
    p->other_re[i] = other.re;
    p->other_im[i] = other.im;
    p->X_re[i] = rw_if_negative(nearness, X_left.re, X_right.re);
    p->X_im[i] = rw_if_negative(nearness, X_left.im, X_right.im);
    p->Y_re[i] = rw_if_negative(nearness, Y_left.re, Y_right.re);
    p->Y_im[i] = rw_if_negative(nearness, Y_left.im, Y_right.im);
    p->all[i] = 1;
    p->G_re[i] = p->G_im[i] = p->D_re[i] = p->D_im[i] = p->J[i] = p->W[i] = 0;
}

RW_INLINE void begin(rw_sliding_points *restrict p, int vector)
{
    const double a = p->frame->rule->a;
    for (int first = 0; first < p->count; first += vector)
        for (int i = first; i < first + vector; i++)
            begin_at(a, p, i);
}

RW_INLINE void begin_vectors(rw_sliding_points *p)
{
    begin(p, RW_LANES);
}

RW_DISPATCH(begin_best, begin_vectors, (rw_sliding_points * p), (p))

enum { WORTH_A_VECTOR = 3 }; /* fewer points are quicker one by one */

void rw_sliding_points_begin(rw_sliding_points *p, const rw_sliding_frame *f, int n,
                             const double x[], const double y[])
{
    p->frame = f;
    p->turn = rw_direction(-RW_PI * f->rule->a);
    p->is_single = n < WORTH_A_VECTOR;
    p->count = p->is_single ? n : (n + RW_LANES - 1) / RW_LANES * RW_LANES;
    p->has_near = p->has_far = false;
    for (int i = 0; i < p->count; i++) { /* the last point fills the last vector */
        const int from = i < n ? i : n - 1;
        p->x[i] = x[from];
        p->z[i] = (x[from] - f->middle) / f->half;
        p->height[i] = y[from] / f->half;
        p->from_left[i] = (x[from] - f->patch.left) / f->half;
        p->from_right[i] = (x[from] - f->patch.right) / f->half;
        const bool is_far = p->z[i] * p->z[i] + p->height[i] * p->height[i] > FAR * FAR;
        p->has_near = p->has_near || !is_far;
        p->has_far = p->has_far || is_far;
    }
    if (p->is_single)
        begin(p, 1);
    else
        begin_best(p);
}

/* ---- A part ---- */

/* A bend or a kink, at the points that have a share of it. */
typedef struct {
    const rw_place *place;
    double weight; /* jump or step */
    bool is_kink;
    const double *share;
} part;

/* What a part has for both forms of X I: [0] of w, [1] of 1/w. */
typedef struct {
    rw_complex turn;
    double ratio[2], side[2], factor[2], whole[2];
    double at, half, square_left, square_right;
} view;

static view view_of(const rw_sliding_frame *f, rw_complex turn, const rw_place *t)
{
    view v = {.turn = turn,
              .ratio = {0, t->from_left / t->to_right},
              .side = {0, 2 / t->to_right},
              .factor = {0, 0},
              .whole = {0, f->whole},
              .at = t->at,
              .half = f->half,
              .square_left = t->from_left * t->from_left,
              .square_right = t->to_right * t->to_right};
    if (t->from_left > 0) {
        v.ratio[0] = t->to_right / t->from_left;
        v.side[0] = 2 / t->from_left;
        v.factor[0] = t->power;
        v.factor[1] = -t->power * v.ratio[1];
    }
    return v;
}

/* Points beside each other, as one part sees them. */
typedef struct {
    uint64_t kind[RW_LANES]; /* 1: 1/w; 2: near */
    double form[RW_LANES], farness[RW_LANES], log_re[RW_LANES], log_im[RW_LANES];
    rw_complex_lanes u, series;
} seen;

RW_INLINE void see(const rw_sliding_points *restrict p, const view *restrict v, int i, int k,
                   seen *restrict s)
{
    const double form = v->square_left * p->size_right[i] - v->square_right * p->size_left[i];
    const double h = p->height[i], d = (p->x[i] - v->at) / v->half;
    const double above = rw_if_negative(form, p->from_right[i], p->from_left[i]),
                 below = rw_if_negative(form, p->from_left[i], p->from_right[i]),
                 per = 1 / rw_if_negative(form, p->size_left[i], p->size_right[i]);
    const double ratio = per * rw_if_negative(form, v->ratio[1], v->ratio[0]),
                 side = per * rw_if_negative(form, v->side[1], v->side[0]);
    const double slant = rw_if_negative(form, -2, 2) * ratio * h;
    const rw_complex w = {-ratio * (above * below + h * h), slant},
                     rest = {side * (d * below + h * h), -slant};
    const rw_complex u = rw_power_place(w, rest);
    s->form[k] = form;
    s->farness[k] = rw_power_farness(w);
    s->kind[k] = rw_bits_of(form) >> 63 | rw_bits_of(s->farness[k]) >> 63 << 1;
    s->u.re[k] = u.re;
    s->u.im[k] = u.im;
    s->log_re[k] = rw_log_of_quotient(rest.re * rest.re + rest.im * rest.im + NONE, 1) / 2;
    s->log_im[k] = rw_angle(d, h) - rw_if_negative(form, p->angle_left[i], p->angle_right[i]);
}

/* Sums the series of each kind that is there. */
RW_INLINE void sum_series(const rw_sliding_frame *f, int vector, seen *restrict s)
{
    const double *const table[] = {f->rule->far, f->other->far, f->rule->near, f->other->near};
    uint64_t kinds = 0;
    for (int k = 0; k < vector; k++)
        kinds |= (uint64_t)1 << s->kind[k];
    for (uint64_t kind = 0; kind < 4; kind++) {
        rw_complex_lanes sum;
        if (!(kinds >> kind & 1))
            continue;
        rw_real_series(vector, RW_POWER_TERMS, table[kind], &s->u, &sum);
        for (int k = 0; k < vector; k++) {
            const uint64_t is_it = 0 - (((s->kind[k] ^ kind) - 1) >> 63);
            s->series.re[k] = rw_double_of((rw_bits_of(sum.re[k]) & is_it) |
                                           (rw_bits_of(s->series.re[k]) & ~is_it));
            s->series.im[k] = rw_double_of((rw_bits_of(sum.im[k]) & is_it) |
                                           (rw_bits_of(s->series.im[k]) & ~is_it));
        }
    }
}

/* X I at one of them. */
RW_INLINE rw_complex kink_at(const rw_sliding_points *restrict p, const view *restrict v,
                             const seen *restrict s, int i, int k)
{
    const double form = s->form[k], factor = rw_if_negative(form, v->factor[1], v->factor[0]),
                 near_one = rw_if_negative(s->farness[k], 1, 0);
    const rw_complex V = {rw_if_negative(form, p->other_re[i], p->V_re[i]),
                          rw_if_negative(form, p->other_im[i], p->V_im[i])},
                     series = {factor * s->series.re[k], factor * s->series.im[k]},
                     ln = {near_one * s->log_re[k], near_one * s->log_im[k]};
    const rw_complex by = rw_product(V, series), off = rw_product(v->turn, ln);
    return (rw_complex){rw_if_negative(form, v->whole[1], v->whole[0]) + by.re - off.re,
                        by.im - off.im};
}

RW_INLINE void put_bend(rw_sliding_points *restrict p, int i, rw_complex d, rw_complex by,
                        double jump)
{
    p->G_re[i] += jump * (d.re * by.re - d.im * by.im);
    p->G_im[i] += jump * (d.re * by.im + d.im * by.re);
    p->D_re[i] += jump * by.re;
    p->D_im[i] += jump * by.im;
}

RW_INLINE void put_kink(rw_sliding_points *restrict p, int i, rw_complex d, rw_complex by,
                        double step, double W)
{
    const double per = step * W / (d.re * d.re + d.im * d.im + NONE);
    const rw_complex Y = {p->Y_re[i], p->Y_im[i]};
    p->G_re[i] += step * by.re;
    p->G_im[i] += step * by.im;
    p->D_re[i] -= per * (Y.re * d.re + Y.im * d.im);
    p->D_im[i] -= per * (Y.im * d.re - Y.re * d.im);
}

RW_INLINE void add(const part *restrict a, rw_sliding_points *restrict p, int vector)
{
    const rw_place *t = a->place;
    const view v = view_of(p->frame, p->turn, t);
    for (int first = 0; first < p->count; first += vector) {
        seen s = {.series = {{0}, {0}}};
        for (int k = 0; k < vector; k++)
            see(p, &v, first + k, k, &s);
        sum_series(p->frame, vector, &s);
        for (int k = 0; k < vector; k++) {
            const int i = first + k;
            const rw_complex d = {(p->x[i] - v.at) / v.half, p->height[i]};
            const rw_complex by = kink_at(p, &v, &s, i, k);
            const double weight = a->share[i] * a->weight;
            if (a->is_kink)
                put_kink(p, i, d, by, weight, t->W);
            else
                put_bend(p, i, d, by, weight);
        }
    }
}

RW_INLINE void add_vectors(const part *a, rw_sliding_points *p)
{
    add(a, p, RW_LANES);
}

RW_DISPATCH(add_best, add_vectors, (const part *a, rw_sliding_points *p), (a, p))

void rw_sliding_points_add(rw_sliding_points *p, const rw_place *place, double weight, bool is_kink,
                           const double share[])
{
    const part a = {place, weight, is_kink, share};
    if (p->is_single)
        add(&a, p, 1);
    else
        add_best(&a, p);
}

void rw_sliding_points_add_edges(rw_sliding_points *p, double J, double W, double jump,
                                 const double share[])
{
    for (int i = 0; i < p->count; i++) {
        p->J[i] += share[i] * (jump * J);
        p->W[i] += share[i] * (jump * W);
    }
}

/* ---- After the parts ---- */

/* The coefficients of Q = sum M_n u^(n-1), u = 1/z, and of its derivative's sum (n + 1) M_n
 * u^(n-1). */
enum { TERMS = RW_MOMENTS - 1 };

typedef struct {
    double offset, value[TERMS], fall[TERMS];
} ending;

static ending ending_of(const rw_sliding_sums *sums)
{
    ending e = {.offset = sums->offset};
    for (int n = 1; n < RW_MOMENTS; n++) {
        e.value[n - 1] = sums->moment[n];
        e.fall[n - 1] = (n + 1) * sums->moment[n];
    }
    return e;
}

RW_INLINE rw_complex beside_at(const rw_sliding_points *p, int i)
{
    return (rw_complex){p->z[i] + (1 - 2 * p->frame->rule->a), p->height[i]};
}

/* From the sums over the parts. */
RW_INLINE void finish_at(rw_sliding_points *p, const ending *e, int i)
{
    const double J = p->J[i];
    const rw_complex Y = {p->Y_re[i], p->Y_im[i]}, beside = beside_at(p, i);
    const rw_complex edge = rw_product(Y, (rw_complex){p->W[i] + beside.re * J, beside.im * J});
    p->G_re[i] += e->offset * p->frame->whole - p->X_re[i] * J;
    p->G_im[i] -= p->X_im[i] * J;
    p->D_re[i] -= edge.re;
    p->D_im[i] -= edge.im;
}

/* G = X u^2 Q in place of the sums, where the point is far. */
RW_INLINE void expand(rw_sliding_points *p, const ending *e, int first, int vector)
{
    rw_complex_lanes u, value, fall;
    for (int k = 0; k < vector; k++) {
        const double z = p->z[first + k], h = p->height[first + k];
        const double per = 1 / rw_larger(z * z + h * h, FAR * FAR); /* others may be 0 */
        u.re[k] = z * per;
        u.im[k] = -h * per;
    }
    rw_real_series(vector, TERMS, e->value, &u, &value);
    rw_real_series(vector, TERMS, e->fall, &u, &fall);
    for (int k = 0; k < vector; k++) {
        const int i = first + k;
        const double away = p->z[i], deep = p->height[i];
        const double near = FAR * FAR - (away * away + deep * deep);
        const rw_complex X = {p->X_re[i], p->X_im[i]}, Y = {p->Y_re[i], p->Y_im[i]},
                         one = {u.re[k], u.im[k]}, two = rw_product(one, one);
        const rw_complex Q = rw_product(two, (rw_complex){value.re[k], value.im[k]});
        const rw_complex less =
            rw_product(rw_product(two, one), (rw_complex){fall.re[k], fall.im[k]});
        const rw_complex G = rw_product(X, Q), grow = rw_product(Y, beside_at(p, i)),
                         D = rw_sum(rw_product(grow, Q), rw_multiple(-1, rw_product(X, less)));
        p->G_re[i] = rw_if_negative(near, G.re, p->G_re[i]);
        p->G_im[i] = rw_if_negative(near, G.im, p->G_im[i]);
        p->D_re[i] = rw_if_negative(near, D.re, p->D_re[i]);
        p->D_im[i] = rw_if_negative(near, D.im, p->D_im[i]);
    }
}

RW_INLINE void finish(rw_sliding_points *p, const ending *e, int vector)
{
    const double per = 1 / p->frame->whole;
    for (int first = 0; first < p->count; first += vector) {
        for (int i = first; i < first + vector; i++)
            finish_at(p, e, i);
        if (p->has_far)
            expand(p, e, first, vector);
        for (int i = first; i < first + vector; i++) {
            p->G_re[i] *= per;
            p->G_im[i] *= per;
            p->D_re[i] *= p->height[i] * per;
            p->D_im[i] *= p->height[i] * per;
        }
    }
}

RW_INLINE void finish_vectors(rw_sliding_points *p, const ending *e)
{
    finish(p, e, RW_LANES);
}

RW_DISPATCH(finish_best, finish_vectors, (rw_sliding_points * p, const ending *e), (p, e))

void rw_sliding_points_finish(rw_sliding_points *p, const rw_sliding_sums *sums)
{
    const ending e = ending_of(sums);
    if (p->is_single)
        finish(p, &e, 1);
    else
        finish_best(p, &e);
}
