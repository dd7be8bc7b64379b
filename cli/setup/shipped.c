/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "setup.h"

#include <stdio.h>
#include <string.h>

const shipped_material *shipped_material_named(const char *name)
{
    for (const shipped_material *one = shipped_materials; one->name != NULL; one++)
        if (strcmp(one->name, name) == 0)
            return one;
    return NULL;
}

const char *shipped_material_hint(const char *name)
{
    static char hint[160];
    nearest_name nearest = nearest_to(name);
    for (const shipped_material *one = shipped_materials; one->name != NULL; one++)
        nearest_try(&nearest, one->name);
    if (nearest.name != NULL)
        snprintf(hint, sizeof hint, "; the nearest is %s", nearest.name);
    else
        snprintf(hint, sizeof hint, "; \"rwedge materials\" lists them");
    return hint;
}
