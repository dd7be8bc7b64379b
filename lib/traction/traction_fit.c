/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a traction is made: elements that fit a function, or parts of a traction that is there. */
#include "base/array.h"
#include "base/domain.h"
#include "base/processor.h"
#include "base/tuned.h"
#include "traction/legendre.h"
#include "traction/traction.h"

#include <string.h>

/* Elements are divided at most DEPTH times, and not into parts shorter than SHORTEST of the whole:
 * narrower features are the noise of a front that is not exact. Nor into parts shorter than
 * RW_SAME_PLACE of x: there are too few places in them, and what is smooth jumps from one to the
 * next. */
enum { DEPTH = 12 };

static const double SHORTEST = 1e-8;

/* ---- Legendre polynomials ---- */

/* The nodes of an element, and the Legendre polynomials there, which give the coefficients from
 * values at the nodes. */
typedef struct {
    double node[RW_TERMS], weight[RW_TERMS];
    double legendre[RW_TERMS + 2][RW_TERMS]; /* [k][node] */
    double at_node[RW_TERMS][RW_TERMS];      /* the same, [node][k] */
} rule;

static void make_rule(rule *r)
{
    rw_gauss(RW_TERMS, r->node, r->weight);
    for (int i = 0; i < RW_TERMS; i++) {
        r->legendre[0][i] = 1;
        r->legendre[1][i] = 2 * r->node[i] - 1;
    }
    for (int k = 1; k < RW_TERMS + 1; k++)
        for (int i = 0; i < RW_TERMS; i++)
            r->legendre[k + 1][i] = RW_LEGENDRE_RISE[k] * r->legendre[1][i] * r->legendre[k][i] -
                                    RW_LEGENDRE_FALL[k - 1] * r->legendre[k - 1][i];
    for (int i = 0; i < RW_TERMS; i++)
        for (int k = 0; k < RW_TERMS; k++)
            r->at_node[i][k] = r->legendre[k][i];
}

/* sum += the sum over i of factor_i row_i. */
RW_INLINE void sum_rows(int n, const double factor[], const double row[][RW_TERMS],
                        double sum[RW_TERMS])
{
    double all[RW_TERMS];
    memcpy(all, sum, sizeof all);
    for (int i = 0; i < n; i++)
        RW_EACH (k, RW_TERMS)
            all[k] += factor[i] * row[i][k];
    memcpy(sum, all, sizeof all);
}

RW_DISPATCH(add_rows, sum_rows,
            (int n, const double factor[], const double row[][RW_TERMS], double sum[RW_TERMS]),
            (n, factor, row, sum))

/* The coefficients of a function, from its values at the nodes. */
static void find_coefficients(const rule *r, const double value[], double coefficient[])
{
    double share[RW_TERMS], sum[RW_TERMS] = {0};
    for (int i = 0; i < RW_TERMS; i++)
        share[i] = r->weight[i] * value[i];
    add_rows(RW_TERMS, share, r->at_node, sum);
    for (int k = 0; k < RW_TERMS; k++)
        coefficient[k] = (2 * k + 1) * sum[k];
}

/* ---- An element ---- */

static double u_of(const rw_element *e, double node)
{
    return e->first + (e->last - e->first) * node;
}

static double x_of(const rw_element *e, double u)
{
    return e->end + e->scale * u * u;
}

/* The primitive of the traction times dx/du: a Legendre series of two more terms, because dx/du is
 * linear in u. */
static void integrate(rw_element *e)
{
    const double middle = (e->first + e->last) / 2, half = (e->last - e->first) / 2;
    double rate[RW_TERMS + 1] = {0};
    for (int k = 0; k < e->terms; k++) {
        const double c = e->coefficient[k] * 2 * fabs(e->scale) * half;
        rate[k] += middle * c;
        rate[k + 1] += half * c * (k + 1) / (2 * k + 1);
        if (k > 0)
            rate[k - 1] += half * c * k / (2 * k + 1);
    }
    memset(e->primitive, 0, sizeof e->primitive);
    for (int k = 0; k < e->terms + 1; k++) {
        e->primitive[k + 1] += rate[k] / (2 * k + 1);
        e->primitive[k > 0 ? k - 1 : 0] += (k > 0 ? -1 : 1) * rate[k] / (2 * k + 1);
    }
}

/* Sets all members that follow from the coefficients. */
static void complete(rw_element *e, const rule *r)
{
    const double from = x_of(e, e->first), to = x_of(e, e->last), du = e->last - e->first;
    e->low = fmin(from, to);
    e->high = fmax(from, to);
    e->terms = RW_TERMS;
    while (e->terms > 1 && e->coefficient[e->terms - 1] == 0)
        e->terms--;
    integrate(e);
    double value[RW_TERMS] = {0}, primitive[RW_TERMS] = {0};
    add_rows(e->terms, e->coefficient, r->legendre, value);
    add_rows(e->terms + 2, e->primitive, r->legendre, primitive);
    for (int i = 0; i < RW_TERMS; i++) {
        const double u = u_of(e, r->node[i]), rate = 2 * fabs(e->scale) * u * du * r->weight[i];
        e->u[i] = u;
        e->x[i] = x_of(e, u);
        e->load[i] = value[i] * rate;
        e->carried[i] = primitive[i] * 2 * e->scale * u * du * r->weight[i];
    }
}

