/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With t = (z - centre)/(2 radius), what is interpolated has its nearest singularity beyond |t| =
 * 2.5, and the disc is |t| <= 1/2. Chebyshev's series over -1 < t < 1 then converges like 0.338^n
 * at the top of the disc, t = i/2: 24 terms leave 5e-12. */
#include "yield/neighbourhood.h"

#include "base/domain.h"

/* Distances in radii of the disc. */
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

/* The sum of a series at t, and its derivative: Clenshaw's recurrence. */
static double complex series_at(const rw_neighbourhood *n, double complex t, double complex *slope)
{
    double complex b = 0, b_next = 0, d = 0, d_next = 0;
    for (int k = RW_NODES - 1; k > 0; k--) {
        const double complex steeper = 2 * (b + t * d) - d_next;
        const double complex higher = n->coefficient[k] + 2 * (t * b) - b_next;
        d_next = d;
        d = steeper;
        b_next = b;
        b = higher;
    }
    *slope = b + t * d - d_next;
    return n->coefficient[0] + t * b - b_next;
}

static double node(int i)
{
    return cos((i + 0.5) * RW_PI / RW_NODES);
}

/* The coefficients of a series from its values at the nodes. */
static void transform(const rw_fields *values, rw_neighbourhood *n)
{
    for (int i = 0; i < RW_NODES; i++) {
        const double complex value = values->G_re[i] + values->G_im[i] * I;
        double before = node(i), wave = 1; /* cos(k arccos(node)) */
        for (int k = 0; k < RW_NODES; k++) {
            n->coefficient[k] += (k == 0 ? 1.0 : 2.0) / RW_NODES * wave * value;
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
static double complex interpolated(const rw_neighbourhood *outer, double x)
{
    double complex slope;
    return isinf(outer->radius)
               ? 0
               : series_at(outer, (x - outer->centre) / (INTERVAL * outer->radius), &slope);
}

rw_neighbourhood rw_neighbourhood_within(const rwedge_contact *contact,
                                         const rw_neighbourhood *outer, double centre,
                                         double radius)
{
    if (!(fabs(centre - outer->centre) + radius <= outer->radius))
        return rw_neighbourhood_whole(contact);
    rw_neighbourhood inner = {centre, radius, outer->first, outer->last, {0}};
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
        const double complex value = interpolated(outer, x[i]);
        values.G_re[i] = creal(value);
        values.G_im[i] = cimag(value);
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
        double complex slope;
        const double complex value = series_at(n, (x[i] - n->centre) / unit + t_y * I, &slope);
        sum->G_re[i] += creal(value);
        sum->G_im[i] += cimag(value);
        sum->H_re[i] += t_y * creal(slope);
        sum->H_im[i] += t_y * cimag(slope);
    }
}
