/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load at which a pad that slides fully first yields. Stresses grow with the load, and the
 * logarithm of the factor is nearly a straight line in that of the load: -1/2 in Hertz' contact. */
#include "yield/yield_load.h"

#include "base/domain.h"
#include "base/root.h"

/* Logarithms of loads: the shortest and longest step of the search for a bracket, the shortest
 * towards a load that is refused, and the error of the root. */
static const double STEP_LEAST = 0.2, STEP_MOST = 6, LAST_STEP = 1e-6, NEAREST = 1e-13;
enum { STEPS = 60 };

/* The logarithm of the factor where the stress is infinite. */
static const double INFINITE = -1000;

typedef struct {
    const rwedge_contact *contact;
    rw_factor *factor;
    double nu, k;
    int32_t status; /* of the last load */
    double x, y;
} search;

static int32_t slide(search *s, double P, double *factor)
{
    rwedge_contact *sliding = NULL;
    int32_t status = rw_contact_unloaded(s->contact, &sliding);
    const double Q = copysign(s->contact->f * P, s->contact->loads.Q);
    if (status == RWEDGE_OK)
        status = rwedge_contact_apply(sliding, P, 0, Q, 0);
    if (status == RWEDGE_OK)
        status = s->factor(sliding, s->nu, s->k, factor, &s->x, &s->y);
    rwedge_contact_destroy(sliding);
    return status;
}

/* The logarithm of the factor; NaN where the load is refused. */
static double excess(double log_P, const void *of_search)
{
    search *s = (search *)of_search;
    double factor;
    s->status = slide(s, exp(log_P), &factor);
    return s->status != RWEDGE_OK ? NAN : factor > 0 ? log(factor) : INFINITE;
}

typedef struct {
    double log_P, excess;
} point;

static point point_at(search *s, double log_P)
{
    return (point){log_P, excess(log_P, s)};
}

/* How far the arcs of the profile reach; 1 for the sharp wedge. */
static double extent(const rw_geometry *g)
{
    const rw_arcs arcs = rw_arcs_of(g);
    double most = 0;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        most = fmax(most, fmax(-arc.left, arc.right));
    }
    return most > 0 ? most : 1;
}

/* The logarithm of a load so small that f P is just in the domain. */
static double log_of_smallest(double f)
{
    static const double ABOVE = 2; /* its exponential is rounded */
    return log(ABOVE * RW_SMALLEST) - (f > 0 ? fmin(log(f), 0) : 0);
}

/* A load that can be applied: where the roundest part would yield as a cylinder, or of a profile
 * with a kink one of its size; or a smaller one. */
static point start(search *s)
{
    const rw_geometry *g = &s->contact->geometry;
    const double log_P = g->a > 0 ? log(g->a / g->theta) + log(g->A * s->k) + log(s->k)
                                  : log(rw_unit_stress(g) * extent(g));
    point p = point_at(s, fmin(fmax(log_P, log_of_smallest(s->contact->f)), log(RW_LARGEST)));
    for (int i = 0; i < STEPS && isnan(p.excess) && s->status != RWEDGE_ENOMEM; i++)
        p = point_at(s, p.log_P - STEP_MOST);
    return p;
}

/* Goes from a point to the other side of the limit, step by step; false where there is none. Steps
 * towards loads that are refused are shortened. */
static bool cross(search *s, point *from, point *to)
{
    double most = STEP_MOST;
    for (int i = 0; i < STEPS && most > LAST_STEP; i++) {
        const double step = fmin(most, fmax(STEP_LEAST, 2.2 * fabs(from->excess)));
        *to = point_at(s, from->log_P + copysign(step, from->excess));
        if (s->status == RWEDGE_ENOMEM)
            return false;
        if (isnan(to->excess))
            most = step / 8;
        else if ((to->excess > 0) != (from->excess > 0))
            return true;
        else
            *from = *to;
    }
    return false;
}

int32_t rw_limit_of_pad(const rwedge_contact *contact, rw_factor *factor, double nu, double k,
                        double *P, double *x, double *y)
{
    search s = {.contact = contact, .factor = factor, .nu = nu, .k = k};
    point from = start(&s), to = from;
    const bool is_bracket = !isnan(from.excess) && cross(&s, &from, &to);
    if (s.status == RWEDGE_ENOMEM)
        return RWEDGE_ENOMEM;
    if (!is_bracket && !isless(from.excess, 0))
        return RWEDGE_EABSENT;
    *P = *x = *y = 0; /* it yields under any load, unless there is a bracket */
    if (!is_bracket)
        return RWEDGE_OK;
    const double log_P =
        rw_root(excess, &s, fmin(from.log_P, to.log_P), fmax(from.log_P, to.log_P), NEAREST);
    if (isnan(log_P) || isnan(excess(log_P, &s)))
        return s.status == RWEDGE_ENOMEM ? RWEDGE_ENOMEM : RWEDGE_ERANGE;
    *P = exp(log_P);
    *x = s.x;
    *y = s.y;
    return RWEDGE_OK;
}

int32_t rwedge_contact_yield_load(const rwedge_contact *contact, double nu, double k, double *P,
                                  double *x, double *y)
{
    double load, at_x, at_y;
    if (!contact || !P)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_positive(k))
        return RWEDGE_EDOMAIN;
    const int32_t status =
        rw_limit_of_pad(contact, rwedge_contact_yield_factor, nu, k, &load, &at_x, &at_y);
    if (status != RWEDGE_OK)
        return status;
    *P = load;
    if (x)
        *x = at_x;
    if (y)
        *y = at_y;
    return RWEDGE_OK;
}