/* Appends an element that is complete. */
static bool append(rw_traction *t, const rw_element *e)
{
    rw_element *elements = rw_grown(t->elements, t->count, &t->capacity, 1, sizeof *elements);
    if (!elements)
        return false;
    t->elements = elements;
    t->elements[t->count++] = *e;
    t->cluster_count = 0;
    return true;
}

bool rw_traction_append(rw_traction *t, const rw_element *e)
{
    rw_element whole = *e;
    rule r;
    make_rule(&r);
    complete(&whole, &r);
    return append(t, &whole);
}

void rw_traction_raise(rw_traction *t, double from, double to, double mean)
{
    enum { TERMS = 5 }; /* of a parabola of x */
    const double most = 6 * mean / ((to - from) * (to - from));
    rule r;
    make_rule(&r);
    t->cluster_count = 0;
    for (size_t i = 0; i < t->count; i++) {
        rw_element *e = &t->elements[i];
        const double middle = e->low / 2 + e->high / 2;
        if (!(middle > from && middle < to))
            continue;
        double parabola[RW_TERMS], more[RW_TERMS];
        for (int k = 0; k < RW_TERMS; k++)
            parabola[k] = most * (e->x[k] - from) * (to - e->x[k]);
        find_coefficients(&r, parabola, more);
        for (int k = 0; k < TERMS; k++)
            e->coefficient[k] += more[k];
        complete(e, &r);
    }
}

/* ---- Of a function ---- */

typedef struct {
    rw_traction *traction;
    rw_values f;
    const void *context;
    double tolerance, noise, shortest;
    bool is_short; /* of memory */
    rule rule;
    rw_element part; /* the last that was tried */
} fit;

static void expand(const fit *how, rw_element *e)
{
    double x[RW_TERMS], value[RW_TERMS];
    for (int i = 0; i < RW_TERMS; i++)
        x[i] = x_of(e, u_of(e, how->rule.node[i]));
    how->f(x, how->context, value);
    find_coefficients(&how->rule, value, e->coefficient);
}

/* The last coefficients, by size. */
static double rest_of(const rw_element *e)
{
    const double *c = e->coefficient;
    return fmax(fabs(c[RW_TERMS - 1]), fmax(fabs(c[RW_TERMS - 2]), fabs(c[RW_TERMS - 3])));
}

/* `whole` is the rest of the element that it is a part of. */
static bool is_fine(const fit *how, double rest, double whole)
{
    return !(rest > how->tolerance) || (rest < how->noise * how->tolerance && rest > whole / 2);
}

/* Leaves out the last terms that are lost in the tolerance. */
static void shorten(const fit *how, rw_element *e)
{
    for (int k = RW_TERMS - 1; k > 0 && fabs(e->coefficient[k]) < RW_LOST * how->tolerance; k--)
        e->coefficient[k] = 0;
}

/* The place of a grid next to x, from < x < to: elements meet there. A fit jumps a little where
 * they meet. A next fit, whose breaks have moved a little, meets at the same place and has the same
 * jump. If it met beside it, no node would lie between the two places: each element would go on
 * beyond the old one, and in a hundred fits the jump would grow a thousandfold. The grid is not
 * round: users ask for round places, and slopes lose digits where elements meet. */
static double meeting_place(double x, double from, double to)
{
    static const double GRAIN = 0.6180339887;
    int exponent = 0;
    frexp(fmin(fabs(x - from), fabs(to - x)) / 32, &exponent);
    const double grain = ldexp(GRAIN, exponent);
    return grain * round(x / grain);
}

/* Where a part is divided: in halves of u. Next to the end, where x is quadratic in u, the first
 * part is a third. */
static double division_of(const rw_element *e)
{
    const double u = e->first == 0 ? e->last / 3 : (e->first + e->last) / 2;
    const double x = meeting_place(x_of(e, u), x_of(e, e->first), x_of(e, e->last));
    const double at = sqrt(fmax(0, (x - e->end) / e->scale));
    return at > e->first && at < e->last ? at : u;
}

/* Fits a part of what has the rest `whole`, in two where one element is not enough, in the order of
 * x. */
static void fit_part(fit *how, double end, double scale, double first, double last, int depth,
                     double whole)
{
    rw_element *e = &how->part;
    *e = (rw_element){.end = end, .scale = scale, .first = first, .last = last};
    expand(how, e);
    const double rest = rest_of(e);
    if (depth == 0 || fabs(scale) * (last * last - first * first) < how->shortest ||
        is_fine(how, rest, whole)) {
        shorten(how, e);
        complete(e, &how->rule);
        how->is_short |= !append(how->traction, e);
        return;
    }
    const double at[] = {first, division_of(e), last};
    const int left = scale > 0 ? 0 : 1, right = 1 - left;
    fit_part(how, end, scale, at[left], at[left + 1], depth - 1, rest);
    fit_part(how, end, scale, at[right], at[right + 1], depth - 1, rest);
}

