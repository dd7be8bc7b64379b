/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of the shear. Tractions are in theta/A, t = -q, so that the integral of t is the shear
 * load; displacements in theta. On the surface the half-plane moves against the pad by w with
 *     w' = Omega + stretch,   stretch = (surface strain of the bulk tension)/theta.
 * A straight step to new loads is a convex problem with one solution. Its traction is t + dt, with
 * |t + dt| <= F' = f |p'|. Where it sticks, dw is one constant; where it slips, t + dt = S F', and
 * dw less that constant has the sign -S.
 *
 * A growing contact brings new material into contact without slip. Where that sticks up to the
 * edge, the change holds layers (layers.h). */
#ifndef RW_PROBLEM_H
#define RW_PROBLEM_H

#include "fronts/frame.h"
#include "traction/layers.h"
#include "traction/traction.h"

enum { RW_MOST_ZONES = 24, RW_MOST_KINKS = 48 };

/* Neighbours share their ends; 0 sticks, +-1 is the sign of t. */
typedef struct {
    int label;
    double left, right;
} rw_zone;

typedef struct {
    int count;
    rw_zone zone[RW_MOST_ZONES];
} rw_zones;

/* Where the shear stands: in closed form no more. Kinks are where the traction is not smooth. */
typedef struct {
    rw_traction traction;
    rw_zones zones;
    int kinks;
    double kink[RW_MOST_KINKS];
} rw_shear_state;

typedef struct {
    const rw_frame *frame;
    double f;
    double scale;            /* f times the peak pressure */
    double tolerance;        /* of tractions */
    double allowed;          /* violations, over the scale */
    rw_patch from, to, both; /* both: what is in either */
    const rw_friction *before, *after;
    bool is_still;                           /* the contact is as it was */
    bool grows[2];                           /* at the left, right edge */
    double load[RW_LAYERS], tilt[RW_LAYERS]; /* by which layers change: lengths, theta */
    double ratio[RW_LAYERS][2][2]; /* of layers to friction: at the edges, before and after */
    double middle, half;           /* of the contact after the step */
    double shear, stretch;         /* the changes */
    bool is_rate;                  /* changes are those of a moment: of friction, like 1/sqrt */
    const rw_shear_state *old;
} rw_problem;

/* loads are lengths: P A/theta, and what the old traction carries is its total. */
void rw_problem_init(rw_problem *p, const rw_frame *frame, const rw_friction *before,
                     const rw_friction *after, const rw_shear_state *old, double shear,
                     double stretch);

/* F after the step, and before it. */
double rw_friction_after(const rw_problem *p, double x);
double rw_friction_before(const rw_problem *p, double x);

/* What layers change; friction is that after the step, to spare it. */
void rw_layers_at(const rw_problem *p, int count, double x, double friction, double change[]);

/* What is left of the changes of shear and stretch besides layers. */
void rw_beside_layers(const rw_problem *p, const rw_layers *layers, double *shear, double *stretch);

/* The old traction and the layers. */
double rw_base_traction(const rw_problem *p, const rw_layers *layers, double x);

/* A contact in its place, whose loads change at these rates. */
void rw_problem_init_rates(rw_problem *p, const rw_frame *frame, rw_patch contact, double load,
                           double moment, double shear, double stretch);

/* The angle of a place in the contact, 0 at its left edge to pi, and back. */
double rw_angle_of(const rw_problem *p, double x);
double rw_place_of(const rw_problem *p, double angle);

#endif
