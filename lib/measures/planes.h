/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A criterion of planes as the search takes it, and the loads of a point of a field. */
#ifndef RW_PLANES_H
#define RW_PLANES_H

#include "measures/field.h"
#include "planes/worst_plane.h"

/* What makes the criterion of the search: its value is the sum of these parts of what the worst
 * plane has. */
typedef struct {
    rw_severity severity; /* gain is per stress */
    bool is_plane_stress;
    double per_value, per_amplitude, per_peak, per_ratio; /* ratio: of the peak to the amplitude */
} rw_criterion;

/* Smith, Watson and Topper's; Fatemi and Socie's. False outside the domain; *c is
 * then as before. */
bool rw_smith_watson_topper(double E, double nu, int32_t plane_stress, rw_criterion *c);
bool rw_fatemi_socie(double E, double nu, int32_t plane_stress, double k_over_sy, rw_criterion *c);

/* The severity of stresses in the unit, and what a value of it counts. */
rw_severity rw_severity_in(const rw_criterion *c, double unit);
double rw_value_in(const rw_criterion *c, double unit);

/* The loads of a point, in their order, in the unit. */
void rw_set_loads(const rw_stress_field *f, size_t point, const rw_criterion *c, double unit,
                  rw_plane_cycle *cycle);

#endif
