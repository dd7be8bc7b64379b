/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limit of friction in a contact, f times the pressure, on elements. A step reads it at
 * thousands of places, and on elements a profile of many arcs takes no longer than one arc. */
#ifndef RW_FRAME_H
#define RW_FRAME_H

#include "formulas/arcs.h"
#include "traction/bounded_inverse.h"

enum { RW_MOST_BENDS = 24, RW_MOST_KINKS = 128 };

/* What all steps of a contact share: the profile, friction, and the tolerance of q over f times the
 * peak pressure. Bends are places where the curvature of the profile jumps so much that a pressure
 * is not smooth there. A load after which the error is twice what it was, and `far_off` more, has
 * not converged. Whether the pad is held says what of its loads goes straight (step.h). B is minus
 * Dundurs' beta of the half-plane and the pad, 0 for similar bodies. */
typedef struct {
    rw_arcs arcs;
    double f, tolerance, far_off;
    bool is_held;
    double B;
    int bends;
    double bend[RW_MOST_BENDS];
} rw_frame;

rw_frame rw_frame_of(rw_arcs arcs, double f, double tolerance);

/* The same with another tolerance. */
rw_frame rw_frame_like(const rw_frame *frame, double tolerance);

/* Writes the bends between two places to `at`, in order, but for those at an end, to rounding, and
 * returns how many; `at` has room for all. */
int rw_bends_between(const rw_frame *frame, double from, double to, double at[]);

/* Writes to `at` the edges of a contact, some kinks, and the bends between, in order, and returns
 * how many; `at` has room for all. */
size_t rw_breaks_of(const rw_frame *frame, rw_patch contact, int kinks, const double kink[],
                    double at[]);

/* f times the pressure, in theta/A: at n places, at one, and its peak. */
void rw_exact_frictions(const rw_frame *frame, rw_patch contact, size_t n, const double x[],
                        double F[]);
double rw_exact_friction(const rw_frame *frame, rw_patch contact, double x);
double rw_peak_friction(const rw_frame *frame, rw_patch contact);

/* Fits the pressure times mean + slope (x - middle) so well as friction of this peak. false where
 * memory is short. */
bool rw_frame_fit(const rw_frame *frame, rw_patch contact, double mean, double slope, double peak,
                  rw_traction *traction);

/* Friction over a contact. `own` is what the pad alone makes, where bodies are unlike: that of
 * another friction. It is NULL where they are similar. */
typedef struct {
    rw_patch contact;
    double tolerance, peak;
    rw_traction traction;
    const rw_traction *own;
} rw_friction;

static inline const rw_traction *rw_own_friction(const rw_friction *friction)
{
    return friction->own ? friction->own : &friction->traction;
}

/* Makes that of similar bodies. false where memory is short; then there is nothing to destroy. */
bool rw_friction_create(rw_friction *friction, const rw_frame *frame, rw_patch contact);

/* Makes that of unlike bodies: that of the pad alone, which is to live as long, and f B L[t]. Kinks
 * are those of t on the contact. */
bool rw_friction_couple(rw_friction *friction, const rw_frame *frame, const rw_friction *alone,
                        const rw_bounded_inverse *inverse, int kinks, const double kink[]);
void rw_friction_destroy(rw_friction *friction);

#endif
