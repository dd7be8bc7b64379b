/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Neighbouring elements of a traction t, taken as one where they are far away. In the elliptic
 * coordinates about such a cluster, of the middle m and the half-length h,
 *     Omega(z) = sum a_n R^(n+1),   a_n = -2/(pi h) int t U_n((s - m)/h) ds,
 * which is the paper's series (potential/elliptic.h), and its integral is the displacement. A
 * cluster is far where |R| <= 1/4: the terms left out are then 4^-17 and less. All elements are a
 * cluster, which is divided in two next to its middle, and so on: a place that is not far from it
 * may be far from a part. So few terms give the field, however many elements there are. */
#ifndef RW_CLUSTERS_H
#define RW_CLUSTERS_H

#include "traction/places.h"
#include "traction/traction.h"

/* Whether a place is far from the cluster. */
static inline bool rw_is_far(const rw_cluster *cluster, double x, double y)
{
    const double v = (x - cluster->middle) * cluster->per_half * (2 / (4 + 1.0 / 4)),
                 w = y * cluster->per_half * (2 / (4 - 1.0 / 4)); /* on the ellipse |R| = 1/4: 1 */
    return v * v + w * w >= 1;
}

/* Adds Omega and y Omega' of a cluster at places that are far from it. */
void rw_add_cluster(const rw_cluster *cluster, const rw_places *far, const double x[],
                    const double y[], rw_fields *sum);

/* -(1/pi) int t ln|s - x| ds of a cluster at a place of the surface that is far from it. */
double rw_cluster_displacement(const rw_cluster *cluster, double x);

#endif
