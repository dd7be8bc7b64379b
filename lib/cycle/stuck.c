/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The zone that never slips in a cycle: the part that all steps have in common of where they slip
 * nowhere. A step in closed form has one such patch, which the paths before and after it have in
 * common. Of a computed step it is where the state after it sticks. */
#include "cycle/cycle.h"

#include <stdlib.h>

typedef struct {
    rw_patch *all;
    size_t count;
} patches;

/* Where a state sticks since the state before it: at most RW_MOST_ZONES patches. */
static size_t stuck_in(const rw_state *state, rw_patch stuck[])
{
    const rw_zones zones = rw_contact_zones(state->contact);
    size_t count = 0;
    stuck[0] = state->stuck;
    if (!state->is_computed)
        return 1;
    for (int i = 0; i < zones.count; i++)
        if (zones.zone[i].label == 0)
            stuck[count++] = (rw_patch){zones.zone[i].left, zones.zone[i].right};
    return count;
}

/* Leaves of the patches what they have in common with others. false where memory is short. */
static bool intersect(patches *p, size_t count, const rw_patch other[], double rounding)
{
    rw_patch *common = malloc((p->count * count + 1) * sizeof *common);
    size_t kept = 0;
    for (size_t i = 0; common && i < p->count; i++)
        for (size_t j = 0; j < count; j++) {
            const rw_patch both = {fmax(p->all[i].left, other[j].left),
                                   fmin(p->all[i].right, other[j].right)};
            if (both.right - both.left > rounding)
                common[kept++] = both;
        }
    free(p->all);
    *p = (patches){common, kept};
    return common != NULL;
}

static int32_t widest(const patches *p, double *left, double *right)
{
    rw_patch best = {0, 0};
    for (size_t i = 0; i < p->count; i++)
        if (p->all[i].right - p->all[i].left > best.right - best.left)
            best = p->all[i];
    if (p->count == 0)
        return RWEDGE_EABSENT;
    *left = best.left;
    *right = best.right;
    return RWEDGE_OK;
}

int32_t rwedge_cycle_permanent_stick(const rwedge_cycle *cycle, double *left, double *right)
{
    if (!cycle || !left || !right)
        return RWEDGE_ENULL;
    const rw_states *all = cycle->slip_status == RWEDGE_OK ? &cycle->on_the_way : &cycle->at_loads;
    if (all->states[0].contact->f == 0 || isnan(all->states[0].patch.left))
        return RWEDGE_EABSENT;
    patches never = {malloc(sizeof *never.all), 1};
    bool is_whole = never.all != NULL;
    if (is_whole)
        never.all[0] = all->states[0].patch;
    for (size_t i = 1; i < all->count && is_whole && never.count > 0; i++) {
        rw_patch stuck[RW_MOST_ZONES];
        const size_t count = stuck_in(&all->states[i], stuck);
        is_whole = intersect(&never, count, stuck, all->rounding);
    }
    const int32_t status = is_whole ? widest(&never, left, right) : RWEDGE_ENOMEM;
    free(never.all);
    return status;
}
