/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where pressure and slip are largest. */
#include "base/maximum.h"
#include "base/sort.h"
#include "contact/contact.h"

static int32_t give(rw_maximum peak, double *value, double *x)
{
    *value = peak.value;
    *x = peak.x;
    return RWEDGE_OK;
}

/* ---- Pressure ---- */

static double pressure_at(double x, const void *of)
{
    const rwedge_contact *contact = of;
    return -rw_unit_stress(&contact->geometry) * rw_contact_pressure(contact, x);
}

/* The pressure is infinite at a kink. */
static bool touches_kink(const rw_arcs *arcs, rw_patch patch)
{
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        if (arc.left == arc.right && arc.left >= patch.left && arc.left <= patch.right)
            return true;
    }
    return false;
}

/* Whether it is the pressure of rwedge_peak_pressure(): of a wedge or cylinder that is in the
 * middle, or touches with its rounding alone. */
static bool is_of_formula(const rw_geometry *g, rw_patch patch)
{
    return !g->pad && (rw_patch_middle(patch) == 0 || (patch.left >= -g->a && patch.right <= g->a));
}

static rw_maximum by_formula(const rw_geometry *g, rw_patch patch)
{
    const double alpha = g->a / rw_patch_half_width(patch);
    return (rw_maximum){rw_patch_middle(patch), rw_unit_stress(g) * rwedge_peak_pressure(alpha)};
}

/* There may be a top in each arc. Its ends and its middle are places to look at, as far as it is in
 * contact. */
static size_t add_arcs(const rw_arcs *arcs, rw_patch patch, double place[], size_t n)
{
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        const double left = fmax(arc.left, patch.left), right = fmin(arc.right, patch.right);
        if (!(left < right))
            continue;
        if (n == RW_SPREAD || place[n - 1] != left)
            place[n++] = left;
        place[n++] = left + (right - left) / 2;
        place[n++] = right;
    }
    return n;
}

static int32_t by_search(const rwedge_contact *contact, rw_patch patch, rw_maximum *peak)
{
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const size_t most = RW_SPREAD + 3 * arcs.count;
    double *place = malloc(2 * most * sizeof *place);
    if (!place)
        return RWEDGE_ENOMEM;
    rw_spread_places(patch.left, patch.right, place);
    const size_t n = add_arcs(&arcs, patch, place, RW_SPREAD);
    rw_sort(place, n);
    *peak = rw_largest_value(pressure_at, contact, n, place, place + most);
    free(place);
    return RWEDGE_OK;
}

int32_t rwedge_contact_peak_pressure(const rwedge_contact *contact, double *pressure, double *x)
{
    if (!contact || !pressure || !x)
        return RWEDGE_ENULL;
    const rw_geometry *g = &contact->geometry;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const rw_arcs arcs = rw_arcs_of(g);
    if (contact->phase == RW_APART || touches_kink(&arcs, patch))
        return RWEDGE_EABSENT;
    if (!contact->unlike && is_of_formula(g, patch))
        return give(by_formula(g, patch), pressure, x);
    rw_maximum peak;
    const int32_t status = by_search(contact, patch, &peak);
    return status == RWEDGE_OK ? give(peak, pressure, x) : status;
}

/* ---- Slip ---- */

static double slip_size_at(double x, const void *contact)
{
    double slip;
    return rwedge_contact_slip(contact, 1, &x, &slip) == RWEDGE_OK ? fabs(slip) : NAN;
}

int32_t rwedge_contact_largest_slip(const rwedge_contact *contact, double *slip, double *x)
{
    if (!contact || !slip || !x)
        return RWEDGE_ENULL;
    if (contact->phase == RW_APART)
        return RWEDGE_EABSENT;
    if (!rw_contact_knows_slip(contact))
        return RWEDGE_EPATH;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    double place[RW_SPREAD], value[RW_SPREAD];
    rw_spread_places(patch.left, patch.right, place);
    return give(rw_largest_value(slip_size_at, contact, RW_SPREAD, place, value), slip, x);
}
