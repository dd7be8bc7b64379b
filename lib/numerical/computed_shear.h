/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shear of a contact whose history has no closed form: its traction on elements, the slip so
 * far and an estimate of the error. Its memory grows with the complexity of the traction, not with
 * the length of the history. */
#ifndef RW_COMPUTED_SHEAR_H
#define RW_COMPUTED_SHEAR_H

#include "numerical/step.h"
#include "rwedge.h"

typedef struct {
    rw_numerical_state now;
    bool has_origin;         /* whether the slip is known */
    rw_traction origin;      /* slip less displacement: constant at a place while in contact */
    double error[RW_PLACES]; /* of the traction by place, since or once it sticks there */
    rw_friction friction;    /* of the contact now, for the next load; none at first */
} rw_numerical;

/* The effort of a load: a quarter of a second as measured, within a second on slower machines. */
enum { RW_MOST_EFFORT = 40000000 };

/* Begins from `now`, whose traction it takes over. `slip` gives the slip so far of places, over
 * theta; NULL: nothing has slipped. NULL where memory is short. */
rw_numerical *rw_numerical_begin(const rw_frame *frame, const rw_numerical_state *now,
                                 bool has_origin, rw_values slip, const void *context);

/* Makes the clusters of its tractions, after a load. false where memory is short. */
bool rw_numerical_cluster(rw_numerical *numerical);

/* Counts slip anew, from that so far. false where memory is short. */
bool rw_numerical_count_slip(rw_numerical *numerical, const rw_frame *frame, rw_values slip,
                             const void *context);

/* NULL may be copied and destroyed. Where memory is short `is_whole` becomes false, and what there
 * is is only to be destroyed. */
rw_numerical *rw_numerical_copy(const rw_numerical *numerical, bool *is_whole);
void rw_numerical_destroy(rw_numerical *numerical);

/* A straight line to new loads. RWEDGE_ENOMEM; RWEDGE_ENOCONV; then all is as before.
 *   effort  what it may take (rw_work), less what it has taken on return: it may be below 0 */
int32_t rw_numerical_step(rw_numerical *numerical, const rw_frame *frame, rw_scaled_loads to,
                          int *effort);

/* The estimated error of q over f times the peak pressure. */
double rw_numerical_error(const rw_numerical *numerical);

/* Multiplies the errors, where the peak pressure that they are measured by has changed. */
void rw_numerical_rescale(rw_numerical *numerical, double factor);

/* Adds an error where it sticks, independent of those so far. */
void rw_numerical_add_error(rw_numerical *numerical, double error);

/* Notes the errors of a step by place; `half` is the state half-way, or that state itself. */
void rw_numerical_note_error(rw_numerical *numerical, const rw_numerical_state *half,
                             rw_numerical_state *now, double tolerance);

/* The slip of a place in contact, over theta. */
double rw_numerical_slip(const rw_numerical *numerical, double x);

#endif
