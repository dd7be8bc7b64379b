/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The zone that never slips in a cycle: the part that all steps have in common of where they slip
 * nowhere. A step in closed form has one such patch, which the paths before and after it have in
 * common. Of a computed step it is where the state after it sticks. */
#include "cycle/stuck.h"

#include <stdlib.h>

rw_patch rw_stuck_between(const rwedge_contact *before, const rwedge_contact *after)
{
    if (before->phase == RW_COMPUTED || after->phase == RW_COMPUTED || rw_slides_as_known(after))
        return RW_NOWHERE;
    const rw_memory *path = &after->memory, *old = &before->memory;
    const rw_path old_path = rw_memory_path(old);
    const size_t common = rw_memory_common(path, &old_path);
    if (common == path->count || common == old->count)
        return path->corners[common - 1].patch;
    const rw_corner *next = &path->corners[common], *next_of_old = &old->corners[common];
    if (next->ratio != next_of_old->ratio)
        return path->corners[common - 1].patch;
    return next->load < next_of_old->load ? next->patch : next_of_old->patch;
}

bool rw_stuck_begin(rw_stuck_zones *zones, const rwedge_contact *contact)
{
    rw_patch patch;
    *zones = (rw_stuck_zones){malloc(sizeof *zones->all), 0};
    if (zones->all && contact->f > 0 &&
        rwedge_contact_edges(contact, &patch.left, &patch.right) == RWEDGE_OK)
        zones->all[zones->count++] = patch;
    return zones->all != NULL;
}

/* Leaves of the zones what they have in common with others. */
static bool intersect(rw_stuck_zones *zones, size_t count, const rw_patch other[], double rounding)
{
    rw_patch *common = malloc((zones->count * count + 1) * sizeof *common);
    size_t kept = 0;
    for (size_t i = 0; common && i < zones->count; i++)
        for (size_t j = 0; j < count; j++) {
            const rw_patch both = {fmax(zones->all[i].left, other[j].left),
                                   fmin(zones->all[i].right, other[j].right)};
            if (both.right - both.left > rounding)
                common[kept++] = both;
        }
    free(zones->all);
    *zones = (rw_stuck_zones){common, kept};
    return common != NULL;
}

bool rw_stuck_go_on(rw_stuck_zones *zones, const rwedge_contact *after, rw_patch stuck,
                    double rounding)
{
    const rw_zones all = rw_contact_zones(after);
    rw_patch sticks[RW_MOST_ZONES];
    size_t count = 0;
    if (stuck.left <= stuck.right)
        sticks[count++] = stuck;
    for (int i = 0; i < all.count && !(stuck.left <= stuck.right); i++)
        if (all.zone[i].label == 0)
            sticks[count++] = (rw_patch){all.zone[i].left, all.zone[i].right};
    return zones->count == 0 || intersect(zones, count, sticks, rounding);
}

rw_patch rw_stuck_widest(const rw_stuck_zones *zones)
{
    rw_patch best = {0, 0};
    for (size_t i = 0; i < zones->count; i++)
        if (zones->all[i].right - zones->all[i].left > best.right - best.left)
            best = zones->all[i];
    return best;
}
