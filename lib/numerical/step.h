/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One implicit step of the shear: the grid's zones, then exact fronts. */
#ifndef RW_STEP_H
#define RW_STEP_H

#include "numerical/outcome.h"

/* Where a step leads: P A/theta, M A/theta and Q A/theta, lengths and a square of one; the
 * stretch. */
typedef struct {
    double P, M, shear, stretch;
} rw_course;

/* Where tractions are compared. */
enum { RW_PLACES = 121 };

double rw_place(rw_patch contact, int i);

/* How it stands with the shear of a contact. */
typedef struct {
    rw_shear_state shear;
    rw_patch contact;
    rw_course at;
    bool is_still;           /* the contact is as it was at the beginning */
    rw_patch unslipped;      /* what has not slipped since; of several parts the widest */
    double move, energy;     /* summed */
    double error;            /* of the step that led here: violations, over the scale */
    double haste;            /* what the rates at its ends say */
    double apart[RW_PLACES]; /* of the step in halves: how far it is from the whole */
} rw_stance;

enum { RW_TRIALS = 2, RW_MOST_EFFORT = 16000, RW_FRICTIONS = 4 };

/* What steps work with, kept from one to the next. */
typedef struct {
    const rw_frame *frame;
    rw_fronts fronts;
    rw_problem start; /* the rates at the beginning of the step */
    rw_grid grid[RW_TRIALS];
    rw_friction friction[RW_FRICTIONS]; /* of the contacts at last */
    unsigned frictions;                 /* so far */
    int effort;    /* residuals so far; from RW_MOST_EFFORT on there is but the grid. From half of
                      it on steps are divided no more, so that exact fronts may end them. */
    int limit;     /* up to which the zones of this step are searched */
    bool is_short; /* memory was */
} rw_work;

bool rw_work_create(rw_work *work, const rw_frame *frame);
void rw_work_destroy(rw_work *work);

/* false where no zones keep the conditions to the tolerance. `coarse` takes those that keep them
 * best, or the grid's answer: then false means that there is none. guess, or NULL: zones of a step
 * to a place near by, which are tried first. */
bool rw_implicit_step(rw_work *work, const rw_stance *from, rw_course to, const rw_zones *guess,
                      bool coarse, rw_stance *there);

/* Whether a contact that is still went on from one stance to the other, of which both were reached
 * from the same, as a step from the first to the second would: then the energy is that of both. */
bool rw_step_goes_on(rw_work *work, const rw_stance *from, rw_stance *there);

#endif
