/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The equator of the sphere of normals: the planes that contain z, beta = 0. On it amplitudes have
 * one component, and the worst plane of all is most often there. */
#ifndef RW_EQUATOR_H
#define RW_EQUATOR_H

#include "planes/plane_cycle.h"

#include <stdbool.h>

/* The worst plane of the equator. */
void rw_equator_search(const rw_plane_cycle *cycle, const rw_severity *severity,
                       rw_worst_plane *best, rw_direction *psi);

/* Whether no plane is worse than the worst of the equator, which has `value`, by more than noise.
 * Quick. It may say no although it is so. */
bool rw_equator_has_worst(const rw_plane_cycle *cycle, const rw_severity *severity, double value,
                          double noise);

#endif
