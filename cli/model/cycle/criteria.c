/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "criteria.h"

#include <math.h>

#include <rwedge.h>

const criterion_kind criterion_kinds[CRITERION_COUNT] = {
    {"swt", RWEDGE_MEASURE_SWT, MEASURE_SWT, MEASURE_SWT_ANGLE, COLUMN_SWT_OUT, 0},
    {"fatemi-socie", RWEDGE_MEASURE_FATEMI_SOCIE, MEASURE_FATEMI_SOCIE, MEASURE_FS_ANGLE,
     COLUMN_FS_OUT, 0},
    {"findley", RWEDGE_MEASURE_FINDLEY, COLUMN_FINDLEY, COLUMN_FINDLEY_ANGLE, COLUMN_FINDLEY_OUT,
     0},
    {"modified-wohler", RWEDGE_MEASURE_MODIFIED_WOHLER, COLUMN_MODIFIED_WOHLER,
     COLUMN_MODIFIED_WOHLER_ANGLE, COLUMN_MODIFIED_WOHLER_OUT, 0},
    {"mcdiarmid", RWEDGE_MEASURE_MCDIARMID, COLUMN_MCDIARMID, COLUMN_MCDIARMID_ANGLE,
     COLUMN_MCDIARMID_OUT, 0},
    {"crossland", RWEDGE_MEASURE_CROSSLAND, COLUMN_CROSSLAND, 0, 0, 0},
    {"dang-van", RWEDGE_MEASURE_DANG_VAN, COLUMN_DANG_VAN, 0, 0, 0},
    {"swt-damage", -1, COLUMN_SWT_DAMAGE, COLUMN_SWT_DAMAGE_ANGLE, COLUMN_SWT_DAMAGE_OUT,
     COLUMN_SWT_CYCLES},
    {"fatemi-socie-damage", -1, COLUMN_FS_DAMAGE, COLUMN_FS_DAMAGE_ANGLE, COLUMN_FS_DAMAGE_OUT,
     COLUMN_FS_CYCLES},
};

/* ---- Columns ---- */

#define OF_Z "from its normal to the plane of x and y, 0 to 90 deg"

static const measure_kind more_kinds[COLUMN_COUNT - MEASURE_COUNT] = {
    {"swt_out_of_plane", OF_Z, "deg", true},
    {"fs_out_of_plane", OF_Z, "deg", true},
    {"findley", "Findley's largest shear amplitude + k largest normal stress", "stress", false},
    {"findley_angle", "that of its plane", "deg", true},
    {"findley_out_of_plane", OF_Z, "deg", true},
    {"modified_wohler", "shear amplitude + kappa largest normal stress/shear amplitude", "stress",
     false},
    {"modified_wohler_angle", "that of its plane", "deg", true},
    {"modified_wohler_out_of_plane", OF_Z, "deg", true},
    {"mcdiarmid", "shear amplitude/t-a + largest normal stress/(2 su)", "none", false},
    {"mcdiarmid_angle", "that of its plane", "deg", true},
    {"mcdiarmid_out_of_plane", OF_Z, "deg", true},
    {"crossland", "amplitude of sqrt(J2) + alpha largest hydrostatic stress", "stress", false},
    {"dang_van", "largest shear amplitude + alpha hydrostatic stress", "stress", false},
    {"swt_damage", "Miner's sum of a pass of the loads, of its worst plane", "none", false},
    {"swt_damage_angle", "that of its plane", "deg", true},
    {"swt_damage_out_of_plane", OF_Z, "deg", true},
    {"swt_cycles", "how many cycles that plane's normal strain has in a pass", "none", true},
    {"fs_damage", "the same by Fatemi and Socie's parameter", "none", false},
    {"fs_damage_angle", "that of its plane", "deg", true},
    {"fs_damage_out_of_plane", OF_Z, "deg", true},
    {"fs_cycles", "how many cycles that plane's shear strain has in a pass", "none", true},
    {"wear_depth", "worn in the cycle, --archard times energy_per_area", "length", false},
};

const measure_kind *column_kind_of(int column)
{
    return column < MEASURE_COUNT ? &measure_kinds[column] : &more_kinds[column - MEASURE_COUNT];
}

int column_criterion(int column)
{
    int i = CRITERION_COUNT - 1;
    while (i >= 0 && criterion_kinds[i].value != column)
        i--;
    return i;
}

bool column_is_wanted(const criteria *all, int column)
{
    bool wanted = column < MEASURE_COUNT || (column == COLUMN_WEAR && !isnan(all->archard));
    for (int i = 0; i < CRITERION_COUNT; i++) {
        const criterion_kind *kind = &criterion_kinds[i];
        const bool is_its = kind->value == column || kind->angle == column ||
                            kind->out_of_plane == column || kind->cycles == column;
        wanted = wanted || (is_its && all->is_wanted[i]);
    }
    return wanted;
}

/* ---- Constants ---- */

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
