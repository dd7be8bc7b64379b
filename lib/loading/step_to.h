/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step to the next loads. */
#ifndef RW_STEP_TO_H
#define RW_STEP_TO_H

#include "contact/contact.h"

/* The largest tilt over theta: closer to 1 the edges are lost in rounding. */
#define RW_LARGEST_TILT (1 - 1e-9)

/* The step to the loads. RWEDGE_EDOMAIN, RWEDGE_ERANGE and RWEDGE_ESLIDING where they are not
 * allowed. */
int32_t rw_step_to(const rwedge_contact *contact, rw_goal to, rw_step *step);

/* A tilt as loads have it: of a profile, less the slope between its outermost ones. */
static inline double rw_as_held(const rw_geometry *g, double tilt)
{
    return (tilt - g->middle_slope) / g->theta;
}

/* Whether the pad is held, and can be at that tilt: guided.c. */
bool rw_can_be_guided(const rwedge_contact *contact, double tilt);

/* Whether friction is exhausted after a step. */
bool rw_slides_at_end(const rw_step *step);

/* The patch under the next loads; NaN where they are refused or separate the bodies. */
rw_patch rw_contact_patch_under(const rwedge_contact *contact, rw_goal to);

/* Why a straight line to the loads, as one step, has no closed form. */
rw_obstacle rw_contact_obstacle(const rwedge_contact *contact, rw_loads to);

/* Rounding may put both edges at one place. A patch of NaN is not known yet, and counts as wide. */
bool rw_has_width(rw_patch patch);

#endif
