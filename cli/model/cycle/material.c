/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <string.h>

const char *const material_names[MATERIAL_COUNT] = {"swt_limit",
                                                    "fs_limit",
                                                    "findley_limit",
                                                    "lambda",
                                                    "crossland_limit",
                                                    "dang_van_limit",
                                                    "sf",
                                                    "b",
                                                    "ef",
                                                    "c",
                                                    "G",
                                                    "tf",
                                                    "b0",
                                                    "gf",
                                                    "c0",
                                                    "dK_th",
                                                    "ds0",
                                                    "E",
                                                    "nu",
                                                    "yield_stress",
                                                    "fs_k",
                                                    "findley_k",
                                                    "kappa",
                                                    "t_A",
                                                    "su",
                                                    "crossland_alpha",
                                                    "dang_van_alpha"};

material material_unknown(void)
{
    material all;
    for (int i = 0; i < MATERIAL_COUNT; i++)
        all.value[i] = NAN;
    return all;
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

double material_allowable(const material *all, int criterion)
{
    const int limit = criterion_kinds[criterion].limit;
    return limit == MATERIAL_COUNT ? 1 : all->value[limit];
}

bool material_has_life(const material *all, int criterion)
{
    return !isnan(all->value[criterion == CRITERION_SWT ? MATERIAL_SF : MATERIAL_G]);
}

double material_length(const material *all)
{
    return rwedge_critical_distance(all->value[MATERIAL_DK_TH], all->value[MATERIAL_DS0]);
}
