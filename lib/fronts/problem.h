/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step of the shear to new loads, as a problem for its traction: lib/README.md, "Any history".
 * Tractions are in theta/A, t = -q, so that the integral of t is the shear load; displacements are
 * in theta. On the surface the half-plane moves relative to the pad by w, with Omega of transform.h
 * and
 *     w' = Omega + stretch,   stretch = (surface strain of the bulk tension)/theta.
 * A straight step changes the pressure to p', t by dt and w by dw. It is a convex problem with one
 * solution: |t + dt| <= F' = f |p'|. Where the surface sticks, dw is one constant. Where it slips,
 * t + dt = S F', S = +-1, and dw less that constant has the sign -S.
 *
 * A growing contact takes in places that have not slipped. Where it sticks up to the edge, dt
 * contains layers (layers.h). */
#ifndef RW_PROBLEM_H
#define RW_PROBLEM_H

#include "fronts/frame.h"

#include "base/tuned.h"
#include "traction/layers.h"
#include "traction/traction.h"

enum { RW_MOST_ZONES = 24 };

/* A zone that sticks, label 0, or slips, label S = +-1, the sign of t. Neighbours share their
 * ends. */
typedef struct {
    int label;
    double left, right;
} rw_zone;

typedef struct {
    int count;
    rw_zone zone[RW_MOST_ZONES];
} rw_zones;

/* The zone at the left edge, or with a side at the right one. */
static inline rw_zone rw_zones_at_edge(const rw_zones *zones, int side)
{
    return zones->zone[side ? zones->count - 1 : 0];
}

/* Puts a zone before the i-th. Leaves it out where there is no room: of so many zones no fronts are
 * found. */
void rw_zones_insert(rw_zones *zones, int i, rw_zone zone);

/* The label at a place of the contact; the widest part of a patch that sticks, without width where
 * none does. */
int rw_zones_label(const rw_zones *zones, double x);
rw_patch rw_zones_widest_stick(const rw_zones *zones, rw_patch patch);

/* A shear traction that has no closed form, with its zones. Kinks are places where it is not
 * smooth. */
typedef struct {
    rw_traction traction;
    rw_zones zones;
    int kinks;
    double kink[RW_MOST_KINKS];
} rw_shear_state;

typedef struct {
    const rw_frame *frame;
    double scale;            /* f times the peak pressure */
    double allowed;          /* violations up to this, over the scale, count as none */
    rw_patch from, to, both; /* the contact before and after the step; both: their union */
    const rw_friction *before, *after;
    bool is_still;                           /* from and to are the same */
    double growth[2];                        /* at the left, right edge: how far it moves */
    bool grows[2];                           /* outwards, by more than rounding */
    double load[RW_LAYERS], tilt[RW_LAYERS]; /* of the layers: lengths, theta */
    rw_layer_rest rest[RW_LAYERS][2];        /* before and after */
    double ratio[RW_LAYERS][2][2]; /* layers over friction: at the edges, before and after */
    double middle, half;           /* of the contact after the step */
    double shear, stretch;         /* the changes of the shear load and of the stretch */
    bool is_rate;                  /* the rates at one moment: friction is like 1/sqrt at edges */
    const rw_shear_state *old;
} rw_problem;

/* The step from one contact and the old traction to another; `shear` is the change of the shear
 * load, a length, `stretch` that of the stretch. */
void rw_problem_init(rw_problem *p, const rw_frame *frame, const rw_friction *before,
                     const rw_friction *after, const rw_shear_state *old, double shear,
                     double stretch);

/* The change of the loads as a traction. */
double rw_problem_change(const rw_problem *p);

/* The limit of friction F = f |p| at n places, after the step and before it. */
void rw_friction_after(const rw_problem *p, size_t n, const double x[], double F[]);
void rw_friction_before(const rw_problem *p, size_t n, const double x[], double F[]);

/* The change of traction at n places by each layer, per weight, that of layer k from
 * change[k * stride] on; F is the friction after the step there. */
void rw_layer_values(const rw_problem *p, int count, size_t n, const double x[], const double F[],
                     size_t stride, double change[]);

/* w' of layer k per weight at n <= RW_TERMS places, besides that of what sticks: 0 but where an
 * edge passes. */
void rw_layer_slopes(const rw_problem *p, int k, size_t n, const double x[], double slope[]);

/* D of the layers of a step to the contact `to`, when the left or right edge of the contact was
 * that of this friction. */
double rw_layers_ratio(const rw_frame *frame, const rw_friction *friction, rw_patch to,
                       const rw_layers *layers, int side);

/* The changes of shear load and stretch, less those that the layers make. */
void rw_beside_layers(const rw_problem *p, const rw_layers *layers, double *shear, double *stretch);

/* The old traction plus the layers, at n <= RW_TERMS places. */
void rw_base_traction(const rw_problem *p, const rw_layers *layers, size_t n, const double x[],
                      double t[]);

/* The problem of the rates: a contact whose loads change at these rates, at one moment. */
void rw_problem_init_rates(rw_problem *p, const rw_frame *frame, rw_patch contact, double load,
                           double moment, double shear, double stretch);

/* The angle of a place, 0 at the left edge of the contact to pi at the right one, and the place of
 * an angle. */
double rw_angle_of(const rw_problem *p, double x);
double rw_place_of(const rw_problem *p, double angle);

#endif
