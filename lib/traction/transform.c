/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "traction/transform.h"

#include "base/complex.h"
#include "base/domain.h"
#include "base/processor.h"
#include "traction/clusters.h"
#include "traction/legendre.h"

#include <float.h>

/* Let v be on the ellipse about -1 and 1 whose half-axes have the sum rho. There the forward
 * recurrence of Legendre's functions loses digits like rho^(2k), and Gauss's rule errs by
 * rho^(-2n). At rho = NEAR both errors are 1e-9 of the traction. */
#define NEAR 2.0

/* A point nearer to the end of an element than this part of its length is moved away: there the
 * infinite logarithms of two neighbouring elements cancel, but not in numbers. The slope may be
 * like a square root there and allows a smaller move than the displacement. */
static const double BESIDE = 1e-10, WELL_BESIDE = 1e-8;

/* A point is moved by at least this part of x: a smaller move may be lost in rounding. It is moved
 * no further than to the middle of the element, beyond which another end may be. */
static const double LEAST_MOVE = 4 * DBL_EPSILON;

/* ---- One pole: J(zeta) = int c(u)/(u - zeta) du over an element ---- */

typedef struct {
    rw_complex value, slope; /* J and J' */
} pole;

/* The sum of the distances of such points from -1 and 1. */
static const double NEAR_ELLIPSE = NEAR + 1 / NEAR;

static bool is_near(rw_complex v)
{
    const double to_one = (v.re - 1) * (v.re - 1) + v.im * v.im;
    const double to_other = (v.re + 1) * (v.re + 1) + v.im * v.im;
    return sqrt(to_one) + sqrt(to_other) < NEAR_ELLIPSE;
}

/* Q_0 = ln((v+1)/(v-1))/2; its real part is the principal value where v is real. */
static rw_complex first_function(rw_complex v)
{
    const double up = v.re + 1, down = v.re - 1, square = v.im * v.im;
    return (rw_complex){
        rw_log_of_quotient(up * up + square + DBL_MIN, down * down + square + DBL_MIN) / 4,
        rw_angle(up * down + square, v.im * (down - up)) / 2};
}

/* sum c_k Q_k(v) and its derivative, Q_k' = k (v Q_k - Q_(k-1))/(v^2 - 1). */
RW_INLINE pole legendre_sum(int n, const double c[], rw_complex v)
{
    const rw_complex squared = rw_product(v, v);
    const rw_complex per =
        rw_quotient((rw_complex){1, 0}, (rw_complex){squared.re - 1, squared.im});
    rw_complex before = first_function(v), q = rw_product(v, before), rate = {0, 0};
    q.re -= 1;
    rw_complex sum = rw_multiple(c[0], before);
    for (int k = 1; k < n; k++) {
        const rw_complex vq = rw_product(v, q);
        sum = rw_sum(sum, rw_multiple(c[k], q));
        rate = rw_sum(rate, rw_multiple(k * c[k], rw_sum(vq, rw_multiple(-1, before))));
        const rw_complex next = rw_sum(rw_multiple(RW_LEGENDRE_RISE[k], vq),
                                       rw_multiple(-RW_LEGENDRE_FALL[k - 1], before));
        before = q;
        q = next;
    }
    rate.re -= c[0];
    return (pole){sum, rw_product(rate, per)};
}

/* By Gauss's rule; load_i is c(u_i) du_i times twice u_i and the size of the scale. */
RW_INLINE pole gauss_sum(const rw_element *e, const double load[], double scale, rw_complex zeta)
{
    pole sum = {{0, 0}, {0, 0}};
    for (int i = 0; i < RW_TERMS; i++) {
        const double d = e->u[i] - zeta.re;
        const double per = 1 / (e->u[i] * (d * d + zeta.im * zeta.im)), by = per * e->u[i];
        const rw_complex quotient = {by * d, by * zeta.im};
        const rw_complex value = {per * load[i] * d, per * load[i] * zeta.im};
        sum.value = rw_sum(sum.value, value);
        sum.slope = rw_sum(sum.slope, rw_product(value, quotient));
    }
    const double share = 1 / (2 * scale);
    return (pole){rw_multiple(share, sum.value), rw_multiple(share, sum.slope)};
}

