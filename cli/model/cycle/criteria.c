/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <string.h>

criteria criteria_usual(const contact_case *setup)
{
    criteria asked = {.nu = setup->nu1, .archard = NAN, .given = material_unknown()};
    criteria_take(setup, RWEDGE_MEASURE_SWT, &asked);
    return asked;
}

/* The constant is that of the contact; otherwise as it is given; otherwise the usual one. */
static double constant_of(const contact_case *setup, const criteria *asked, int number, int j)
{
    const char *name = rwedge_constant_name(number, j);
    if (strcmp(name, "E") == 0)
        return setup->E1;
    if (strcmp(name, "yield_stress") == 0)
        return SQRT_3 * setup->k;
    const double given = material_value(&asked->given, name);
    return isnan(given) ? rwedge_constant_usual(number, j) : given;
}

const char *criteria_take(const contact_case *setup, int criterion, criteria *asked)
{
    const bool is_damage = criterion_is_damage(criterion);
    const int number = is_damage ? criterion - DAMAGE : criterion;
    const int count =
        is_damage ? rwedge_damage_constants(number) : rwedge_criterion_constants(number);
    const char *lacks = NULL;
    for (int j = 0; j < count; j++) {
        asked->constants[number][j] = constant_of(setup, asked, number, j);
        if (lacks == NULL && isnan(asked->constants[number][j]))
            lacks = rwedge_constant_name(number, j);
    }
    asked->is_computed[criterion] = lacks == NULL;
    return lacks;
}
