/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "traction/transform.h"

#include "base/complex.h"
#include "base/domain.h"
#include "base/processor.h"
#include "traction/clusters.h"
#include "traction/element.h"
#include "traction/legendre.h"

#include <float.h>

/* A point nearer to the end of an element than this part of its length is moved away: there the
 * infinite logarithms of two neighbouring elements cancel, but not in numbers. The slope may be
 * like a square root there and allows a smaller move than the displacement. */
static const double BESIDE = 1e-10, WELL_BESIDE = 1e-8;

/* A point is moved by at least this part of x: a smaller move may be lost in rounding. It is moved
 * no further than to the middle of the element, beyond which another end may be. */
static const double LEAST_MOVE = 4 * DBL_EPSILON;

/* ---- An element on the surface: J(zeta) = int c(u)/(u - zeta) du, zeta real or imaginary ---- */

static double legendre_sum(int n, const double c[], double v)
{
    double before = rw_first_function((rw_complex){v, 0}).re, q = v * before - 1;
    double sum = c[0] * before;
    for (int k = 1; k < n; k++) {
        const double next = RW_LEGENDRE_RISE[k] * v * q - RW_LEGENDRE_FALL[k - 1] * before;
        sum += c[k] * q;
        before = q;
        q = next;
    }
    return sum;
}

/* The pole by Gauss's rule; load_i is c(u_i) du_i times twice u_i and the size of the scale. */
static double gauss_sum(const rw_element *e, const double load[], double scale, double zeta)
{
    double sum = 0;
    for (int i = 0; i < RW_TERMS; i++)
        sum += load[i] / (e->u[i] * (e->u[i] - zeta));
    return sum / (2 * scale);
}

static double pole_at(const rw_element *e, int n, const double c[], const double load[],
                      double scale, double zeta)
{
    const rw_complex v = rw_pole_place(e, (rw_complex){zeta, 0});
    return rw_is_near_pole(v) ? -2 * legendre_sum(n, c, v.re) : gauss_sum(e, load, scale, zeta);
}

/* The real part of the sum over Legendre's functions. */
static double real_legendre_sum(int n, const double c[], rw_complex v)
{
    rw_complex before = rw_first_function(v), q = rw_product(v, before);
    q.re -= 1;
    double sum = c[0] * before.re;
    for (int k = 1; k < n; k++) {
        const rw_complex next = rw_sum(rw_multiple(RW_LEGENDRE_RISE[k], rw_product(v, q)),
                                       rw_multiple(-RW_LEGENDRE_FALL[k - 1], before));
        sum += c[k] * q.re;
        before = q;
        q = next;
    }
    return sum;
}

static double far_sum(const double x[], const double load[], double to)
{
    double sum = 0;
    for (int i = 0; i < RW_TERMS; i++)
        sum += load[i] / (x[i] - to);
    return sum;
}