RW_INLINE pole pole_of(const rw_element *e, int n, const double c[], const double load[],
                       double scale, rw_complex zeta)
{
    const double per_half = 2 / (e->last - e->first);
    const rw_complex v = {(zeta.re - e->first) * per_half - 1, zeta.im * per_half};
    if (!is_near(v))
        return gauss_sum(e, load, scale, zeta);
    const pole sum = legendre_sum(n, c, v);
    return (pole){rw_multiple(-2, sum.value), rw_multiple(-2 * per_half, sum.slope)};
}

/* ---- An element that is not far from z ---- */

static rw_complex zeta_of(const rw_element *e, double x, double y)
{
    return rw_complex_root((rw_complex){(x - e->end) / e->scale, y / e->scale});
}

/* Neither pole is near, whichever part of its square-root element this is. */
static bool is_far(const rw_element *e, double x, double y)
{
    const double middle = e->low / 2 + e->high / 2, length = e->high - e->low;
    return fabs(x - middle) > 0.8 * length || y > 0.8 * length;
}

/* The side of its end on which an element lies. */
static double side_of(const rw_element *e)
{
    return e->scale < 0 ? -1 : 1;
}

/* J(zeta) + J(-zeta), and its derivative by z. */
static pole transform(const rw_element *e, double x, double y)
{
    const double *c = e->coefficient, size = fabs(e->scale), side = side_of(e);
    const rw_complex zeta = zeta_of(e, x, y);
    const pole at_zeta = pole_of(e, e->terms, c, e->load, size, zeta);
    const pole at_minus = pole_of(e, e->terms, c, e->load, size, rw_multiple(-1, zeta));
    return (pole){rw_multiple(side, rw_sum(at_zeta.value, at_minus.value)),
                  rw_quotient(rw_sum(at_zeta.slope, rw_multiple(-1, at_minus.slope)),
                              rw_multiple(2 * size, zeta))};
}

/* ---- The same on the surface, where zeta is real or imaginary ---- */

static double legendre_sum_at(int n, const double c[], double v)
{
    double before = first_function((rw_complex){v, 0}).re, q = v * before - 1;
    double sum = c[0] * before;
    for (int k = 1; k < n; k++) {
        const double next = RW_LEGENDRE_RISE[k] * v * q - RW_LEGENDRE_FALL[k - 1] * before;
        sum += c[k] * q;
        before = q;
        q = next;
    }
    return sum;
}

static double gauss_sum_at(const rw_element *e, const double load[], double scale, double zeta)
{
    double sum = 0;
    for (int i = 0; i < RW_TERMS; i++)
        sum += load[i] / (e->u[i] * (e->u[i] - zeta));
    return sum / (2 * scale);
}

static double pole_at(const rw_element *e, int n, const double c[], const double load[],
                      double scale, double zeta)
{
    const double v = (zeta - e->first) * (2 / (e->last - e->first)) - 1;
    return 2 * fabs(v) < NEAR_ELLIPSE ? -2 * legendre_sum_at(n, c, v)
                                      : gauss_sum_at(e, load, scale, zeta);
}

static double poles_at(const rw_element *e, int n, const double c[], const double load[],
                       double scale, double x)
{
    const double square = (x - e->end) / e->scale, zeta = sqrt(fabs(square));
    if (square < 0)
        return 2 * pole_of(e, n, c, load, scale, (rw_complex){0, zeta}).value.re;
    return pole_at(e, n, c, load, scale, zeta) + pole_at(e, n, c, load, scale, -zeta);
}

/* ---- All of them ---- */

/* The place x, moved off the ends of the element there and of those beside it. */
static double beside(const rw_traction *t, double x, double part)
{
    const size_t own = rw_traction_index(t, x);
    for (size_t i = own > 0 ? own - 1 : 0; i < t->count && i <= own + 1; i++) {
        const rw_element *e = &t->elements[i];
        const double length = e->high - e->low;
        const double least = fmin(length / 2, fmax(part * length, LEAST_MOVE * fabs(x)));
        if (fabs(x - e->low) < least)
            return e->low + least;
        if (fabs(x - e->high) < least)
            return e->high - least;
    }
    return x;
}

