/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "yield/marks.h"

/* How far the contact reaches from the centre. */
static double extent(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    return fmax(-patch.left, patch.right);
}

int rw_main_marks(const rwedge_contact *contact)
{
    return 3 + 2 * (int)rw_arcs_of(&contact->geometry).count;
}

/* The middle of an arc as far as it is in contact, and its nearer edge where it is not. */
static double main_place(const rwedge_contact *contact, int i)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const int side = i % 2 ? 1 : -1;
    if (i < 3)
        return i == 0 ? 0 : rw_mark_edge(patch, side);
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const rw_arc arc = rw_arc_at(&arcs, (size_t)(i - 3) / 2);
    return side > 0 ? fmax(fmin(arc.right, patch.right), patch.left)
                    : fmin(fmax(arc.left, patch.left), patch.right);
}

static void look_to(rw_mark *m, double other, bool is_before)
{
    const double distance = fabs(m->at - other);
    if (is_before)
        m->reach = fmin(m->reach, 2 * distance);
    if (distance > 0)
        m->nearest = fmin(m->nearest, distance);
}

/* A mark that has seen the main marks, of which the first `before` come before it. It may be the
 * next of them itself. */
static rw_mark mark_at(const rwedge_contact *contact, double at, int before)
{
    rw_mark m = {at, 3 * extent(contact), extent(contact)};
    for (int i = 0; i < rw_main_marks(contact); i++)
        if (i != before)
            look_to(&m, main_place(contact, i), i < before);
    return m;
}

rw_mark rw_main_mark(const rwedge_contact *contact, int i)
{
    rw_mark m = mark_at(contact, main_place(contact, i), i);
    for (size_t k = 1; k < contact->memory.count - 1; k++)
        for (int side = -1; side <= 1; side += 2)
            look_to(&m, rw_mark_edge(contact->memory.corners[k].patch, side), false);
    return m;
}

rw_mark rw_patch_mark(const rwedge_contact *contact, size_t inner, size_t i, size_t outer, int side)
{
    const rw_corner *corners = contact->memory.corners;
    rw_mark m = mark_at(contact, rw_mark_edge(corners[i].patch, side), rw_main_marks(contact));
    look_to(&m, rw_mark_edge(corners[i].patch, -side), side < 0);
    look_to(&m, rw_mark_edge(corners[i - 1].patch, side), false);
    look_to(&m, rw_mark_edge(corners[i + 1].patch, side), false);
    if (inner > 0)
        look_to(&m, rw_mark_edge(corners[inner].patch, side), true);
    look_to(&m, rw_mark_edge(corners[outer].patch, side), true);
    return m;
}

rw_mark rw_kink_mark(const rwedge_contact *contact, const rw_shear_state *shear, int i)
{
    rw_mark m = mark_at(contact, shear->kink[i], rw_main_marks(contact));
    for (int j = 0; j < shear->kinks; j++)
        if (j != i)
            look_to(&m, shear->kink[j], j < i);
    return m;
}
