/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "yield/marks.h"

/* After the centre and the contact. */
enum { FIRST_ARC = 2 };

/* How far the contact reaches from the centre. */
static double extent(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    return fmax(-patch.left, patch.right);
}

int rw_main_parts(const rwedge_contact *contact)
{
    return FIRST_ARC + (int)rw_arcs_of(&contact->geometry).count;
}

/* An arc as far as it is in contact; its nearer edge where it is not. */
static rw_patch part_of(const rwedge_contact *contact, int part)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    if (part < FIRST_ARC)
        return part == 0 ? (rw_patch){0, 0} : patch;
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const rw_arc arc = rw_arc_at(&arcs, (size_t)(part - FIRST_ARC));
    return (rw_patch){fmin(fmax(arc.left, patch.left), patch.right),
                      fmax(fmin(arc.right, patch.right), patch.left)};
}

static void look_to(rw_mark *m, double other, bool is_before)
{
    const double distance = fabs(m->at - other);
    if (is_before)
        m->reach = fmin(m->reach, 2 * distance);
    if (distance > 0)
        m->nearest = fmin(m->nearest, distance);
}

rw_mark rw_patch_mark(const rwedge_contact *contact, size_t inner, size_t i, size_t outer, int side)
{
    const rw_corner *corners = contact->memory.corners;
    rw_mark m = {rw_mark_edge(corners[i].patch, side), 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    look_to(&m, rw_mark_edge(corners[i].patch, -side), side < 0);
    for (int k = 1; k < rw_main_parts(contact); k++)
        for (int edge = -1; edge <= 1; edge += 2)
            look_to(&m, rw_mark_edge(part_of(contact, k), edge), true);
    look_to(&m, rw_mark_edge(corners[i - 1].patch, side), false);
    look_to(&m, rw_mark_edge(corners[i + 1].patch, side), false);
    if (inner > 0)
        look_to(&m, rw_mark_edge(corners[inner].patch, side), true);
    look_to(&m, rw_mark_edge(corners[outer].patch, side), true);
    return m;
}

rw_mark rw_main_mark(const rwedge_contact *contact, int part, int side)
{
    const rw_corner *corners = contact->memory.corners;
    const size_t last = contact->memory.count - 1;
    rw_mark m = {rw_mark_edge(part_of(contact, part), side), 3 * extent(contact), extent(contact)};
    for (int k = 0; k < rw_main_parts(contact); k++)
        for (int edge = -1; edge <= 1; edge += 2)
            if (k != part || edge != side)
                look_to(&m, rw_mark_edge(part_of(contact, k), edge),
                        k < part || (k == part && side < edge));
    for (size_t i = 1; i < last; i++)
        for (int edge = -1; edge <= 1; edge += 2)
            look_to(&m, rw_mark_edge(corners[i].patch, edge), false);
    return m;
}

rw_mark rw_kink_mark(const rwedge_contact *contact, const rw_shear_state *shear, int i)
{
    rw_mark m = {shear->kink[i], 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    for (int k = 1; k < rw_main_parts(contact); k++)
        for (int edge = -1; edge <= 1; edge += 2)
            look_to(&m, rw_mark_edge(part_of(contact, k), edge), true);
    for (int j = 0; j < shear->kinks; j++)
        if (j != i)
            look_to(&m, shear->kink[j], j < i);
    return m;
}
