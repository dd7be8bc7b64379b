/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

static const char of_z[] = "from its normal to the plane of x and y, 0 to 90 deg";
static const char of_plane[] = "that of its plane";

enum { NONE = -1 };

const measure_kind measure_kinds[COLUMN_COUNT] = {
    {"stress_range", "largest less smallest sxx", "stress", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_STRESS_RANGE},
    {"swt", "Smith, Watson and Topper's parameter, strain amplitude", "stress", CRITERION_SWT,
     PART_VALUE, RWEDGE_MEASURE_SWT},
    {"swt_angle", "from the surface's normal to that of the plane, deg", "deg", CRITERION_SWT,
     PART_ANGLE, NONE},
    {"fatemi_socie", "Fatemi and Socie's, amplitude too; needs a yield stress", "none",
     CRITERION_FATEMI_SOCIE, PART_VALUE, RWEDGE_MEASURE_FATEMI_SOCIE},
    {"fs_angle", of_plane, "deg", CRITERION_FATEMI_SOCIE, PART_ANGLE, NONE},
    {"slip_range", "largest less smallest slip", "length", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_SLIP_RANGE},
    {"ruiz_f1", "largest |q| * slip range", "force/length", NO_CRITERION, PART_VALUE,
     RWEDGE_MEASURE_RUIZ_F1},
    {"ruiz_f2", "F1 * largest sxx; 0 in compression", "force*stress/length", NO_CRITERION,
     PART_VALUE, RWEDGE_MEASURE_RUIZ_F2},
    {"energy_per_area", "dissipated by friction, integral of q d(slip)", "force/length",
     NO_CRITERION, PART_VALUE, RWEDGE_MEASURE_ENERGY_PER_AREA},
    {"swt_out_of_plane", of_z, "deg", CRITERION_SWT, PART_OUT_OF_PLANE, NONE},
    {"fs_out_of_plane", of_z, "deg", CRITERION_FATEMI_SOCIE, PART_OUT_OF_PLANE, NONE},
    {"findley", "Findley's largest shear amplitude + k largest normal stress", "stress",
     CRITERION_FINDLEY, PART_VALUE, RWEDGE_MEASURE_FINDLEY},
    {"findley_angle", of_plane, "deg", CRITERION_FINDLEY, PART_ANGLE, NONE},
    {"findley_out_of_plane", of_z, "deg", CRITERION_FINDLEY, PART_OUT_OF_PLANE, NONE},
    {"modified_wohler", "shear amplitude + kappa largest normal stress/shear amplitude", "stress",
     CRITERION_MODIFIED_WOHLER, PART_VALUE, RWEDGE_MEASURE_MODIFIED_WOHLER},
    {"modified_wohler_angle", of_plane, "deg", CRITERION_MODIFIED_WOHLER, PART_ANGLE, NONE},
    {"modified_wohler_out_of_plane", of_z, "deg", CRITERION_MODIFIED_WOHLER, PART_OUT_OF_PLANE,
     NONE},
    {"mcdiarmid", "shear amplitude/t-a + largest normal stress/(2 su)", "none", CRITERION_MCDIARMID,
     PART_VALUE, RWEDGE_MEASURE_MCDIARMID},
    {"mcdiarmid_angle", of_plane, "deg", CRITERION_MCDIARMID, PART_ANGLE, NONE},
    {"mcdiarmid_out_of_plane", of_z, "deg", CRITERION_MCDIARMID, PART_OUT_OF_PLANE, NONE},
    {"crossland", "amplitude of sqrt(J2) + alpha largest hydrostatic stress", "stress",
     CRITERION_CROSSLAND, PART_VALUE, RWEDGE_MEASURE_CROSSLAND},
    {"dang_van", "largest shear amplitude + alpha hydrostatic stress", "stress", CRITERION_DANG_VAN,
     PART_VALUE, RWEDGE_MEASURE_DANG_VAN},
    {"swt_damage", "Miner's sum of a pass of the loads, of its worst plane", "none",
     CRITERION_SWT_DAMAGE, PART_VALUE, NONE},
    {"swt_damage_angle", of_plane, "deg", CRITERION_SWT_DAMAGE, PART_ANGLE, NONE},
    {"swt_damage_out_of_plane", of_z, "deg", CRITERION_SWT_DAMAGE, PART_OUT_OF_PLANE, NONE},
    {"swt_cycles", "how many cycles that plane's normal strain has in a pass", "none",
     CRITERION_SWT_DAMAGE, PART_CYCLES, NONE},
    {"fs_damage", "the same by Fatemi and Socie's parameter", "none", CRITERION_FS_DAMAGE,
     PART_VALUE, NONE},
    {"fs_damage_angle", of_plane, "deg", CRITERION_FS_DAMAGE, PART_ANGLE, NONE},
    {"fs_damage_out_of_plane", of_z, "deg", CRITERION_FS_DAMAGE, PART_OUT_OF_PLANE, NONE},
    {"fs_cycles", "how many cycles that plane's shear strain has in a pass", "none",
     CRITERION_FS_DAMAGE, PART_CYCLES, NONE},
    {"wear_depth", "worn in the cycle, --archard times energy_per_area", "length", NO_CRITERION,
     PART_VALUE, NONE},
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
