/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tensor.h"

#include "number/pi.h"

#include <math.h>

const char *const tensor_names[TENSOR_COUNT] = {
    [TENSOR_SXX] = "sxx",
    [TENSOR_SYY] = "syy",
    [TENSOR_TXY] = "txy",
    [TENSOR_VON_MISES] = "von_mises",
    [TENSOR_S1] = "s1",
    [TENSOR_SZZ] = "szz",
    [TENSOR_S2] = "s2",
    [TENSOR_TAU_MAX] = "tau_max",
    [TENSOR_S1_ANGLE] = "s1_angle",
};

double degrees(double angle)
{
    return angle * (180 / PI);
}

tensor tensor_of(double sxx, double syy, double txy, double nu)
{
    tensor found = tensor_unknown();
    double s1, s2, angle;
    found.value[TENSOR_SXX] = sxx;
    found.value[TENSOR_SYY] = syy;
    found.value[TENSOR_TXY] = txy;
    found.value[TENSOR_VON_MISES] = rwedge_von_mises(sxx, syy, txy, nu);
    found.value[TENSOR_SZZ] = rwedge_out_of_plane_stress(sxx, syy, nu);
    found.value[TENSOR_TAU_MAX] = rwedge_largest_shear(sxx, syy, txy, nu);
    if (rwedge_principal_stresses(sxx, syy, txy, &s1, &s2, &angle) == RWEDGE_OK) {
        found.value[TENSOR_S1] = s1;
        found.value[TENSOR_S2] = s2;
        found.value[TENSOR_S1_ANGLE] = degrees(angle);
    }
    return found;
}

tensor tensor_unknown(void)
{
    tensor found;
    for (int i = 0; i < TENSOR_COUNT; i++)
        found.value[i] = NAN;
    return found;
}