/* J(zeta) + J(-zeta); beyond the end they are conjugate. */
static double poles_at(const rw_element *e, int n, const double c[], const double load[],
                       double scale, double x)
{
    const double square = (x - e->end) / e->scale, zeta = sqrt(fabs(square));
    const rw_complex v = rw_pole_place(e, (rw_complex){0, zeta});
    if (square >= 0)
        return pole_at(e, n, c, load, scale, zeta) + pole_at(e, n, c, load, scale, -zeta);
    return rw_is_near_pole(v) ? -4 * real_legendre_sum(n, c, v)
                              : e->scale / scale * far_sum(e->x, load, x);
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

static double element_slope(const rw_element *e, double x)
{
    return rw_is_far_from_element(e, x, 0)
               ? far_sum(e->x, e->load, x)
               : rw_side_of(e) * poles_at(e, e->terms, e->coefficient, e->load, fabs(e->scale), x);
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

/* The potential of an element at places from which it is far: a division for every two nodes. */
RW_INLINE void far_potentials(size_t n, const rw_element *e, double load, const double x[],
                              double sum[])
{
    double all[RW_TERMS] = {0};
    for (int k = 0; k < RW_TERMS; k += 2)
        RW_EACH (i, n) {
            const double d = e->x[k] - x[i], next = e->x[k + 1] - x[i];
            all[i] += (e->carried[k] * next + e->carried[k + 1] * d) / (d * next);
        }
    RW_EACH (i, n)
        sum[i] = all[i] - potential_of_load(e, load, x[i]);
}

RW_INLINE void far_potentials_of_all(const rw_element *e, double load, const double x[RW_TERMS],
                                     double sum[RW_TERMS])
{
    far_potentials(RW_TERMS, e, load, x, sum);
}

RW_DISPATCH(set_far, far_potentials_of_all,
            (const rw_element *e, double load, const double x[RW_TERMS], double sum[RW_TERMS]),
            (e, load, x, sum))

/* Adds the potential of an element at some of the places. */
static void add_potential(const rw_element *e, const rw_places *places, const double x[],
                          double sum[])
{
    enum { FEW = 3 };
    const double load = load_of(e);
    rw_places far;
    double away[RW_TERMS], own[RW_TERMS];
    far.count = 0;
    for (int i = 0; i < places->count; i++) {
        const int place = places->place[i];
        const bool is_far = rw_is_far_from_element(e, x[place], 0);
        rw_places_put(&far, place, is_far);
        if (!is_far)
            sum[place] += poles_at(e, e->terms + 2, e->primitive, e->carried, e->scale, x[place]) -
                          potential_of_load(e, load, x[place]);
    }
    if (far.count == 0)
        return;
    for (int i = 0; i < RW_TERMS; i++)
        away[i] = x[far.place[i < far.count ? i : 0]];
    if (far.count > FEW)
        set_far(e, load, away, own);
    for (int i = 0; i < far.count; i++) {
        if (far.count <= FEW)
            far_potentials(1, e, load, away + i, own + i);
        sum[far.place[i]] += own[i];
    }
}

/* Adds the displacement of a cluster, times pi where it is of its elements. */
static void add_displacement(const rw_traction *t, const rw_cluster *c, const rw_places *places,
                             const double x[], double near_sum[], double far_sums[])
{
    rw_places near;
    near.count = 0;
    for (int i = 0; i < places->count; i++) {
        const int place = places->place[i];
        const bool is_far = rw_is_far(c, x[place], 0);
        rw_places_put(&near, place, !is_far);
        if (is_far)
            far_sums[place] += rw_cluster_displacement(c, x[place]);
    }
    if (near.count > 0 && c->parts > 0) {
        const rw_cluster *left = c + 1, *right = left + 1 + left->parts;
        add_displacement(t, left, &near, x, near_sum, far_sums);
        add_displacement(t, right, &near, x, near_sum, far_sums);
    } else if (near.count > 0)
        for (size_t i = 0; i < c->count; i++)
            add_potential(&t->elements[c->first + i], &near, x, near_sum);
}

void rw_traction_displacements(const rw_traction *t, size_t n, const double x[], double w[])
{
    const rw_cluster all = all_of(t);
    double at[RW_TERMS] = {0}, near[RW_TERMS] = {0}, far[RW_TERMS] = {0};
    rw_places places;
    places.count = 0;
    for (size_t i = 0; i < n; i++) {
        at[i] = beside(t, x[i], WELL_BESIDE);
        rw_places_put(&places, (int)i, true);
    }
    add_displacement(t, t->cluster_count > 0 ? t->clusters : &all, &places, at, near, far);
    for (size_t i = 0; i < n; i++)
        w[i] = near[i] / RW_PI + far[i];
}

double rw_traction_displacement(const rw_traction *t, double x)
{
    double w;
    rw_traction_displacements(t, 1, &x, &w);
    return w;
}

static void add_cluster(const rw_traction *t, const rw_cluster *c, const rw_places *places,
                        const double x[], const double y[], rw_fields *sum)
{
    rw_places far, near;
    far.count = near.count = 0; /* to set their places too takes long */
    for (int i = 0; i < places->count; i++) {
        const int place = places->place[i];
        const bool is_far = rw_is_far(c, x[place], y[place]);
        rw_places_put(&far, place, is_far);
        rw_places_put(&near, place, !is_far);
    }
    rw_add_cluster(c, &far, x, y, sum);
    if (near.count > 0 && c->parts > 0) {
        const rw_cluster *left = c + 1, *right = left + 1 + left->parts;
        add_cluster(t, left, &near, x, y, sum);
        add_cluster(t, right, &near, x, y, sum);
    } else if (near.count > 0)
        for (size_t i = 0; i < c->count; i++)
            rw_add_element(&t->elements[c->first + i], &near, x, y, sum);
}

void rw_traction_fields(const rw_traction *t, int n, const double x[], const double y[],
                        rw_fields *fields)
{
    double at[RW_BATCH], own[RW_BATCH];
    bool has_surface = false;
    const rw_cluster all = all_of(t);
    rw_places places;
    places.count = 0;
    for (int i = 0; i < n; i++) {
        rw_places_put(&places, i, true);
        at[i] = y[i] == 0 ? beside(t, x[i], BESIDE) : x[i];
        has_surface = has_surface || y[i] == 0;
    }
    rw_clear_fields(n, fields);
    add_cluster(t, t->cluster_count > 0 ? t->clusters : &all, &places, at, y, fields);
    if (has_surface)
        rw_traction_values(t, (size_t)n, x, own);
    for (int i = 0; i < n && has_surface; i++)
        if (y[i] == 0)
            rw_put(fields, i, (rw_field){fields->G_re[i], own[i], 0, 0});
}
