/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a contact ends and sticks: its edges, the pressure and the shear there, and its zones. */
#include "contact/contact.h"

static int32_t give_edges(rw_patch patch, double *left, double *right)
{
    *left = patch.left;
    *right = patch.right;
    return RWEDGE_OK;
}

int32_t rwedge_contact_edges(const rwedge_contact *contact, double *left, double *right)
{
    if (!contact || !left || !right)
        return RWEDGE_ENULL;
    if (contact->phase == RW_APART)
        return RWEDGE_EABSENT;
    return give_edges(rw_memory_end(&contact->memory)->patch, left, right);
}

/* ---- Zones that stick and that slip ---- */

rw_zones rw_contact_zones(const rwedge_contact *c)
{
    rw_zones zones = {.count = 0};
    if (c->phase == RW_COMPUTED)
        return c->computed.now->now.shear.zones;
    if (c->phase == RW_APART)
        return zones;
    const rw_corner *end = rw_memory_end(&c->memory);
    const rw_patch contact = end->patch;
    rw_patch stick = contact;
    int label = 0;
    if (fabs(end->ratio) == 1) {
        label = end->ratio > 0 ? 1 : -1;
        stick = end[-1].patch;
    }
    if (c->phase == RW_SLIDING)
        stick.left = stick.right = contact.right;
    const rw_zone all[] = {{label, contact.left, stick.left},
                           {0, stick.left, stick.right},
                           {label, stick.right, contact.right}};
    for (int i = 0; i < 3; i++)
        if (all[i].right > all[i].left)
            zones.zone[zones.count++] = all[i];
    return zones;
}

size_t rwedge_contact_zone_count(const rwedge_contact *contact)
{
    return contact ? (size_t)rw_contact_zones(contact).count : 0;
}

int32_t rwedge_contact_zones(const rwedge_contact *contact, size_t n, double left[], double right[],
                             double slip[])
{
    if (!contact || !left || !right || !slip)
        return RWEDGE_ENULL;
    const rw_zones zones = rw_contact_zones(contact);
    if (n != (size_t)zones.count)
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++) {
        left[i] = zones.zone[i].left;
        right[i] = zones.zone[i].right;
        slip[i] = -zones.zone[i].label;
    }
    return RWEDGE_OK;
}

/* The patch from the first zone that sticks to the last one; without width where none does. */
static rw_patch stick_zone(const rwedge_contact *contact)
{
    const rw_zones zones = rw_contact_zones(contact);
    int first = 0, last = zones.count - 1;
    while (first <= last && zones.zone[first].label != 0)
        first++;
    while (last > first && zones.zone[last].label != 0)
        last--;
    return first <= last ? (rw_patch){zones.zone[first].left, zones.zone[last].right}
                         : (rw_patch){0, 0};
}

int32_t rwedge_contact_stick_zone(const rwedge_contact *contact, double *left, double *right)
{
    if (!contact || !left || !right)
        return RWEDGE_ENULL;
    const rw_patch sticks = stick_zone(contact);
    if (!(sticks.left < sticks.right))
        return RWEDGE_EABSENT;
    return give_edges(sticks, left, right);
}

/* ---- Sizes ---- */

double rwedge_contact_half_width(const rwedge_contact *contact)
{
    return contact ? rw_patch_half_width(rw_memory_end(&contact->memory)->patch) : NAN;
}

double rwedge_contact_stick_half_width(const rwedge_contact *contact)
{
    return contact ? rw_patch_half_width(stick_zone(contact)) : NAN;
}

/* The tilt of a pad counts less the slope with which its profile was given. */
static double tilt_of(const rwedge_contact *contact)
{
    const rw_geometry *g = &contact->geometry;
    const double tilt = g->theta * rw_memory_end(&contact->memory)->tilt;
    if (contact->phase == RW_APART)
        return contact->is_held ? g->theta * contact->held_tilt + g->middle_slope : 0;
    return g->pad ? g->middle_slope + tilt : tilt;
}

double rwedge_contact_tilt(const rwedge_contact *contact)
{
    return contact ? tilt_of(contact) : NAN;
}

/* ---- What is at an edge ---- */

/* |p| = K_N sqrt(r) and |q| = |K_T|/sqrt(r) at the distance r from an edge. */
int32_t rwedge_contact_edge_asymptotes(const rwedge_contact *contact, double *normal_left,
                                       double *normal_right, double *shear_left,
                                       double *shear_right)
{
    if (!contact || !normal_left || !normal_right || !shear_left || !shear_right)
        return RWEDGE_ENULL;
    if (contact->phase == RW_APART || contact->unlike)
        return RWEDGE_EABSENT;
    const rw_geometry *g = &contact->geometry;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const double b = rw_patch_half_width(patch);
    const rw_edge_rates rates = rw_edge_rates_of(g, patch);
    const double pressure = 2 / RW_PI * (g->theta / g->A) * sqrt(2 / b);
    const double tension = (contact->loads.sigma - contact->touched_at) * b / 4 * contact->strain;
    *normal_left = pressure * rates.at_left;
    *normal_right = pressure * rates.at_right;
    *shear_left = (contact->loads.Q / RW_PI + tension) / sqrt(2 * b);
    *shear_right = (contact->loads.Q / RW_PI - tension) / sqrt(2 * b);
    return RWEDGE_OK;
}
