/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact says of its pad. */
#include "pads/pads.h"

int32_t rw_pad_kind(const rw_geometry *g)
{
    if (g->pad)
        return g->reach > 0 ? RWEDGE_PAD_FLAT : RWEDGE_PAD_PROFILE;
    return g->reach > 0 ? RWEDGE_PAD_CYLINDER : RWEDGE_PAD_WEDGE;
}

int32_t rwedge_contact_kind(const rwedge_contact *contact)
{
    return contact ? rw_pad_kind(&contact->geometry) : -1;
}

double rw_pad_flat(const rw_geometry *g)
{
    return rw_pad_kind(g) == RWEDGE_PAD_FLAT ? g->pad->arcs[1].left : 0;
}

int32_t rwedge_contact_pad(const rwedge_contact *contact, double *theta, double *a, double *R,
                           double *A, double *f)
{
    if (!contact || !theta || !a || !R || !A || !f)
        return RWEDGE_ENULL;
    const rw_geometry *g = &contact->geometry;
    const bool is_wedge = rw_pad_kind(g) == RWEDGE_PAD_WEDGE;
    *theta = is_wedge ? g->theta : 0;
    *a = is_wedge ? g->a : rw_pad_flat(g);
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
