/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

static const char of_z[] = "from its normal to the plane of x and y, 0 to 90 deg";
static const char of_plane[] = "that of its plane";

enum { NONE = -1 };

const measure_kind measure_kinds[COLUMN_COUNT] = {
    {"stress_range", "largest less smallest sxx", "stress", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_STRESS_RANGE, "Range of *σ*_x"},
    {"swt", "Smith, Watson and Topper's parameter, strain amplitude", "stress", CRITERION_SWT,
     PART_VALUE, RWEDGE_MEASURE_SWT, "Smith–Watson–Topper parameter"},
    {"swt_angle", "from the surface's normal to that of the plane, deg", "deg", CRITERION_SWT,
     PART_ANGLE, NONE, NULL},
    {"fatemi_socie", "Fatemi and Socie's, amplitude too; needs a yield stress", "none",
     CRITERION_FATEMI_SOCIE, PART_VALUE, RWEDGE_MEASURE_FATEMI_SOCIE, "Fatemi–Socie parameter"},
    {"fs_angle", of_plane, "deg", CRITERION_FATEMI_SOCIE, PART_ANGLE, NONE, NULL},
    {"slip_range", "largest less smallest slip", "length", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_SLIP_RANGE, "Range of slip"},
    {"ruiz_f1", "largest |q| * slip range", "force/length", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_RUIZ_F1, "Ruiz parameter *F*_1"},
    {"ruiz_f2", "F1 * largest sxx; 0 in compression", "force*stress/length", NO_CRITERION,
     PART_VALUE, RWEDGE_MEASURE_RUIZ_F2, "Ruiz parameter *F*_2"},
    {"energy_per_area", "dissipated by friction, integral of q d(slip)", "force/length",
     NO_CRITERION, PART_VALUE, RWEDGE_MEASURE_ENERGY_PER_AREA, "Energy dissipated per area"},
    {"swt_out_of_plane", of_z, "deg", CRITERION_SWT, PART_OUT_OF_PLANE, NONE, NULL},
    {"fs_out_of_plane", of_z, "deg", CRITERION_FATEMI_SOCIE, PART_OUT_OF_PLANE, NONE, NULL},
    {"findley", "Findley's largest shear amplitude + k largest normal stress", "stress",
     CRITERION_FINDLEY, PART_VALUE, RWEDGE_MEASURE_FINDLEY, "Findley parameter"},
    {"findley_angle", of_plane, "deg", CRITERION_FINDLEY, PART_ANGLE, NONE, NULL},
    {"findley_out_of_plane", of_z, "deg", CRITERION_FINDLEY, PART_OUT_OF_PLANE, NONE, NULL},
    {"modified_wohler", "shear amplitude + kappa largest normal stress/shear amplitude", "stress",
     CRITERION_MODIFIED_WOHLER, PART_VALUE, RWEDGE_MEASURE_MODIFIED_WOHLER,
     "Modified Wöhler parameter"},
    {"modified_wohler_angle", of_plane, "deg", CRITERION_MODIFIED_WOHLER, PART_ANGLE, NONE, NULL},
    {"modified_wohler_out_of_plane", of_z, "deg", CRITERION_MODIFIED_WOHLER, PART_OUT_OF_PLANE,
     NONE, NULL},
    {"mcdiarmid", "shear amplitude/t-a + largest normal stress/(2 su)", "none", CRITERION_MCDIARMID,
     PART_VALUE, RWEDGE_MEASURE_MCDIARMID, "McDiarmid parameter"},
    {"mcdiarmid_angle", of_plane, "deg", CRITERION_MCDIARMID, PART_ANGLE, NONE, NULL},
    {"mcdiarmid_out_of_plane", of_z, "deg", CRITERION_MCDIARMID, PART_OUT_OF_PLANE, NONE, NULL},
    {"crossland", "amplitude of sqrt(J2) + alpha largest hydrostatic stress", "stress",
     CRITERION_CROSSLAND, PART_VALUE, RWEDGE_MEASURE_CROSSLAND, "Crossland parameter"},
    {"dang_van", "largest shear amplitude + alpha hydrostatic stress", "stress", CRITERION_DANG_VAN,
     PART_VALUE, RWEDGE_MEASURE_DANG_VAN, "Dang Van parameter"},
    {"swt_damage", "Miner's sum of a pass of the loads, of its worst plane", "none",
     CRITERION_SWT_DAMAGE, PART_VALUE, NONE, "Damage by Smith–Watson–Topper"},
    {"swt_damage_angle", of_plane, "deg", CRITERION_SWT_DAMAGE, PART_ANGLE, NONE, NULL},
    {"swt_damage_out_of_plane", of_z, "deg", CRITERION_SWT_DAMAGE, PART_OUT_OF_PLANE, NONE, NULL},
    {"swt_cycles", "how many cycles that plane's normal strain has in a pass", "none",
     CRITERION_SWT_DAMAGE, PART_CYCLES, NONE, NULL},
    {"fs_damage", "the same by Fatemi and Socie's parameter", "none", CRITERION_FS_DAMAGE,
     PART_VALUE, NONE, "Damage by Fatemi–Socie"},
    {"fs_damage_angle", of_plane, "deg", CRITERION_FS_DAMAGE, PART_ANGLE, NONE, NULL},
    {"fs_damage_out_of_plane", of_z, "deg", CRITERION_FS_DAMAGE, PART_OUT_OF_PLANE, NONE, NULL},
    {"fs_cycles", "how many cycles that plane's shear strain has in a pass", "none",
     CRITERION_FS_DAMAGE, PART_CYCLES, NONE, NULL},
    {"wear_depth", "worn in the cycle, --archard times energy_per_area", "length", NO_CRITERION,
     PART_VALUE, NONE, "Depth of wear"},
};

int measure_column(int criterion, measure_part part)
{
    int i = COLUMN_COUNT - 1;
    while (i >= 0 && (measure_kinds[i].criterion != criterion || measure_kinds[i].part != part))
        i--;
    return i;
}

int measure_criterion(int column)
{
    const measure_kind *kind = &measure_kinds[column];
    return kind->part == PART_VALUE ? kind->criterion : NO_CRITERION;
}

int measure_damage(int criterion)
{
    return criterion == CRITERION_SWT            ? CRITERION_SWT_DAMAGE
           : criterion == CRITERION_FATEMI_SOCIE ? CRITERION_FS_DAMAGE
                                                 : criterion;
}
