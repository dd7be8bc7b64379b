/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The state after a step whose zones are known, and how well it meets the conditions of the
 * problem: Coulomb's where it sticks, the sense of slip where it slips. */
#ifndef RW_OUTCOME_H
#define RW_OUTCOME_H

#include "fronts/fronts.h"
#include "fronts/grid.h"

typedef struct {
    rw_shear_state state;
    double violation; /* the largest: excess of |t| over the scale, f times the peak pressure; or
                         slip the wrong way over the scale times the half-width */
    double drift;     /* the violation that is displacement of what sticks: of the grid all of it */
    double energy;    /* in theta^2/A */
    double doubt;     /* by how much friction that changes may make the energy wrong */
    double move;      /* of what sticks: the constant part of dw */
    rw_layers layers;
    double D[2];    /* at the left, right edge after the step, NaN where it is not known */
    bool is_short;  /* memory was short */
    rw_zones wrong; /* parts that should have another label */
} rw_outcome;

/* Removes kinks, except fronts, without which the traction is fitted to the tolerance too: each
 * step leaves kinks where an edge of the contact was. */
void rw_shear_state_smooth(rw_shear_state *state, rw_patch contact, double tolerance);

/* The outcome of exact fronts, and that of the grid. false where memory is short, or a number is
 * not finite. */
bool rw_outcome_of_fronts(rw_fronts *fronts, rw_outcome *outcome);
bool rw_outcome_of_grid(const rw_fronts *fronts, const rw_grid *grid, const rw_problem *problem,
                        const rw_layers *layers, rw_outcome *outcome);

/* Slip and energy alone, of fronts that are known to be right. */
void rw_outcome_of_slip(rw_fronts *fronts, rw_outcome *outcome);

#endif
