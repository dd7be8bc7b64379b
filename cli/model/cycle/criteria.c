/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>

const criterion_kind criterion_kinds[CRITERION_COUNT] = {
    {"swt", MATERIAL_COUNT, MATERIAL_SWT_LIMIT},
    {"fatemi-socie", MATERIAL_COUNT, MATERIAL_FS_LIMIT},
    {"findley", MATERIAL_FINDLEY_K, MATERIAL_FINDLEY_LIMIT},
    {"modified-wohler", MATERIAL_KAPPA, MATERIAL_LAMBDA},
    {"mcdiarmid", MATERIAL_T_A, MATERIAL_COUNT},
    {"crossland", MATERIAL_CROSSLAND_ALPHA, MATERIAL_CROSSLAND_LIMIT},
    {"dang-van", MATERIAL_DANG_VAN_ALPHA, MATERIAL_DANG_VAN_LIMIT},
    {"swt-damage", MATERIAL_COUNT, MATERIAL_COUNT},
    {"fatemi-socie-damage", MATERIAL_COUNT, MATERIAL_COUNT},
};

bool column_is_wanted(const criteria *all, int column)
{
    const int criterion = measure_kinds[column].criterion;
    if (column == COLUMN_WEAR)
        return !isnan(all->archard);
    return column < MEASURE_COUNT || criterion == NO_CRITERION || all->is_wanted[criterion];
}

criteria criteria_usual(const contact_case *setup)
{
    criteria all = {.nu = setup->nu1, .archard = NAN, .su = NAN};
    for (int i = 0; i < CRITERION_COUNT; i++)
        all.constant[i] = i == CRITERION_SWT ? 0 : NAN;
    return all;
}

double criteria_fatemi_socie(const contact_case *setup, double k)
{
    return k / (1.7320508075688772 * setup->k);
}
