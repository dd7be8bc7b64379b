/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A criterion of planes as the search takes it, and the loads of a point of a field. */
#ifndef RW_PLANES_H
#define RW_PLANES_H

#include "measures/stress_cycles.h"
#include "planes/worst_plane.h"

/* What makes the criterion of the search: its value is the sum of these parts of what the worst
 * plane has. */
typedef struct {
    rw_severity severity; /* gain is per stress */
    double per_value, per_amplitude, per_peak;
    bool has_ratio; /* of the peak to the amplitude: what it adds, and at most */
    double per_ratio, most_by_ratio;
} rw_criterion;

/* The criterion of a field by constants in their ranges. */
typedef rw_criterion rw_plane_criterion(const rw_stress_field *f, const double constants[]);
rw_plane_criterion rw_smith_watson_topper, rw_fatemi_socie, rw_findley, rw_modified_wohler,
    rw_mcdiarmid;

/* The largest value at each point. */
int32_t rw_search_planes(const rw_stress_field *f, const rw_criterion *c,
                         const rw_criterion_results *results);

/* The same of the planes that contain z. */
rw_criterion_of_field rw_smith_watson_topper_in_plane, rw_fatemi_socie_in_plane;

/* The severity of stresses in the unit, and what a value of it counts. */
rw_severity rw_severity_in(const rw_criterion *c, double unit);
double rw_value_in(const rw_criterion *c, double unit);

/* The loads of a point, in their order, in the unit. */
void rw_set_loads(const rw_stress_field *f, size_t point, const rw_criterion *c, double unit,
                  rw_plane_cycle *cycle);

#endif
