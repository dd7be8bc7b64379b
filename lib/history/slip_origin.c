/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history/slip_origin.h"

#include "base/array.h"
#include "base/domain.h"

#include <string.h>

bool rw_slip_origins_reserve(rw_slip_origins *origins, size_t more, size_t corners)
{
    rw_slip_origin *all =
        rw_grown(origins->all, origins->count, &origins->capacity, more, sizeof *all);
    if (all)
        origins->all = all;
    return all && rw_memory_reserve(&origins->own, corners);
}

rw_slip_origins rw_slip_origins_copy(const rw_slip_origins *origins, bool *is_whole)
{
    rw_slip_origins copy = *origins;
    copy.all = rw_copied(origins->all, origins->count, sizeof *copy.all, is_whole);
    copy.capacity = origins->count;
    copy.own = rw_memory_copy(&origins->own, is_whole);
    return copy;
}

void rw_slip_origins_destroy(rw_slip_origins *origins)
{
    free(origins->all);
    rw_memory_destroy(&origins->own);
    *origins = (rw_slip_origins){0};
}

/* A new branch behind the last one. Where two jumps of equal length meet, the next one is as long
 * as both. */
static void branch_off(const rw_slip_origins *origins, rw_slip_origin *branch)
{
    const rw_slip_origin *all = origins->all;
    branch->first = origins->own.count;
    branch->before = branch->jump = origins->count;
    branch->depth = 0;
    if (branch->shared == 0)
        return;
    size_t before = origins->count - 1;
    while (all[before].shared >= branch->shared)
        before = all[before].before;
    const size_t jump = all[before].jump, twice = all[jump].jump;
    const bool is_even = all[before].depth - all[jump].depth == all[jump].depth - all[twice].depth;
    branch->before = before;
    branch->jump = is_even ? twice : before;
    branch->depth = all[before].depth + 1;
}

void rw_slip_origins_keep(rw_slip_origins *origins, rw_slip_origin origin, const rw_corner own[])
{
    const size_t more = origin.corners - origin.shared;
    branch_off(origins, &origin);
    origins->all[origins->count++] = origin;
    memmove(origins->own.corners + origins->own.count, own, more * sizeof *own);
    origins->own.count += more;
}

/* Removes the last origin. */
static void pop(rw_slip_origins *origins, rw_memory *memory)
{
    const rw_slip_origin *last = &origins->all[--origins->count];
    origins->own.count = last->first;
    if (memory->shared > last->shared)
        memory->shared = last->shared;
}

size_t rw_slip_origins_last_corners(const rw_slip_origins *origins)
{
    return origins->count > 0 ? origins->all[origins->count - 1].corners : 0;
}

size_t rw_slip_origins_corners(const rw_slip_origins *origins)
{
    size_t roots = 0;
    for (size_t i = 0; i < origins->count; i++)
        roots += origins->all[i].shared == 0;
    return origins->own.count - roots;
}

/* Removes the points beyond the load, which have separated. */
static void cut_off(rw_slip_origins *origins, rw_memory *memory, double load)
{
    rw_slip_origin *all = origins->all;
    while (origins->count > 0 && (origins->count > 1 ? all[origins->count - 2].end : 0) >= load)
        pop(origins, memory);
    if (origins->count > 0)
        all[origins->count - 1].end = fmin(all[origins->count - 1].end, load);
    origins->fresh = fmin(origins->fresh, load);
}

bool rw_slip_origins_advance(rw_slip_origins *origins, rw_memory *memory, bool slips, double load,
                             double shear)
{
    const rw_corner *end = rw_memory_end(memory);
    if (slips && load > origins->fresh) {
        const rw_slip_origin origin = {.end = fmax(end->load, load),
                                       .from_load = end->load,
                                       .from_shear = end->shear,
                                       .to_load = load,
                                       .to_shear = shear,
                                       .corners = memory->count,
                                       .shared = memory->shared};
        if (!rw_slip_origins_reserve(origins, 1, memory->count - memory->shared))
            return false;
        rw_slip_origins_keep(origins, origin, memory->corners + memory->shared);
        memory->shared = memory->count;
        origins->fresh = origin.end;
    }
    if (load < end->load)
        cut_off(origins, memory, load);
    return true;
}

const rw_slip_origin *rw_slip_origin_of(const rw_slip_origins *origins, double u)
{
    if (origins->count == 0 || u > origins->all[origins->count - 1].end)
        return NULL;
    size_t low = 0, high = origins->count - 1; /* the first whose end is not below u */
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (origins->all[middle].end >= u)
            high = middle;
        else
            low = middle + 1;
    }
    return &origins->all[low];
}

rw_path rw_slip_origin_path(const rw_slip_origins *origins, const rw_slip_origin *origin)
{
    return (rw_path){origins->own.corners, origins->all, (size_t)(origin - origins->all),
                     origin->corners};
}

rw_departure rw_slip_origin_departure(const rw_slip_origin *origin, const rw_path *path, double u)
{
    double shear;
    if (u <= origin->from_load) {
        shear = rw_path_shear(path, u);
    } else {
        const double fraction = (u - origin->from_load) / (origin->to_load - origin->from_load);
        shear = origin->from_shear + fraction * (origin->to_shear - origin->from_shear);
    }
    const rw_corner *end = rw_path_end(path);
    const rw_memory_loads to = {.load = u, .shear = shear, .stretch = end->stretch};
    return rw_departure_from(path, to);
}
