/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "potential/pad_potential.h"

void rw_pad_pressures(const rw_arcs *arcs, rw_patch patch, size_t n, const double x[], double p[])
{
    for (size_t k = 0; k < n; k++)
        p[k] = 0;
    for (size_t i = 0; i < arcs->count; i++) {
        rw_eccentric potential;
        if (!rw_arc_is_inside(rw_arc_at(arcs, i), patch))
            continue;
        rw_eccentric_init_arc(&potential, rw_arc_at(arcs, i), patch);
        for (size_t k = 0; k < n; k++)
            if (x[k] > patch.left && x[k] < patch.right)
                p[k] -= rw_arc_weight(arcs, i) * rw_eccentric_at(&potential, x[k], 0).G_im;
    }
}
