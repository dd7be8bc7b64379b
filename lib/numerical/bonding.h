/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shear that unlike bodies take up where nothing slips while a patch moves. Each part of the
 * way changes the pressure by that of a flat punch, n = (a + b (x - m))/|X|. The shear
 *     tau = -(B/(pi |X|)) int (a + b (s - m))/(s - x) ds
 * has the transform B n, no load and no strain. */
#ifndef RW_BONDING_H
#define RW_BONDING_H

#include "formulas/arcs.h"
#include "traction/traction.h"

typedef struct {
    const rw_arcs *arcs;
    rw_patch from, to;
    double B;
    double node[RW_TERMS], weight[RW_TERMS];
} rw_bonding;

rw_bonding rw_bonding_of(const rw_arcs *arcs, rw_patch from, rw_patch to, double B);

/* The sum of tau over the way, on which both edges move evenly, as long as the patch has x. */
double rw_bonding_at(const rw_bonding *bonding, double x);

#endif
