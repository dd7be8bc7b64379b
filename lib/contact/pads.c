/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts of other pads than the wedge. A cylinder is a wedge of which only the rounding touches;
 * any other pad is a list of arcs. */
#include "contact/pads.h"
#include "contact/handle.h"

#include "base/array.h"
#include "base/domain.h"
#include "base/logarithm.h"
#include "base/root.h"

enum { MOST_PLACES = 1000 };

rw_pad *rw_pad_create(size_t count)
{
    rw_pad *pad = malloc(sizeof *pad);
    if (!pad)
        return NULL;
    *pad = (rw_pad){.arcs = malloc(count * sizeof *pad->arcs),
                    .weights = malloc(count * sizeof *pad->weights)};
    if (pad->arcs && pad->weights)
        return pad;
    rw_pad_destroy(pad);
    return NULL;
}

rw_pad *rw_pad_copy(const rw_pad *pad, bool *is_whole)
{
    rw_pad *copy = rw_copied(pad, pad != NULL, sizeof *copy, is_whole);
    if (!copy)
        return NULL;
    copy->arcs = rw_copied(pad->arcs, pad->count, sizeof *pad->arcs, is_whole);
    copy->weights = rw_copied(pad->weights, pad->count, sizeof *pad->weights, is_whole);
    return copy;
}

void rw_pad_destroy(rw_pad *pad)
{
    if (!pad)
        return;
    free(pad->arcs);
    free(pad->weights);
    free(pad);
}

void rw_pad_append(rw_pad *pad, rw_arc arc, double weight)
{
    pad->arcs[pad->count] = arc;
    pad->weights[pad->count++] = weight;
    pad->is_symmetric = true;
    for (size_t i = 0, j = pad->count - 1; i <= j && j < pad->count; i++, j--)
        if (pad->arcs[i].left != -pad->arcs[j].right || pad->arcs[i].right != -pad->arcs[j].left ||
            pad->weights[i] != pad->weights[j])
            pad->is_symmetric = false;
}

/* The contact takes the pad over, which is destroyed where that fails. */
static int32_t create(rw_geometry geometry, double f, rwedge_contact **contact)
{
    const int32_t status = geometry.pad ? rw_contact_create(&geometry, f, contact) : RWEDGE_ENOMEM;
    if (status != RWEDGE_OK)
        rw_pad_destroy(geometry.pad);
    return status;
}

/* ---- A cylinder, and a flat with rounded edges ---- */

int32_t rwedge_contact_create_flat(double a, double R, double A, double f, rwedge_contact **contact)
{
    rw_geometry geometry = {.theta = 1, .a = R, .A = A, .reach = a + R};
    if (!rw_is_magnitude(a) || !rw_is_positive(R) || !rw_is_positive(A) || !rw_is_friction(f) ||
        !rw_is_positive(geometry.reach))
        return RWEDGE_EDOMAIN;
    if (!contact)
        return RWEDGE_ENULL;
    if (a == 0)
        return rw_contact_create(&geometry, f, contact);
    geometry.pad = rw_pad_create(2);
    if (geometry.pad) {
        rw_pad_append(geometry.pad, (rw_arc){-geometry.reach, -a}, 0.5);
        rw_pad_append(geometry.pad, (rw_arc){a, geometry.reach}, 0.5);
    }
    return create(geometry, f, contact);
}

/* ---- Any convex profile ---- */

static bool is_profile(size_t n, const double x[], const double slope[])
{
    if (n < 2 || n > MOST_PLACES)
        return false;
    for (size_t i = 0; i < n; i++) {
        if (!rw_is_signed(x[i]) || !rw_is_signed(slope[i]) || !(fabs(slope[i]) < RW_HALF_PI))
            return false;
        if (i > 0 && !(x[i] >= x[i - 1] && slope[i] >= slope[i - 1]))
            return false;
    }
    return rw_is_positive(slope[n - 1] - slope[0]);
}

static rw_pad *pad_of(size_t n, const double x[], const double slope[], rw_geometry *g)
{
    rw_pad *pad = rw_pad_create(n - 1);
    g->a = HUGE_VAL;
    for (size_t i = 1; pad && i < n; i++) {
        const rw_arc arc = {x[i - 1], x[i]};
        const double weight = (slope[i] - slope[i - 1]) / (slope[n - 1] - slope[0]);
        if (weight == 0)
            continue;
        rw_pad_append(pad, arc, weight);
        g->a = fmin(g->a, rw_arc_half_length(arc) / weight);
    }
    return pad;
}