static double far_sum(const double x[], const double load[], double to)
{
    double sum = 0;
    for (int i = 0; i < RW_TERMS; i++)
        sum += load[i] / (x[i] - to);
    return sum;
}

static double element_slope(const rw_element *e, double x)
{
    return is_far(e, x, 0)
               ? far_sum(e->x, e->load, x)
               : side_of(e) * poles_at(e, e->terms, e->coefficient, e->load, fabs(e->scale), x);
}

double rw_traction_slope(const rw_traction *t, double x)
{
    const double at = beside(t, x, BESIDE);
    double sum = 0;
    for (size_t i = 0; i < t->count; i++)
        sum += element_slope(&t->elements[i], at);
    return sum / RW_PI;
}

/* ---- By clusters ---- */

/* What stands for the clusters of a traction that has none: no place is far from it. */
static rw_cluster all_of(const rw_traction *t)
{
    return (rw_cluster){.count = t->count};
}

/* The load of an element, by its primitive, which begins at `first`. */
static double load_of(const rw_element *e)
{
    double whole = 0;
    for (int k = 0; k < e->terms + 2; k++)
        whole += e->primitive[k];
    return whole;
}

/* The potential of the load as if it were all at the end of the primitive. */
RW_INLINE double potential_of_load(const rw_element *e, double load, double x)
{
    const double end = e->scale > 0 ? e->high : e->low;
    return load * rw_log_of_quotient(fabs(end - x) + DBL_MIN, 1);
}

/* Adds the potential of an element to which some places are near. */
static void add_near(const rw_element *e, size_t n, const double x[], double sum[])
{
    const double load = load_of(e);
    for (size_t i = 0; i < n; i++) {
        const double rest = is_far(e, x[i], 0) ? far_sum(e->x, e->carried, x[i])
                                               : poles_at(e, e->terms + 2, e->primitive, e->carried,
                                                          e->scale, x[i]);
        sum[i] += rest - potential_of_load(e, load, x[i]);
    }
}

/* Adds that of an element from which all places are far: a division for every two of its nodes. */
RW_INLINE void sum_far(const rw_element *e, double load, const double x[RW_TERMS],
                       double sum[RW_TERMS])
{
    double all[RW_TERMS] = {0};
    for (int k = 0; k < RW_TERMS; k += 2)
        RW_EACH (i, RW_TERMS) {
            const double d = e->x[k] - x[i], next = e->x[k + 1] - x[i];
            all[i] += (e->carried[k] * next + e->carried[k + 1] * d) / (d * next);
        }
    RW_EACH (i, RW_TERMS)
        sum[i] += all[i] - potential_of_load(e, load, x[i]);
}

RW_DISPATCH(add_far, sum_far,
            (const rw_element *e, double load, const double x[RW_TERMS], double sum[RW_TERMS]),
            (e, load, x, sum))

/* Adds the potential of an element. */
static void add_potential(const rw_element *e, size_t n, const double x[RW_TERMS],
                          double sum[RW_TERMS])
{
    bool are_far = n > 1;
    for (size_t i = 0; i < n && are_far; i++)
        are_far = is_far(e, x[i], 0);
    if (are_far)
        add_far(e, load_of(e), x, sum);
    else
        add_near(e, n, x, sum);
}

void rw_traction_displacements(const rw_traction *t, size_t n, const double x[], double w[])
{
    const rw_cluster all = all_of(t), *c = t->cluster_count > 0 ? t->clusters : &all;
    const rw_cluster *end = c + (t->cluster_count > 0 ? t->cluster_count : 1);
    double at[RW_TERMS], near[RW_TERMS] = {0}, far[RW_TERMS] = {0};
    for (size_t i = 0; i < RW_TERMS; i++)
        at[i] = beside(t, x[i < n ? i : 0], WELL_BESIDE);
    while (c < end) {
        bool is_done = true;
        for (size_t i = 0; i < n && is_done; i++)
            is_done = rw_is_far(c, at[i], 0);
        for (size_t i = 0; i < n && is_done; i++)
            far[i] += rw_cluster_displacement(c, at[i]);
        for (size_t i = 0; i < c->count && c->parts == 0 && !is_done; i++)
            add_potential(&t->elements[c->first + i], n, at, near);
        c += is_done ? 1 + c->parts : 1;
    }
    for (size_t i = 0; i < n; i++)
        w[i] = near[i] / RW_PI + far[i];
}

