/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "entry.h"

#include "domain.h"

#include <stdint.h>
#include <stdlib.h>

static void pop(rw_entries *entries)
{
    entries->count--;
    rw_path_destroy(&entries->entries[entries->count].base);
}

static bool reserve(rw_entries *entries, size_t more)
{
    if (entries->capacity - entries->count >= more)
        return true;
    if (entries->count >
        SIZE_MAX / sizeof *entries->entries / 2 - more) /* unreached: memory ends before */
        return false;
    const size_t capacity = entries->count + entries->count / 2 + more;
    rw_entry *grown = realloc(entries->entries, capacity * sizeof *grown);
    if (!grown)
        return false;
    entries->entries = grown;
    entries->capacity = capacity;
    return true;
}

bool rw_entries_copy(const rw_entries *entries, rw_entries *copy)
{
    *copy = (rw_entries){.fresh = entries->fresh};
    if (!reserve(copy, entries->count))
        return false;
    for (; copy->count < entries->count; copy->count++) {
        copy->entries[copy->count] = entries->entries[copy->count];
        if (!rw_path_copy(&entries->entries[copy->count].base, &copy->entries[copy->count].base)) {
            rw_entries_destroy(copy);
            return false;
        }
    }
    return true;
}

void rw_entries_destroy(rw_entries *entries)
{
    while (entries->count > 0)
        pop(entries);
    free(entries->entries);
    *entries = (rw_entries){0};
}

/* Points beyond the load have separated. */
static void cut_off(rw_entries *entries, double load)
{
    rw_entry *all = entries->entries;
    while (entries->count > 0 && (entries->count > 1 ? all[entries->count - 2].end : 0) >= load)
        pop(entries);
    if (entries->count > 0)
        all[entries->count - 1].end = fmin(all[entries->count - 1].end, load);
    entries->fresh = fmin(entries->fresh, load);
}

bool rw_entries_advance(rw_entries *entries, const rw_path *path, double load, double shear)
{
    const rw_corner *end = rw_path_end(path);
    size_t kept;
    int slip;
    rw_path_departure(path, load, shear, &kept, &slip);
    if (slip != 0 && load > entries->fresh) {
        rw_entry entry = {fmax(end->load, load), {0}, end->load, end->shear, load, shear};
        if (!reserve(entries, 1) || !rw_path_copy(path, &entry.base))
            return false;
        entries->entries[entries->count++] = entry;
        entries->fresh = entry.end;
    }
    if (load < end->load)
        cut_off(entries, load);
    return true;
}

const rw_entry *rw_entry_of(const rw_entries *entries, double u)
{
    if (entries->count == 0 || u > entries->entries[entries->count - 1].end)
        return NULL;
    size_t low = 0, high = entries->count - 1; /* the first whose end is not below u */
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (entries->entries[middle].end >= u)
            high = middle;
        else
            low = middle + 1;
    }
    return &entries->entries[low];
}

rw_corner rw_entry_departure(const rw_entry *entry, double u, size_t *kept, int *slip)
{
    double shear;
    if (u <= entry->from_load) {
        shear = rw_path_shear(&entry->base, u);
    } else {
        const double fraction = (u - entry->from_load) / (entry->to_load - entry->from_load);
        shear = entry->from_shear + fraction * (entry->to_shear - entry->from_shear);
    }
    return rw_path_departure(&entry->base, u, shear, kept, slip);
}
