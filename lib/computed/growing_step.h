/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of a contact that grows: until the next cell comes into contact. */
#ifndef RW_GROWING_STEP_H
#define RW_GROWING_STEP_H

#include "computed/growing_cells.h"
#include "numerical/step.h"

typedef struct {
    rw_growth *g;
    const rw_frame *frame;
    rw_scaled_loads rates; /* per load */
    double P, load;        /* all; so far */
    double *gap;           /* between the bodies at each cell, now */
    double *influence;     /* of the traction of a cell on the displacement of another */
    double *dN, *dt;       /* the changes of a step; and of dt what does not depend on the load: */
    double *jump;
    size_t *stuck; /* the cells that stick */
    size_t sticks;
    double d_approach, d_tilt, d_move, d_load;
    double *A, *b;
} rw_growing;

/* What a step needs, for the cells, the frame, the rates and the load, which are set. false where
 * memory is short; it is to be destroyed then too. */
bool rw_growing_create(rw_growing *growing);
void rw_growing_destroy(rw_growing *growing);

/* To the next cell, or to the end. A cell is beside the contact on either side. false where no
 * labels are right. */
bool rw_growing_step(rw_growing *growing);

/* Whether that is all of the load, to rounding. */
bool rw_growing_is_done(const rw_growing *growing, double load);

#endif