double rw_traction_displacement(const rw_traction *t, double x)
{
    double w;
    rw_traction_displacements(t, 1, &x, &w);
    return w;
}

static pole far_transform(const rw_element *e, double x, double y)
{
    pole sum = {{0, 0}, {0, 0}};
    for (int i = 0; i < RW_TERMS; i++) {
        const double d = e->x[i] - x, share = 1 / (d * d + y * y);
        const rw_complex per = {d * share, y * share};
        sum.value = rw_sum(sum.value, rw_multiple(e->load[i], per));
        sum.slope = rw_sum(sum.slope, rw_multiple(e->load[i], rw_product(per, per)));
    }
    return sum;
}

/* Its field, but for the traction itself on the surface. */
static rw_field element_field(const rw_element *e, double x, double y)
{
    if (y == 0)
        return (rw_field){element_slope(e, x) / RW_PI, 0, 0, 0};
    const pole own = is_far(e, x, y) ? far_transform(e, x, y) : transform(e, x, y);
    return rw_field_multiple(
        1 / RW_PI, (rw_field){own.value.re, own.value.im, y * own.slope.re, y * own.slope.im});
}

/* Some of the places. */
typedef struct {
    int count, place[RW_BATCH];
    double x[RW_BATCH], y[RW_BATCH];
} group;

static void put_in(group *g, int place, double x, double y)
{
    g->place[g->count] = place;
    g->x[g->count] = x;
    g->y[g->count++] = y;
}

static void add(rw_field own, int place, rw_fields *sum)
{
    const rw_field before = rw_field_in(sum, place);
    rw_put(sum, place,
           (rw_field){before.G_re + own.G_re, before.G_im + own.G_im, before.H_re + own.H_re,
                      before.H_im + own.H_im});
}

static void add_cluster(const rw_cluster *c, group *far, rw_fields *sum)
{
    rw_fields own;
    rw_cluster_fields(c, far->count, far->x, far->y, &own);
    for (int i = 0; i < far->count; i++)
        add(rw_field_in(&own, i), far->place[i], sum);
}

static void add_element(const rw_element *e, const group *near, rw_fields *sum)
{
    for (int i = 0; i < near->count; i++)
        add(element_field(e, near->x[i], near->y[i]), near->place[i], sum);
}

/* A place waits until the cluster `next`: it had all before. */
static void add_clusters(const rw_traction *t, int n, const double x[], const double y[],
                         rw_fields *sum)
{
    const rw_cluster all = all_of(t), *clusters = t->cluster_count > 0 ? t->clusters : &all;
    const size_t count = t->cluster_count > 0 ? t->cluster_count : 1;
    size_t next[RW_BATCH] = {0};
    for (size_t i = 0; i < count;) {
        const rw_cluster *c = &clusters[i];
        group far = {.count = 0}, near = {.count = 0};
        for (int k = 0; k < n; k++) {
            const bool is_far_off = next[k] <= i && rw_is_far(c, x[k], y[k]);
            if (next[k] <= i)
                put_in(is_far_off ? &far : &near, k, x[k], y[k]);
            if (is_far_off)
                next[k] = i + 1 + c->parts;
        }
        if (far.count > 0)
            add_cluster(c, &far, sum);
        for (size_t k = 0; k < c->count && c->parts == 0; k++)
            add_element(&t->elements[c->first + k], &near, sum);
        i += near.count > 0 ? 1 : 1 + c->parts;
    }
}

void rw_traction_fields(const rw_traction *t, int n, const double x[], const double y[],
                        rw_fields *fields)
{
    double at[RW_BATCH], own[RW_BATCH];
    bool has_surface = false;
    for (int i = 0; i < n; i++) {
        at[i] = y[i] == 0 ? beside(t, x[i], BESIDE) : x[i];
        has_surface = has_surface || y[i] == 0;
    }
    rw_clear_fields(n, fields);
    add_clusters(t, n, at, y, fields);
    if (has_surface)
        rw_traction_values(t, (size_t)n, x, own);
    for (int i = 0; i < n && has_surface; i++)
        if (y[i] == 0)
            fields->G_im[i] = own[i];
}