bool rw_traction_fit(rw_traction *t, rw_values f, const void *context, size_t breaks,
                     const double at[], double tolerance, double noise)
{
    fit how = {.traction = t, .f = f, .context = context, .tolerance = tolerance, .noise = noise};
    const double reach = fmax(fabs(at[0]), fabs(at[breaks - 1]));
    how.shortest = fmax(SHORTEST * (at[breaks - 1] - at[0]), RW_SAME_PLACE * reach);
    make_rule(&how.rule);
    for (size_t i = 0; i + 1 < breaks; i++) {
        const double middle = meeting_place(at[i] / 2 + at[i + 1] / 2, at[i], at[i + 1]);
        if (!((middle - at[i]) * (at[i + 1] - middle) > 0))
            continue;
        fit_part(&how, at[i], middle - at[i], 0, 1, DEPTH, HUGE_VAL);
        fit_part(&how, at[i + 1], middle - at[i + 1], 0, 1, DEPTH, HUGE_VAL);
    }
    return !how.is_short;
}

/* ---- Of another traction ---- */

static void values_of(const double x[], const void *context, double value[])
{
    rw_traction_values(context, RW_TERMS, x, value);
}

/* The part of an element between two places. */
static rw_element cut(rw_element *e, double from, double to)
{
    const rw_traction alone = {.elements = e, .count = 1};
    const double at_from = rw_element_u(e, from), at_to = rw_element_u(e, to);
    fit how = {.f = values_of, .context = &alone};
    rw_element part = {.end = e->end,
                       .scale = e->scale,
                       .first = fmin(at_from, at_to),
                       .last = fmax(at_from, at_to)};
    make_rule(&how.rule);
    expand(&how, &part);
    complete(&part, &how.rule);
    part.low = fmax(e->low, from);
    part.high = fmin(e->high, to);
    return part;
}

bool rw_traction_append_part(rw_traction *t, const rw_traction *source, double from, double to)
{
    for (size_t i = 0; i < source->count; i++) {
        rw_element *e = &source->elements[i];
        const bool is_inside = e->low >= from && e->high <= to;
        const rw_element part = is_inside ? *e : cut(e, from, to);
        if ((part.last - part.first) * (part.high - part.low) > 0 && !append(t, &part))
            return false;
    }
    return true;
}

/* Whether an element is near another one at the places of that one. */
static bool is_near(const fit *how, rw_element *e, rw_element *other)
{
    double value[RW_TERMS], wanted[RW_TERMS], apart = 0;
    values_of(other->x, &(rw_traction){.elements = e, .count = 1}, value);
    values_of(other->x, &(rw_traction){.elements = other, .count = 1}, wanted);
    for (int i = 0; i < RW_TERMS; i++)
        apart = fmax(apart, fabs(value[i] - wanted[i]));
    return apart <= how->tolerance;
}

/* One element in place of two neighbours. Whether it fits them, of which one may be too short to
 * have a place of the other's. */
static bool join(fit *how, const rw_element *left, const rw_element *right, rw_element *both)
{
    rw_element pair[2] = {*left, *right};
    const rw_traction parts = {.elements = pair, .count = 2};
    how->context = &parts;
    *both = (rw_element){.end = left->low, .scale = right->high - left->low, .last = 1};
    expand(how, both);
    complete(both, &how->rule);
    return is_near(how, both, &pair[0]) && is_near(how, both, &pair[1]);
}

void rw_traction_simplify(rw_traction *t, double tolerance)
{
    fit how = {.f = values_of, .tolerance = tolerance};
    rw_element both;
    size_t last = 0;
    make_rule(&how.rule);
    t->cluster_count = 0;
    for (size_t i = 1; i < t->count; i++)
        if (join(&how, &t->elements[last], &t->elements[i], &both))
            t->elements[last] = both;
        else
            t->elements[++last] = t->elements[i];
    t->count = last + 1;
}

/* Whether one element fits a traction, also at a kink that may be in it. */
static bool is_fitted(const fit *how, rw_element *e, double kink)
{
    expand(how, e);
    if (!is_fine(how, rest_of(e), HUGE_VAL))
        return false;
    complete(e, &how->rule);
    const rw_traction alone = {.elements = e, .count = 1};
    const double apart = rw_traction_at(&alone, kink) - rw_traction_at(how->context, kink);
    return !(kink > e->low && kink < e->high) || fabs(apart) <= RW_AT_KINK * how->tolerance;
}

bool rw_traction_is_smooth(const rw_traction *t, double from, double kink, double to,
                           double tolerance)
{
    const double half = to / 2 - from / 2;
    fit how = {.f = values_of, .context = t, .tolerance = tolerance};
    rw_element first = {.end = from, .scale = half, .last = 1},
               last = {.end = to, .scale = -half, .last = 1};
    make_rule(&how.rule);
    return is_fitted(&how, &first, kink) && is_fitted(&how, &last, kink);
}
