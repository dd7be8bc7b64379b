/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <stdio.h>

bool criterion_is_damage(int criterion)
{
    return criterion >= DAMAGE;
}

bool criterion_exists(int criterion)
{
    return criterion_is_damage(criterion) ? rwedge_damage_constants(criterion - DAMAGE) > 0
                                          : rwedge_criterion_constants(criterion) > 0;
}

const char *criterion_name(int criterion)
{
    static char names[CRITERION_COUNT][MEASURE_NAME_SIZE];
    char *name = names[criterion];
    snprintf(name, MEASURE_NAME_SIZE, "%s%s",
             rwedge_criterion_name(criterion_is_damage(criterion) ? criterion - DAMAGE : criterion),
             criterion_is_damage(criterion) ? "-damage" : "");
    for (char *c = name; *c != '\0'; c++)
        *c = *c == '_' ? '-' : *c;
    return name;
}
