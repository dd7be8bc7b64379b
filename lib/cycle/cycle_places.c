/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places along the surface at which to measure a cycle. The edges of the contact and of the zones
 * that stick are among them, because stresses and slip have their peaks there. */
#include "cycle/states.h"

#include "base/array.h"
#include "base/domain.h"
#include "base/sort.h"

/* Steps across the contact, and beyond each edge; edges. */
enum {
    INSIDE = 200,
    OUTSIDE = 40,
    GRID = INSIDE - 1 + 2 * OUTSIDE,
    MOST_EDGES = RW_CYCLE_PLACES - GRID
};

/* Edges of several loads are one but for this part of the width. */
static const double ROUNDING = 1e-12;

/* ---- Edges ---- */

static bool add(rw_edges *edges, rw_patch zone)
{
    double *grown = rw_grown(edges->all, edges->count, &edges->capacity, 2, sizeof *grown);
    if (!grown)
        return false;
    edges->all = grown;
    edges->all[edges->count++] = zone.left;
    edges->all[edges->count++] = zone.right;
    return true;
}

bool rw_edges_add(rw_edges *edges, const rwedge_contact *contact)
{
    const rw_zones zones = rw_contact_zones(contact);
    rw_patch patch;
    if (rwedge_contact_edges(contact, &patch.left, &patch.right) != RWEDGE_OK)
        return true;
    const bool is_first = edges->count == 0;
    edges->outermost.left = is_first ? patch.left : fmin(edges->outermost.left, patch.left);
    edges->outermost.right = is_first ? patch.right : fmax(edges->outermost.right, patch.right);
    bool is_added = add(edges, patch);
    for (int i = 0; i < zones.count && is_added; i++)
        if (zones.zone[i].label == 0)
            is_added = add(edges, (rw_patch){zones.zone[i].left, zones.zone[i].right});
    return is_added;
}

/* Leaves those that are further than a distance from the one before. Returns how many. */
static size_t thin_out(double x[], size_t n, double distance)
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++)
        if (kept == 0 || x[i] - x[kept - 1] > distance)
            x[kept++] = x[i];
    return kept;
}

/* ---- Places ---- */

/* Across the outermost edges and beyond them, from left to right. */
static void make_grid(rw_patch patch, double x[GRID])
{
    const double middle = (patch.left + patch.right) / 2, half = (patch.right - patch.left) / 2;
    double *inside = x + OUTSIDE, *right = inside + INSIDE - 2;
    for (int i = 1; i < INSIDE; i++)
        inside[i - 1] = middle + half * sin(RW_HALF_PI * (2 * i - INSIDE) / INSIDE);
    for (int i = 1; i <= OUTSIDE; i++) {
        const double part = (double)i / OUTSIDE, beyond = half * part * part;
        x[OUTSIDE - i] = patch.left - beyond;
        right[i] = patch.right + beyond;
    }
}

static size_t places_of(const rw_edges *edges, double x[RW_CYCLE_PLACES])
{
    double grid[GRID];
    size_t n = 0, edge = 0;
    if (edges->count == 0)
        return 0;
    make_grid(edges->outermost, grid);
    for (size_t i = 0; i < GRID; i++) {
        while (edge < edges->count && edges->all[edge] <= grid[i])
            x[n++] = edges->all[edge++];
        x[n++] = grid[i];
    }
    while (edge < edges->count)
        x[n++] = edges->all[edge++];
    return thin_out(x, n, ROUNDING * (edges->outermost.right - edges->outermost.left) / 2);
}

/* Many loads have edges everywhere. Then those that are close to another are left out. */
void rw_edges_settle(rw_edges *edges)
{
    const double width = edges->outermost.right - edges->outermost.left;
    rw_sort(edges->all, edges->count);
    edges->count = thin_out(edges->all, edges->count, ROUNDING * width);
    if (edges->count > MOST_EDGES)
        edges->count = thin_out(edges->all, edges->count, width / MOST_EDGES);
    edges->places = places_of(edges, edges->place);
}

/* ---- Told ---- */

/* Copies the n numbers that there are. */
static int32_t tell(const double all[], size_t count, size_t n, double x[])
{
    if (n > 0 && !x)
        return RWEDGE_ENULL;
    if (n != count)
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++)
        x[i] = all[i];
    return RWEDGE_OK;
}

size_t rwedge_cycle_edge_count(const rwedge_cycle *cycle)
{
    return cycle ? cycle->edges.count : 0;
}

int32_t rwedge_cycle_edges(const rwedge_cycle *cycle, size_t n, double x[])
{
    return cycle ? tell(cycle->edges.all, cycle->edges.count, n, x) : RWEDGE_ENULL;
}

size_t rwedge_cycle_place_count(const rwedge_cycle *cycle)
{
    return cycle ? cycle->edges.places : 0;
}

int32_t rwedge_cycle_places(const rwedge_cycle *cycle, size_t n, double x[])
{
    return cycle ? tell(cycle->edges.place, cycle->edges.places, n, x) : RWEDGE_ENULL;
}

int32_t rwedge_cycle_permanent_stick(const rwedge_cycle *cycle, double *left, double *right)
{
    if (!cycle || !left || !right)
        return RWEDGE_ENULL;
    const rw_patch never = cycle->never_slips;
    if (!(never.left < never.right))
        return RWEDGE_EABSENT;
    *left = never.left;
    *right = never.right;
    return RWEDGE_OK;
}
