/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <string.h>

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

bool column_is_wanted(const criteria *asked, int column)
{
    const int criterion = measure_kinds[column].criterion;
    if (column == COLUMN_WEAR)
        return !isnan(asked->archard);
    return column < MEASURE_COUNT || criterion == NO_CRITERION || asked->is_wanted[criterion];
}

criteria criteria_usual(const contact_case *setup)
{
    criteria asked = {.nu = setup->nu1, .archard = NAN, .su = NAN};
    for (int i = 0; i < CRITERION_COUNT; i++)
        asked.constant[i] = i == CRITERION_SWT ? 0 : NAN;
    return asked;
}

double criteria_fatemi_socie(const contact_case *setup, double k)
{
    return k / (SQRT_3 * setup->k);
}

/* ---- The constants of a material ---- */

const char *const material_names[MATERIAL_COUNT] = {
    "swt_limit", "fs_limit", "findley_limit", "lambda", "crossland_limit", "dang_van_limit",
    /* curves of life, and the critical distance */
    "sf", "b", "ef", "c", "G", "tf", "b0", "gf", "c0", "dK_th", "ds0", "paris_C", "paris_m", "K_c",
    /* what an input or an option has too */
    "E", "nu", "yield_stress", "fs_k", "findley_k", "kappa", "t_A", "su", "crossland_alpha",
    "dang_van_alpha"};

material material_unknown(void)
{
    material constants;
    for (int i = 0; i < MATERIAL_COUNT; i++)
        constants.value[i] = NAN;
    return constants;
}

int material_constant(const char *name)
{
    int i = MATERIAL_COUNT - 1;
    while (i >= 0 && strcmp(name, material_names[i]) != 0)
        i--;
    return i;
}

bool material_is_remark(const char *name)
{
    return strcmp(name, "name") == 0 || strcmp(name, "source") == 0;
}

double material_allowable(const material *constants, int criterion)
{
    const int limit = criterion_kinds[criterion].limit;
    return limit == MATERIAL_COUNT ? 1 : constants->value[limit];
}
