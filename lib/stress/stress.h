/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses by superposition: patches of normal and of shear traction, each with its own
 * potential. */
#ifndef RW_STRESS_H
#define RW_STRESS_H

#include "potential/potential.h"

/* Mean stress s = (sxx+syy)/2 and deviator D = (syy-sxx)/2 + i txy. */
typedef struct {
    double mean, difference, shear;
} rw_stress_state;

/* normal: the field of the pressure; tangential: that of the shear traction. */
static inline rw_stress_state rw_superpose(rw_field normal, rw_field tangential)
{
    return (rw_stress_state){
        .mean = normal.G_im - tangential.G_re,
        .difference = tangential.G_re - tangential.H_im - normal.H_re,
        .shear = tangential.G_im + tangential.H_re - normal.H_im,
    };
}

static inline void rw_give_stress(rw_stress_state s, double *sxx, double *syy, double *txy)
{
    *sxx = s.mean - s.difference;
    *syy = s.mean + s.difference;
    *txy = s.shear;
}

#endif
