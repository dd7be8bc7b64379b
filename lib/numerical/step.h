/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One implicit step of the shear, and its error. */
#ifndef RW_STEP_H
#define RW_STEP_H

#include "numerical/search.h"

/* Loads as the computed shear has them: P A/theta, a length; Q A/theta; the stretch of problem.h.
 * `turn` is M A/theta, a square, or of a held pad its tilt. */
typedef struct {
    double P, turn, shear, stretch;
} rw_scaled_loads;

/* The contact under the loads. */
rw_patch rw_patch_of_loads(const rw_frame *frame, rw_scaled_loads at);

/* The loads at a part of a straight line. */
static inline rw_scaled_loads rw_part_of_line(rw_scaled_loads from, rw_scaled_loads to, double part)
{
    return (rw_scaled_loads){from.P + part * (to.P - from.P),
                             from.turn + part * (to.turn - from.turn),
                             from.shear + part * (to.shear - from.shear),
                             from.stretch + part * (to.stretch - from.stretch)};
}

/* The places at which tractions are compared. */
enum { RW_PLACES = 121 };

double rw_place(rw_patch contact, int i);

/* The shear of a contact at one moment, with the loads and the errors of the way there. */
typedef struct {
    rw_shear_state shear;
    rw_patch contact;
    double peak; /* f times the peak pressure; 0: not known yet */
    rw_scaled_loads at;
    bool is_still;       /* the contact is as it was at the beginning */
    rw_patch unslipped;  /* the widest part that has not slipped since then */
    double move, energy; /* the rigid move of the zones that stick, the energy: so far */
    double doubt;        /* of the energy of the step that led here (outcome.h) */
    double error;        /* violations of the step that led here, over the scale; of the present
                                state: all of its error */
    double drift;        /* what of them stays where it sticks (outcome.h) */
    double start_error, end_error, rate_error; /* its errors by the rates at its ends (rates.h),
                                and the larger one, over the scale */
    bool is_exact;                             /* what sticks after that step stuck all the time */
    /* of unlike bodies: f times the pressure, B/f, and the tilt (coupled.h); else none */
    rw_traction pressed;
    double coupling, tilt;
    rw_layers layers; /* of the step that led here, and D at its end (outcome.h) */
    double D[2];
    double apart[RW_PLACES]; /* the difference of the step in halves from the whole, by place */
} rw_numerical_state;

/* Whether an edge grows in a step, by more than a millionth of the half-width. */
bool rw_edge_grows(const rw_numerical_state *from, const rw_numerical_state *there, int side);

/* f times the peak pressure of a state. */
double rw_peak_of(const rw_frame *frame, const rw_numerical_state *state);

/* One step as a whole. false where no zones meet the conditions to the tolerance. With `coarse` the
 * best zones are taken, or the grid's answer, and false means that there is none. `guess`, or NULL:
 * zones of a similar step, which are tried first. */
bool rw_implicit_step(rw_work *work, const rw_numerical_state *from, rw_scaled_loads to,
                      const rw_zones *guess, bool coarse, rw_numerical_state *there);

/* The end of a step with its outcome, whose traction it takes over. */
void rw_note_outcome(const rw_problem *problem, const rw_numerical_state *from, rw_scaled_loads to,
                     const rw_outcome *outcome, rw_numerical_state *there);

/* The displacement of the surface at n <= RW_TERMS places by both tractions and the stretch, less
 * the rigid move of the zones that stick; at one place. */
void rw_displacements_of(const rw_numerical_state *state, size_t n, const double x[], double w[]);
double rw_displacement_of(const rw_numerical_state *state, double x);

/* The rates of a step on a contact that it passes. */
void rw_step_rates(const rw_work *work, rw_scaled_loads from, rw_scaled_loads to, rw_patch contact,
                   rw_problem *rates);

/* The contact and its zones alone after a step, which are like those of `guess`, or any with
 * `by_grid`. false where they are not found. */
bool rw_step_zones(rw_work *work, const rw_numerical_state *from, rw_scaled_loads to,
                   const rw_zones *guess, bool by_grid, rw_patch *contact, rw_zones *zones);

/* `from` and `there` were reached from `start`, half-way and as a whole, under constant P and M.
 * Whether the step from the one to the other has the end `there` too: then the whole is exact, and
 * its energy is set to the sum of both halves. */
bool rw_step_goes_on(rw_work *work, const rw_numerical_state *start, const rw_numerical_state *from,
                     rw_numerical_state *there);

/* Compares both halves of a step, the first of which ends at `half`, with the step as a whole. The
 * difference bounds the error of the halves, which is noted there. Returns it, or that of the
 * energies, over what is allowed. */
double rw_compare(rw_work *work, const rw_numerical_state *from, const rw_numerical_state *whole,
                  const rw_numerical_state *half, rw_numerical_state *both);

#endif
