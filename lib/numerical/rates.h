/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rate of the shear at one moment of a straight step, given which zones stick and slip. Where
 * it sticks the rate of w is one constant. Where it slips the rate of t is S f dp/ds, in closed
 * form (problem.c), and the rate of w has the sign -S if the zones are right. A step may meet all
 * conditions at its end and still have slipped another way before, and so may its halves: the rates
 * at both ends show it. */
#ifndef RW_RATES_H
#define RW_RATES_H

#include "fronts/fronts.h"

/* How wrong the zones are, if the rates last for the whole step: the largest slip the wrong way
 * over the half-width, or the traction beyond friction at edges that stick after the step. 0 where
 * nothing sticks. */
double rw_rates_wrong(rw_fronts *fronts, const rw_problem *rates, const rw_zones *zones,
                      const rw_zones *after);

/* D at the edges that grow and stick (layers.h), else NaN: as the zones have it, and not beyond
 * +-1. */
void rw_rates_free_ratio(rw_fronts *fronts, const rw_problem *rates, const rw_zones *zones,
                         double ratio[2]);
void rw_rates_ratio(rw_fronts *fronts, const rw_problem *rates, const rw_zones *zones,
                    double ratio[2]);

/* Zones at the beginning of a step: what slips the same way before and after it. Where a zone that
 * slipped has begun to stick at once, the front is where the rate of t is bounded. */
rw_zones rw_rates_begun(rw_fronts *fronts, const rw_problem *rates, const rw_zones *old,
                        const rw_zones *after);

/* The error at the beginning of a step: of zones that go on slipping, zones that begin to slip at
 * the edges, and zones that stop. */
double rw_rates_error_at_start(rw_fronts *fronts, const rw_problem *rates, const rw_zones *old,
                               const rw_zones *after);

/* The largest traction beyond friction, on average over a part that is wider than `least`: of what
 * slips before a step and sticks after it, if it sticks from the beginning. */
double rw_rates_excess_at_start(rw_fronts *fronts, const rw_problem *rates, const rw_zones *old,
                                const rw_zones *after, double least);

/* Slip that lingers: the largest traction beyond friction within the step, of what slips before it
 * and sticks after it, if it sticks from the beginning. 0 where it is not known. `contact_after`,
 * `traction_after`: those at the end of the step. */
double rw_rates_lingering_excess(rw_fronts *fronts, const rw_problem *rates, const rw_zones *old,
                                 const rw_zones *after, double least, rw_patch contact_after,
                                 const rw_traction *traction_after);

/* The power of friction in zones that slip, in energy per step. NaN where it is not known. */
double rw_rates_power(rw_fronts *fronts, const rw_problem *rates, const rw_zones *zones);

#endif
