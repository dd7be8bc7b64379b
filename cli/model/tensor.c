/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <math.h>

const column_kind tensor_kinds[TENSOR_COUNT] = {
    [TENSOR_SXX] = {"sxx", NULL, NULL},
    [TENSOR_SYY] = {"syy", NULL, NULL},
    [TENSOR_TXY] = {"txy", NULL, NULL},
    [TENSOR_VON_MISES] = {"von_mises", "equivalent stress, plane strain: szz = nu1 (sxx + syy)"},
    [TENSOR_S1] = {"s1", "larger principal stress in the plane"},
    [TENSOR_SZZ] = {"szz", "stress across the plane"},
    [TENSOR_S2] = {"s2", "smaller principal stress in the plane"},
    [TENSOR_TAU_MAX] = {"tau_max", "largest shear stress on any plane"},
    [TENSOR_S1_ANGLE] = {"s1_angle",
                         "from the normal of the surface to that of the plane of s1, deg"},
};

double degrees(double angle)
{
    return angle * (180 / PI);
}

tensor tensor_of(double sxx, double syy, double txy, double nu)
{
    tensor at_point = tensor_unknown();
    double s1, s2, angle;
    at_point.value[TENSOR_SXX] = sxx;
    at_point.value[TENSOR_SYY] = syy;
    at_point.value[TENSOR_TXY] = txy;
    at_point.value[TENSOR_VON_MISES] = rwedge_von_mises(sxx, syy, txy, nu);
    at_point.value[TENSOR_SZZ] = rwedge_out_of_plane_stress(sxx, syy, nu);
    at_point.value[TENSOR_TAU_MAX] = rwedge_largest_shear(sxx, syy, txy, nu);
    if (rwedge_principal_stresses(sxx, syy, txy, &s1, &s2, &angle) == RWEDGE_OK) {
        at_point.value[TENSOR_S1] = s1;
        at_point.value[TENSOR_S2] = s2;
        at_point.value[TENSOR_S1_ANGLE] = degrees(angle);
    }
    return at_point;
}

int32_t edge_tensions(const rwedge_contact *contact, double edge[2], double sxx[2])
{
    const double surface[2] = {0, 0};
    double syy[2], txy[2];
    const int32_t status = rwedge_contact_edges(contact, &edge[0], &edge[1]);
    return status == RWEDGE_OK ? rwedge_contact_stresses(contact, 2, edge, surface, sxx, syy, txy)
                               : status;
}

void yield_place_settle(double *x, double *y)
{
    const double rounding = 1e-9;
    if (fabs(*y) <= rounding * fabs(*x))
        *y = 0;
    else if (fabs(*x) <= rounding * *y)
        *x = 0;
}

tensor tensor_unknown(void)
{
    tensor at_point;
    for (int i = 0; i < TENSOR_COUNT; i++)
        at_point.value[i] = NAN;
    return at_point;
}
