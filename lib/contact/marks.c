/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/marks.h"

/* How far the contact reaches from the centre. */
static double extent(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    return fmax(-patch.left, patch.right);
}

/* The rounding as far as it is in contact. */
static rw_patch rounding(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const double a = contact->geometry.a;
    return (rw_patch){fmax(-a, patch.left), fmin(a, patch.right)};
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
    const rw_patch parts[] = {corners[contact->memory.count - 1].patch, rounding(contact)};
    rw_mark m = {rw_mark_edge(corners[i].patch, side), 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    look_to(&m, rw_mark_edge(corners[i].patch, -side), side < 0);
    for (int k = 0; k < 2; k++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, rw_mark_edge(parts[k], of), true);
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
    const rw_patch parts[] = {{0, 0}, corners[last].patch, rounding(contact)};
    rw_mark m = {rw_mark_edge(parts[part], side), 3 * extent(contact), extent(contact)};
    for (int k = 0; k < 3; k++)
        for (int of = -1; of <= 1; of += 2)
            if (k != part || of != side)
                look_to(&m, rw_mark_edge(parts[k], of), k < part || (k == part && side < of));
    for (size_t i = 1; i < last; i++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, rw_mark_edge(corners[i].patch, of), false);
    return m;
}

rw_mark rw_kink_mark(const rwedge_contact *contact, const rw_shear_state *shear, int i)
{
    const rw_patch parts[] = {rw_memory_end(&contact->memory)->patch, rounding(contact)};
    rw_mark m = {shear->kink[i], 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    for (int k = 0; k < 2; k++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, rw_mark_edge(parts[k], of), true);
    for (int j = 0; j < shear->kinks; j++)
        if (j != i)
            look_to(&m, shear->kink[j], j < i);
    return m;
}
