/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With t = (z - centre)/(2 radius), what is interpolated has its nearest singularity beyond |t| =
 * 2.5, and the disc is |t| <= 1/2. Chebyshev's series over -1 < t < 1 then converges like 0.338^n
 * at the top of the disc, t = i/2: 24 terms leave 5e-12. */
#include "yield/neighbourhood.h"

#include "base/domain.h"
#include "potential/eccentric_form.h"

/* In radii of the disc. */
static const double FAR = 5, INTERVAL = 2;

/* A series takes as long as this many patches. */
enum { WORTH_A_SERIES = 8 };

rw_neighbourhood rw_neighbourhood_whole(const rwedge_contact *contact)
{
    return (rw_neighbourhood){.radius = HUGE_VAL, .first = 1, .last = contact->memory.count - 1};
}

static bool is_far(double from, double radius, double place)
{
    return fabs(place - from) > FAR * radius;
}

/* Whether the end of an arc is outside of the patch or far away. */
static bool is_clear(double end, rw_patch p, double centre, double radius)
{
    return end < p.left || end > p.right || is_far(centre, radius, end);
}

/* Whether the potential of a patch is smooth in the disc: its edges, and the ends of its arcs in
 * contact, are far away. */
static bool is_smooth(const rwedge_contact *contact, size_t patch, double centre, double radius)
{
    const rw_patch p = contact->memory.corners[patch].patch;
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    if (!is_far(centre, radius, p.left) || !is_far(centre, radius, p.right))
        return false;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        if (!is_clear(arc.left, p, centre, radius) || !is_clear(arc.right, p, centre, radius))
            return false;
    }
    return true;
}

typedef struct {
    rw_complex value, slope;
} series_value;

/* Clenshaw's recurrence and its derivative. */
static series_value series_at(const rw_neighbourhood *n, rw_complex t)
{
    rw_complex b = {0, 0}, b_next = {0, 0}, d = {0, 0}, d_next = {0, 0};
    for (int k = RW_NODES - 1; k > 0; k--) {
        const rw_complex tb = rw_product(t, b), td = rw_product(t, d);
        const rw_complex steeper = {2 * (b.re + td.re) - d_next.re, 2 * (b.im + td.im) - d_next.im};
        const rw_complex higher = {n->re[k] + 2 * tb.re - b_next.re,
                                   n->im[k] + 2 * tb.im - b_next.im};
        d_next = d;
        d = steeper;
        b_next = b;
        b = higher;
    }
    const rw_complex tb = rw_product(t, b), td = rw_product(t, d);
    return (series_value){{n->re[0] + tb.re - b_next.re, n->im[0] + tb.im - b_next.im},
                          {b.re + td.re - d_next.re, b.im + td.im - d_next.im}};
}

static double node(int i)
{
    return cos((i + 0.5) * RW_PI / RW_NODES);
}

/* The coefficients of a series from its values at the nodes. */
static void transform(const rw_fields *values, rw_neighbourhood *n)
{
    for (int k = 0; k < RW_NODES; k++)
        n->re[k] = n->im[k] = 0;
    for (int i = 0; i < RW_NODES; i++) {
        double before = node(i), wave = 1; /* cos(k arccos(node)) */
        for (int k = 0; k < RW_NODES; k++) {
            const double share = (k == 0 ? 1.0 : 2.0) / RW_NODES * wave;
            n->re[k] += share * values->G_re[i];
            n->im[k] += share * values->G_im[i];
            const double next = 2 * node(i) * wave - before;
            before = wave;
            wave = next;
        }
    }
}

static void add_patches(const rwedge_contact *contact, size_t first, size_t last, const double x[],
                        rw_fields *values)
{
    static const double surface[RW_NODES] = {0};
    for (size_t i = first; i < last; i++) {
        rw_fields field;
        rw_patch_fields(&contact->geometry, contact->memory.corners[i].patch, RW_NODES, x, surface,
                        &field);
        rw_add_fields(&field, rw_patch_weight(&contact->memory, i), RW_NODES, values);
    }
}

/* The function that the outer neighbourhood interpolates, at a place of the surface. */
static rw_complex interpolated(const rw_neighbourhood *outer, double x)
{
    const rw_complex t = {(x - outer->centre) / (INTERVAL * outer->radius), 0}, none = {0, 0};
    return isinf(outer->radius) ? none : series_at(outer, t).value;
}

rw_neighbourhood rw_neighbourhood_within(const rwedge_contact *contact,
                                         const rw_neighbourhood *outer, double centre,
                                         double radius)
{
    if (!(fabs(centre - outer->centre) + radius <= outer->radius))
        return rw_neighbourhood_whole(contact);
    rw_neighbourhood inner = {centre, radius, outer->first, outer->last, {0}, {0}};
    while (inner.first < inner.last && is_smooth(contact, inner.first, centre, radius))
        inner.first++;
    while (inner.first < inner.last && is_smooth(contact, inner.last - 1, centre, radius))
        inner.last--;
    const size_t fewer = inner.first - outer->first + (outer->last - inner.last);
    if (fewer < (isinf(outer->radius) ? WORTH_A_SERIES : 1))
        return *outer;
    double x[RW_NODES];
    rw_fields values = {{0}, {0}, {0}, {0}};
    for (int i = 0; i < RW_NODES; i++) {
        x[i] = centre + INTERVAL * radius * node(i);
        const rw_complex value = interpolated(outer, x[i]);
        values.G_re[i] = value.re;
        values.G_im[i] = value.im;
    }
    add_patches(contact, outer->first, inner.first, x, &values);
    add_patches(contact, inner.last, outer->last, x, &values);
    transform(&values, &inner);
    return inner;
}

void rw_neighbourhood_fields(const rwedge_contact *contact, const rw_neighbourhood *n, int count,
                             const double x[], const double y[], rw_contact_fields *fields)
{
    rw_contact_fields_at(contact, n->first, n->last, count, x, y, fields);
    if (isinf(n->radius))
        return;
    const double unit = INTERVAL * n->radius;
    rw_fields *sum = &fields->tangential;
    for (int i = 0; i < count; i++) {
        const double t_y = y[i] / unit;
        const series_value s = series_at(n, (rw_complex){(x[i] - n->centre) / unit, t_y});
        sum->G_re[i] += s.value.re;
        sum->G_im[i] += s.value.im;
        sum->H_re[i] += t_y * s.slope.re;
        sum->H_im[i] += t_y * s.slope.im;
    }
}
