/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history/slip_origin.h"

#include "base/always.h"
#include "base/domain.h"

#include <stdint.h>
#include <stdlib.h>

static void pop(rw_slip_origins *origins)
{
    origins->count--;
    rw_memory_destroy(&origins->all[origins->count].base);
}

static bool reserve(rw_slip_origins *origins, size_t more)
{
    if (origins->capacity - origins->count >= more)
        return true;
    if (NEVER(origins->count > SIZE_MAX / sizeof *origins->all / 2 - more)) /* memory ends before */
        return false;
    const size_t capacity = origins->count + origins->count / 2 + more;
    rw_slip_origin *grown = realloc(origins->all, capacity * sizeof *grown);
    if (!grown)
        return false;
    origins->all = grown;
    origins->capacity = capacity;
    return true;
}

bool rw_slip_origins_copy(const rw_slip_origins *origins, rw_slip_origins *copy)
{
    *copy = (rw_slip_origins){.fresh = origins->fresh};
    if (!reserve(copy, origins->count))
        return false;
    for (; copy->count < origins->count; copy->count++) {
        copy->all[copy->count] = origins->all[copy->count];
        if (!rw_memory_copy(&origins->all[copy->count].base, &copy->all[copy->count].base)) {
            rw_slip_origins_destroy(copy);
            return false;
        }
    }
    return true;
}

void rw_slip_origins_destroy(rw_slip_origins *origins)
{
    while (origins->count > 0)
        pop(origins);
    free(origins->all);
    *origins = (rw_slip_origins){0};
}

/* Points beyond the load have separated. */
static void cut_off(rw_slip_origins *origins, double load)
{
    rw_slip_origin *all = origins->all;
    while (origins->count > 0 && (origins->count > 1 ? all[origins->count - 2].end : 0) >= load)
        pop(origins);
    if (origins->count > 0)
        all[origins->count - 1].end = fmin(all[origins->count - 1].end, load);
    origins->fresh = fmin(origins->fresh, load);
}

bool rw_slip_origins_advance(rw_slip_origins *origins, const rw_memory *memory, bool slips,
                             double load, double shear)
{
    const rw_corner *end = rw_memory_end(memory);
    if (slips && load > origins->fresh) {
        rw_slip_origin origin = {fmax(end->load, load), {0}, end->load, end->shear, load, shear};
        if (!reserve(origins, 1) || !rw_memory_copy(memory, &origin.base))
            return false;
        origins->all[origins->count++] = origin;
        origins->fresh = origin.end;
    }
    if (load < end->load)
        cut_off(origins, load);
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

rw_departure rw_slip_origin_departure(const rw_slip_origin *origin, double u)
{
    double shear;
    if (u <= origin->from_load) {
        shear = rw_memory_shear(&origin->base, u);
    } else {
        const double fraction = (u - origin->from_load) / (origin->to_load - origin->from_load);
        shear = origin->from_shear + fraction * (origin->to_shear - origin->from_shear);
    }
    const rw_corner *end = rw_memory_end(&origin->base);
    const rw_loading to = {.load = u, .shear = shear, .stretch = end->stretch};
    return rw_memory_departure(&origin->base, to);
}
