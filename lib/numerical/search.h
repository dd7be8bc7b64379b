/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the zones of a step: those of a similar step, or the grid's, then exact fronts. */
#ifndef RW_SEARCH_H
#define RW_SEARCH_H

#include "numerical/outcome.h"
#include "numerical/pattern.h"

enum { RW_TRIALS = 2, RW_FRICTIONS = 8 };

/* Working memory of steps, kept from one to the next: as much as these steps need. */
typedef struct {
    const rw_frame *frame;
    rw_fronts fronts;
    rw_problem start, end;              /* the rates at the beginning and at the end of the step */
    rw_grid grid[RW_TRIALS];            /* n = 0: not used yet */
    rw_friction friction[RW_FRICTIONS]; /* of the last contacts */
    unsigned frictions;                 /* how many so far */
    /* so far: values at points of a quadrature. Beyond the most only the grid is
     * used. Beyond half of it steps are not divided any more, so that exact fronts may end them. */
    int effort, most_effort;
    int search;    /* residuals that the zones of this step may still cost */
    bool is_short; /* memory was short */
} rw_work;

/* Notes effort; no more than RW_ALL_EFFORT in all, so that a sum of two is an int. */
enum { RW_ALL_EFFORT = 1 << 30 };

static inline void rw_spend(rw_work *work, double effort)
{
    work->effort = (int)fmin(work->effort + effort, RW_ALL_EFFORT);
}

void rw_work_init(rw_work *work, const rw_frame *frame, int most_effort);
void rw_work_destroy(rw_work *work);

/* The best outcome by exact fronts; or by the grid, where `coarse` allows it. `guess` is tried
 * first, unless it is NULL. The rates of the step are set. false where there is none to the
 * tolerance. */
bool rw_search(rw_work *work, const rw_problem *problem, const rw_zones *guess, bool coarse,
               rw_outcome *best);

/* The zones alone, without their traction: where it can be, by exact fronts of zones like those of
 * `guess`, else, with `by_grid`, of any, also where those of `guess` slip the wrong way. false
 * where they are not found. */
bool rw_search_zones(rw_work *work, const rw_problem *problem, const rw_zones *guess, bool by_grid,
                     rw_zones *zones);

#endif
