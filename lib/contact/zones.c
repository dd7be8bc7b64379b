/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The zones of a contact that stick and that slip. */
#include "contact/numerical.h"

void rw_closed_form_zones(const rwedge_contact *c, rw_zones *z)
{
    const rw_corner *end = rw_memory_end(&c->memory);
    const rw_patch contact = end->patch;
    rw_patch stick = contact;
    int label = 0;
    if (fabs(end->ratio) == 1) {
        label = end->ratio > 0 ? 1 : -1;
        stick = end[-1].patch;
    }
    if (end[-1].load == 0 && label != 0) /* it slides */
        stick.left = stick.right = contact.right;
    const rw_zone all[] = {{label, contact.left, stick.left},
                           {0, stick.left, stick.right},
                           {label, stick.right, contact.right}};
    z->count = 0;
    for (int i = 0; i < 3; i++)
        if (all[i].right > all[i].left)
            z->zone[z->count++] = all[i];
}

static void zones_of(const rwedge_contact *contact, rw_zones *zones)
{
    zones->count = 0;
    if (contact->numerical)
        *zones = contact->numerical->now.shear.zones;
    else if (contact->memory.count > 1)
        rw_closed_form_zones(contact, zones);
}

size_t rwedge_contact_zone_count(const rwedge_contact *contact)
{
    rw_zones zones = {0};
    if (contact)
        zones_of(contact, &zones);
    return (size_t)zones.count;
}

int32_t rwedge_contact_zones(const rwedge_contact *contact, size_t n, double left[], double right[],
                             double slip[])
{
    if (!contact || !left || !right || !slip)
        return RWEDGE_ENULL;
    rw_zones zones;
    zones_of(contact, &zones);
    if (n != (size_t)zones.count)
        return RWEDGE_ERANGE;
    for (size_t i = 0; i < n; i++) {
        left[i] = zones.zone[i].left;
        right[i] = zones.zone[i].right;
        slip[i] = -zones.zone[i].label;
    }
    return RWEDGE_OK;
}
