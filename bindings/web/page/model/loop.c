/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include <math.h>

enum { STATES = 240, STEPS_MAX = 24 };

static bool is_centred(const last_cycle *cycle)
{
    const load before = loads_of(cycle->before);
    bool centred = cycle->setup->f > 0 && before.P > 0;
    for (size_t i = 0; i < cycle->loads; i++)
        centred = centred && cycle->P[i] == before.P && cycle->M[i] == 0 && cycle->sigma[i] == 0;
    return centred;
}

static void note_whole(const last_cycle *cycle, const rwedge_contact *contact, loop *path)
{
    path->x[path->count] =
        rwedge_contact_displacement(contact, rwedge_contact_half_width(cycle->before));
    path->y[path->count++] = loads_of(contact).Q;
}

static void note_place(const rwedge_contact *contact, loop *path)
{
    double slip, p, q;
    if (rwedge_contact_slip(contact, 1, &path->place, &slip) != RWEDGE_OK ||
        rwedge_contact_tractions(contact, 1, &path->place, &p, &q) != RWEDGE_OK)
        return;
    path->x[path->count] = slip;
    path->y[path->count++] = q;
}

static void note(const last_cycle *cycle, const rwedge_contact *contact, loop *path)
{
    if (path->is_whole)
        note_whole(cycle, contact, path);
    else
        note_place(contact, path);
}

/* From one load to the next, in steps as far as they can be had; the last one is the load. */
static void note_way(const last_cycle *cycle, size_t next, int steps, rwedge_contact *contact,
                     loop *path)
{
    const load from = loads_of(contact),
               to = {cycle->P[next], cycle->M[next], cycle->Q[next], cycle->sigma[next]};
    for (int i = 1; i < steps; i++) {
        if (loads_apply(loads_between(from, to, i, steps), contact) != RWEDGE_OK)
            break;
        note(cycle, contact, path);
    }
    loads_apply(to, contact);
    note(cycle, contact, path);
}

loop loop_of(const last_cycle *cycle, double place)
{
    const int steps = (int)fmax(1, fmin(STEPS_MAX, round((double)STATES / (double)cycle->loads)));
    const size_t room = (size_t)steps * cycle->loads + 1;
    loop path = {.is_whole = is_centred(cycle), .place = place};
    rwedge_contact *contact = NULL;
    path.x = memory_zeroed(2 * room, sizeof *path.x);
    path.y = path.x + room;
    if ((!path.is_whole && (!cycle->slip_known || isnan(place))) ||
        rwedge_contact_copy(cycle->before, &contact) != RWEDGE_OK)
        return path;
    note(cycle, contact, &path);
    for (size_t i = 0; i < cycle->loads; i++)
        note_way(cycle, i, steps, contact, &path);
    rwedge_contact_destroy(contact);
    return path;
}
