/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "measures.h"

const measure_kind measure_kinds[MEASURE_COUNT] = {
    [MEASURE_STRESS_RANGE] = {"stress_range", "largest less smallest sxx", "stress", false},
    [MEASURE_SWT] = {"swt", "Smith, Watson and Topper's parameter, strain amplitude", "stress",
                     false},
    [MEASURE_SWT_ANGLE] = {"swt_angle", "from the surface's normal to that of the plane, deg",
                           "deg", true},
    [MEASURE_FATEMI_SOCIE] = {"fatemi_socie",
                              "Fatemi and Socie's, amplitude too; needs a yield stress", "none",
                              false},
    [MEASURE_FS_ANGLE] = {"fs_angle", "that of its plane", "deg", true},
    [MEASURE_SLIP_RANGE] = {"slip_range", "largest less smallest slip", "length", false},
    [MEASURE_RUIZ_F1] = {"ruiz_f1", "largest |q| * slip range", "force/length", false},
    [MEASURE_RUIZ_F2] = {"ruiz_f2", "F1 * largest sxx; 0 in compression", "force*stress/length",
                         false},
    [MEASURE_ENERGY_PER_AREA] = {"energy_per_area", "dissipated by friction, integral of q d(slip)",
                                 "force/length", false},
};