int32_t rwedge_contact_create_profile(size_t n, const double x[], const double slope[], double A,
                                      double f, rwedge_contact **contact)
{
    if (!x || !slope)
        return RWEDGE_ENULL;
    if (!is_profile(n, x, slope) || !rw_is_positive(A) || !rw_is_friction(f))
        return RWEDGE_EDOMAIN;
    rw_geometry geometry = {.theta = (slope[n - 1] - slope[0]) / 2, .A = A};
    if (!rw_is_positive(geometry.theta) || !rw_is_positive(rw_unit_stress(&geometry)))
        return RWEDGE_EDOMAIN;
    if (!contact)
        return RWEDGE_ENULL;
    geometry.middle_slope = slope[0] / 2 + slope[n - 1] / 2;
    geometry.pad = pad_of(n, x, slope, &geometry);
    return create(geometry, f, contact);
}

/* ---- What a contact is ---- */

static int32_t kind_of(const rw_geometry *g)
{
    if (g->pad)
        return g->reach > 0 ? RWEDGE_PAD_FLAT : RWEDGE_PAD_PROFILE;
    return g->reach > 0 ? RWEDGE_PAD_CYLINDER : RWEDGE_PAD_WEDGE;
}

int32_t rwedge_contact_kind(const rwedge_contact *contact)
{
    return contact ? kind_of(&contact->geometry) : -1;
}

/* Half of the flat; 0 of a cylinder. */
static double flat_of(const rw_geometry *g)
{
    return kind_of(g) == RWEDGE_PAD_FLAT ? g->pad->arcs[1].left : 0;
}

int32_t rwedge_contact_pad(const rwedge_contact *contact, double *theta, double *a, double *R,
                           double *A, double *f)
{
    if (!contact || !theta || !a || !R || !A || !f)
        return RWEDGE_ENULL;
    const rw_geometry *g = &contact->geometry;
    const bool is_wedge = kind_of(g) == RWEDGE_PAD_WEDGE;
    *theta = is_wedge ? g->theta : 0;
    *a = is_wedge ? g->a : flat_of(g);
    *R = g->reach > 0 ? g->a : 0;
    *A = g->A;
    *f = contact->f;
    return RWEDGE_OK;
}

/* The ends of the arcs, which may touch. The slopes go into `slope`, unless it is NULL. */
static size_t places_of(const rw_geometry *g, double x[], double slope[])
{
    const rw_arcs arcs = rw_arcs_of(g);
    double weight = 0; /* of the arcs so far */
    size_t n = 0;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        const double ends[2] = {arc.left, arc.right};
        for (int k = i > 0 && rw_arc_at(&arcs, i - 1).right == arc.left; k < 2; k++, n++) {
            weight += k * rw_arc_weight(&arcs, i);
            if (!slope)
                continue;
            x[n] = ends[k];
            slope[n] = g->middle_slope + g->theta * (2 * weight - 1);
        }
    }
    return n;
}

size_t rwedge_contact_place_count(const rwedge_contact *contact)
{
    return contact ? places_of(&contact->geometry, NULL, NULL) : 0;
}

int32_t rwedge_contact_places(const rwedge_contact *contact, size_t n, double x[], double slope[])
{
    if (!contact || !x || !slope)
        return RWEDGE_ENULL;
    if (n != rwedge_contact_place_count(contact))
        return RWEDGE_ERANGE;
    places_of(&contact->geometry, x, slope);
    return RWEDGE_OK;
}

/* ---- The edges from the flat's corners ---- */

/* The load of a flat pad in theta/A that is in contact up to d beyond its corners: s^2 (psi - sin
 * psi cos psi)/R, cos psi = a/s. */
typedef struct {
    double a, R, P;
} flat_pad;

static double beyond_excess(double d, const void *context)
{
    const flat_pad *p = context;
    const double a = p->a, s = a + d, sine = sqrt(d / s) * sqrt((2 * a + d) / s);
    return s / p->R * s * rw_arc_less_product(rw_angle(a / s, sine), sine, a / s) - p->P;
}

static double beyond_flat(const flat_pad *p)
{
    double hi = p->a + p->R;
    while (beyond_excess(hi / 4, p) > 0)
        hi /= 4;
    return rw_root(beyond_excess, p, hi / 4, hi, 0);
}

int32_t rwedge_contact_beyond_flat(const rwedge_contact *contact, double *left, double *right)
{
    if (!contact || !left || !right)
        return RWEDGE_ENULL;
    const rw_geometry *g = &contact->geometry;
    if (contact->phase == RW_APART)
        return RWEDGE_EABSENT;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const double a = flat_of(g);
    const flat_pad p = {a, g->a, rw_as_length(g, contact->loads.P)};
    const bool is_level = a > 0 && patch.right == -patch.left;
    *left = is_level ? beyond_flat(&p) : -a - patch.left;
    *right = is_level ? *left : patch.right - a;
    return RWEDGE_OK;
}
