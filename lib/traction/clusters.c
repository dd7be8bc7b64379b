/* SPDX-License-Identifier: GPL-3.0-or-later */
#define RW_VECTORS
#include "traction/clusters.h"

#include "potential/elliptic.h"

#include <math.h>
#include <stdlib.h>

/* ---- Their making ---- */

/* A cluster of no more elements is not divided. */
enum { FEW = 2 };

/* Sums of load times U_n at the nodes of the elements, apart for each of RW_LANES nodes: compilers
 * make vector instructions of that. */
typedef struct {
    double of[RW_TERMS][RW_LANES];
} moments;

RW_INLINE void sum_moments(const rw_element *restrict elements, const rw_cluster *restrict c,
                           moments *restrict sum)
{
    for (size_t i = 0; i < c->count; i++) {
        const rw_element *e = &elements[i];
        double twice[RW_TERMS], now[RW_TERMS], before[RW_TERMS];
        for (int k = 0; k < RW_TERMS; k++) {
            twice[k] = 2 * (e->x[k] - c->middle) * c->per_half;
            now[k] = e->load[k];
            before[k] = 0;
        }
        for (int n = 0; n < RW_TERMS; n++) {
            for (int k = 0; k < RW_LANES; k++)
                sum->of[n][k] += now[k] + now[k + RW_LANES];
            for (int k = 0; k < RW_TERMS; k++) {
                const double next = twice[k] * now[k] - before[k];
                before[k] = now[k];
                now[k] = next;
            }
        }
    }
}

RW_DISPATCH(add_moments, sum_moments,
            (const rw_element *elements, const rw_cluster *c, moments *sum), (elements, c, sum))

static void expand(const rw_element *elements, rw_cluster *c)
{
    moments sum = {{{0}}};
    add_moments(elements, c, &sum);
    for (int n = 0; n < RW_TERMS; n++) {
        double all = 0;
        for (int k = 0; k < RW_LANES; k++)
            all += sum.of[n][k];
        c->a[n] = -2 / RW_PI * c->per_half * all;
    }
}

/* How many elements are in the first part. */
static size_t divided(const rw_element *e, const rw_cluster *c)
{
    size_t first = 1;
    while (first + 1 < c->count && e[first].low / 2 + e[first].high / 2 < c->middle)
        first++;
    return first;
}

/* Makes the cluster of some elements and, after it, those of its parts. Returns how many. */
static size_t make(const rw_element *elements, size_t first, size_t count, rw_cluster *c)
{
    const rw_element *e = elements + first;
    const double low = e->low, high = e[count - 1].high;
    *c = (rw_cluster){
        .first = first, .count = count, .middle = low / 2 + high / 2, .per_half = 2 / (high - low)};
    expand(e, c);
    if (count > FEW) {
        const size_t part = divided(e, c);
        c->parts = make(elements, first, part, c + 1);
        c->parts += make(elements, first + part, count - part, c + 1 + c->parts);
    }
    return c->parts + 1;
}

bool rw_traction_cluster(rw_traction *t)
{
    const size_t most = t->count > FEW ? 2 * t->count - 1 : 1;
    rw_cluster *clusters = t->count > 0 ? realloc(t->clusters, most * sizeof *clusters) : NULL;
    if (!clusters)
        return t->count == 0;
    t->clusters = clusters;
    t->cluster_count = make(t->elements, 0, t->count, clusters);
    return true;
}

/* ---- What they do far away ---- */

/* The sum of every second term up to `last`, a_n or (n+1) a_n, in powers of z = R^2. The
 * coefficients are real, and so is the recurrence: z is a root of z^2 - 2 Re z + |z|^2. */
RW_INLINE rw_complex every_second(const double a[], int last, bool is_steep, rw_complex z,
                                  double square)
{
    double sum = 0, before = 0;
    for (int n = last; n >= 0; n -= 2) {
        const double rest = (is_steep ? n + 1 : 1) * a[n] - square * before;
        before = sum;
        sum = rest + 2 * z.re * sum;
    }
    return (rw_complex){sum - z.re * before, z.im * before};
}

