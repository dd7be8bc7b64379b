/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "potential/pad_potential.h"

#include <stdlib.h>

bool rw_pad_potential_create(rw_pad_potential *p, const rw_arcs *arcs, rw_patch patch)
{
    *p = (rw_pad_potential){.patch = patch};
    if (arcs->pad && !(p->many = malloc(arcs->count * sizeof *p->many)))
        return false;
    rw_arc_potential *all = p->many ? p->many : &p->single;
    for (size_t i = 0; i < arcs->count; i++) {
        const rw_arc arc = rw_arc_at(arcs, i);
        if (!rw_arc_is_inside(arc, patch))
            continue;
        all[p->count].weight = rw_arc_weight(arcs, i);
        rw_eccentric_init_arc(&all[p->count++].potential, arc, patch);
    }
    return true;
}

void rw_pad_potential_destroy(rw_pad_potential *p)
{
    free(p->many);
    p->many = NULL;
}

double rw_pad_pressure(const rw_pad_potential *p, double x)
{
    const rw_arc_potential *all = p->many ? p->many : &p->single;
    double sum = 0;
    if (x > p->patch.left && x < p->patch.right)
        for (size_t i = 0; i < p->count; i++)
            sum -= all[i].weight * rw_eccentric_at(&all[i].potential, x, 0).G_im;
    return sum;
}

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
