/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plane on which a cycle of stresses has the largest product, or sum, of two quantities: one
 * that counts by its maximum over the loads, and one that counts by its range. Each is, for each
 * load, a wave in phi, twice the angle of the plane: mean + cosine cos(phi) + sine sin(phi). */
#ifndef RW_PLANE_SEARCH_H
#define RW_PLANE_SEARCH_H

#include "base/domain.h"
#include "base/logarithm.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    double cosine, sine;
} rw_direction;

/* The direction turned by the angle whose half has the tangent x, by three shears. (By the usual
 * two sums of products gcc 12 makes a fused instruction of them, against all options.) */
static inline rw_direction rw_turned_by(rw_direction u, double x)
{
    const double sheared = u.cosine - x * u.sine;
    const double sine = u.sine + 2 * x / (1 + x * x) * sheared;
    return (rw_direction){sheared - x * sine, sine};
}

/* The direction turned by the angle of another one. */
static inline rw_direction rw_turned_with(rw_direction u, rw_direction by)
{
    const double sign = by.cosine < 0 ? -1 : 1;
    return rw_turned_by((rw_direction){sign * u.cosine, sign * u.sine},
                        sign * by.sine / (1 + fabs(by.cosine)));
}

static inline double rw_half_tangent(double tangent)
{
    return tangent / (1 + sqrt(1 + tangent * tangent));
}

typedef struct {
    double mean, cosine, sine;
} rw_wave;

/* The stresses of load i are sxx[i stride] ... With the normal stress of a plane n = s + d cos(phi)
 * + t sin(phi), s = (sxx+syy)/2, d = (syy-sxx)/2, t = txy, and its shear stress q = t cos(phi) - d
 * sin(phi) the two waves are
 *     peak  = offset + gain n
 *     range = mean s + normal (n - s) + shear q */
typedef struct {
    size_t loads, stride;
    const double *sxx, *syy, *txy;
    bool is_sum;
    double offset, gain;
    double mean, normal, shear;
    rw_wave *room; /* for RW_WAVE_KINDS waves a load; NULL: the time may grow like the square of the
                      loads */
} rw_stress_cycle;

enum { RW_WAVE_KINDS = 3 };

/* The largest max(0, max peak) (max range - min range), and its phi, which is 0 where the product
 * is 0; or the largest max peak + max range - min range. */
double rw_plane_search(const rw_stress_cycle *cycle, rw_direction *phi);

/* Half the angle of the direction (cosine, sine), in (-pi/2, pi/2]: the angle between a plane's
 * normal and +y, positive towards +x. */
static inline double rw_plane_angle(double cosine, double sine)
{
    const double angle = rw_angle(cosine, sine) / 2;
    return angle > -RW_HALF_PI ? angle : RW_HALF_PI;
}

#endif