/* sum a_n R^(n+1), or sum (n+1) a_n R^(n+1): even and odd terms do not wait for each other. */
RW_INLINE rw_complex all_terms(const double a[], bool is_steep, rw_complex R, double square)
{
    const rw_complex R2 = rw_product(R, R);
    const rw_complex even = every_second(a, RW_TERMS - 2, is_steep, R2, square * square),
                     odd = every_second(a, RW_TERMS - 1, is_steep, R2, square * square);
    return rw_product(R, rw_sum(even, rw_product(R, odd)));
}

RW_INLINE rw_field series_at(const rw_cluster *c, double x, double y)
{
    const double v = (x - c->middle) * c->per_half, w = y * c->per_half, right = fabs(v);
    const rw_elliptic e = rw_elliptic_at(right, w, right - 1);
    const double shrink = rw_elliptic_shrink(&e), scale = w / e.cos2, side = copysign(1, v);
    const rw_complex R = {side * shrink * e.sin_v, -shrink * e.cos_v};
    const rw_complex y_over_X = {side * scale * (e.sin_v * e.sinh_w),
                                 -scale * (e.cos_v * e.cosh_w)};
    const rw_complex G = all_terms(c->a, false, R, shrink * shrink);
    const rw_complex H = rw_product(y_over_X, all_terms(c->a, true, R, shrink * shrink));
    return (rw_field){G.re, G.im, -H.re, -H.im};
}

RW_INLINE void series(const rw_cluster *restrict c, int count, const double *restrict x,
                      const double *restrict y, rw_fields *restrict fields)
{
    for (int first = 0; first < count; first += RW_LANES)
        for (int i = first; i < first + RW_LANES; i++)
            rw_put(fields, i, series_at(c, x[i], y[i]));
}

RW_BEST_PROCESSOR(best_series, series, rw_cluster)

static void one_by_one(const rw_cluster *c, int count, const double x[], const double y[],
                       rw_fields *fields)
{
    for (int i = 0; i < count; i++)
        rw_put(fields, i, series_at(c, x[i], y[i]));
}

void rw_add_cluster(const rw_cluster *c, const rw_places *far, const double x[], const double y[],
                    rw_fields *sum)
{
    double far_x[RW_BATCH], far_y[RW_BATCH];
    rw_fields own;
    if (far->count == 0)
        return;
    rw_places_read(far, x, far_x);
    rw_places_read(far, y, far_y);
    (far->count < RW_WORTH_A_VECTOR ? one_by_one : best_series)(c, far->count, far_x, far_y, &own);
    for (int i = 0; i < far->count; i++)
        rw_places_add(far, i, rw_field_in(&own, i), sum);
}

/* The integral of a_n R^(n+1) over x is h/2 a_n (R^(n+2)/(n+2) - R^n/n), of the first term h/2 a_0
 * (R^2/2 - ln R). Four sums at a time do not wait for each other. */
double rw_cluster_displacement(const rw_cluster *c, double x)
{
    enum { SUMS = 4 };
    const double v = (x - c->middle) * c->per_half, right = fabs(v);
    const double R = 1 / (v + copysign(sqrt((right - 1) * (right + 1)), v)), R2 = R * R,
                 R4 = R2 * R2;
    double b[RW_TERMS], part[SUMS] = {0};
    b[0] = 0;
    b[1] = c->a[1];
    for (int n = 2; n < RW_TERMS; n++)
        b[n] = (c->a[n] - c->a[n - 2]) / n;
    for (int n = RW_TERMS - SUMS; n >= 0; n -= SUMS)
        for (int k = 0; k < SUMS; k++)
            part[k] = part[k] * R4 + b[n + k];
    const double sum = part[0] + R * part[1] + R2 * (part[2] + R * part[3]);
    return (rw_log_of_quotient(1, 2 * c->per_half * fabs(R)) * c->a[0] - sum) / (2 * c->per_half);
}
