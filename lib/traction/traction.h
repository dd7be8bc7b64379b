/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A traction that has no closed form: a piecewise function of x on square-root elements,
 *     x = end + scale u^2,   first <= u <= last,
 * with a Legendre series in u on each. At an edge of the contact and at a front of slip a traction
 * behaves like a square root of the distance, which is smooth in u. The Cauchy transform and the
 * logarithmic potential of an element have closed forms (transform.h). */
#ifndef RW_TRACTION_H
#define RW_TRACTION_H

#include "base/root.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { RW_TERMS = 16 };

/* Places closer than this over x are one but for rounding. */
#define RW_SAME_PLACE (64 * DBL_EPSILON)

typedef struct {
    double end, scale, first, last;
    double low, high;                /* the ends in x, in order */
    double coefficient[RW_TERMS];    /* of the Legendre polynomials in u */
    int terms;                       /* of them that are not 0 at last */
    double u[RW_TERMS], x[RW_TERMS]; /* Gauss's nodes */
    double load[RW_TERMS];           /* the traction there times its weight in x */
    double primitive[RW_TERMS + 2];  /* coefficients of the load from first to u */
    double carried[RW_TERMS];        /* that load at the nodes times scale d(u^2) */
} rw_element;

/* u at a place; that of an end where the place is beyond it. */
static inline double rw_element_u(const rw_element *e, double x)
{
    return fmax(e->first, fmin(e->last, sqrt(fmax(0, (x - e->end) / e->scale))));
}

/* Elements in a row: clusters.h. */
typedef struct {
    size_t first, count, parts; /* parts: clusters of its parts, which come next */
    double middle, per_half;    /* 1 over half of its length */
    double a[RW_TERMS];
} rw_cluster;

typedef struct {
    rw_element *elements;
    size_t count, capacity;
    rw_cluster *clusters; /* of all elements, and of parts; none until it is whole */
    size_t cluster_count;
} rw_traction;

/* Where memory is short `is_whole` becomes false, and what there is is only to be freed. */
rw_traction rw_traction_copy(const rw_traction *traction, bool *is_whole);
void rw_traction_destroy(rw_traction *traction);

/* Makes the clusters of a traction that is to be read many times. They go where it is changed.
 * false where memory is short. */
bool rw_traction_cluster(rw_traction *traction);

/* A function at the RW_TERMS places x of an element. */
typedef void (*rw_values)(const double x[], const void *context, double value[]);

/* Appends a function of x to a traction. The function is smooth between neighbouring breaks, which
 * are in order; at a break it may be like a square root. Elements are divided until their last
 * coefficients are below the tolerance. Where f is a fit itself, it jumps a little between its
 * elements: up to `noise` times the tolerance, what is no smaller in a part than in the whole is
 * such a jump. false where memory is short. */
bool rw_traction_fit(rw_traction *traction, rw_values f, const void *context, size_t breaks,
                     const double at[], double tolerance, double noise);

/* Appends an element of which end, scale, first, last and the coefficients are set. */
bool rw_traction_append(rw_traction *traction, const rw_element *element);

/* Appends the part of another traction between two places. */
bool rw_traction_append_part(rw_traction *traction, const rw_traction *source, double from,
                             double to);

/* Joins neighbours that one element fits to the tolerance, of one element or more. */
void rw_traction_simplify(rw_traction *traction, double tolerance);

/* Adds a parabola that is 0 at two places, which are ends of elements, and has this mean between
 * them. */
void rw_traction_raise(rw_traction *traction, double from, double to, double mean);

/* Whether one element from each of two places fits all between them, with a kink, to the
 * tolerance. */
bool rw_traction_is_smooth(const rw_traction *traction, double from, double kink, double to,
                           double tolerance);

/* The last element that begins at x or before; the first one where there is none. */
size_t rw_traction_index(const rw_traction *traction, double x);

/* The traction at places, 0 outside of its elements; neighbours in a row of the same element are
 * read together. */
void rw_traction_values(const rw_traction *traction, size_t n, const double x[], double value[]);
double rw_traction_at(const rw_traction *traction, double x);

/* Its integral; that from its left end to a place. */
double rw_traction_total(const rw_traction *traction);
double rw_traction_load_to(const rw_traction *traction, double x);

#endif
