/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <stdlib.h>

stick_zones stick_zones_of(const rwedge_contact *contact)
{
    const size_t n = rwedge_contact_zone_count(contact);
    double *left = memory_zeroed(n + 1, sizeof *left), *right = memory_zeroed(n + 1, sizeof *right),
           *slip = memory_zeroed(n + 1, sizeof *slip);
    stick_zones zones = {0, left, right};
    rwedge_contact_zones(contact, n, left, right, slip);
    for (size_t i = 0; i < n; i++)
        if (slip[i] == 0) {
            left[zones.count] = left[i];
            right[zones.count++] = right[i];
        }
    free(slip);
    return zones;
}

bool stick_zones_have(const stick_zones *zones, double x)
{
    for (size_t i = 0; i < zones->count; i++)
        if (x > zones->left[i] && x < zones->right[i])
            return true;
    return false;
}

void stick_zones_free(stick_zones *zones)
{
    free(zones->left);
    free(zones->right);
}
