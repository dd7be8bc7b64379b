/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planes/equator.h"

#include "base/domain.h"

#include <float.h>

/* ---- One load ---- */

/* The quantity that counts by its range, on the equator. */
static inline double along(bool is_strain, const rw_item *load, rw_direction psi)
{
    const double C = psi.cosine, S = psi.sine;
    return is_strain ? load->level - load->deviation_lift +
                           (load->deviation_d * C + load->deviation_t * S)
                     : load->deviation_t * C - load->deviation_d * S;
}

static inline double normal_stress(const rw_item *load, rw_direction psi)
{
    return load->z - load->lift + (load->d * psi.cosine + load->t * psi.sine);
}

/* ---- Search ---- */

void rw_equator_search(const rw_plane_cycle *cycle, const rw_severity *severity,
                       rw_worst_plane *best, rw_direction *psi)
{
    const bool is_strain = severity->is_strain;
    const rw_stress_cycle waves = {.loads = cycle->loads,
                                   .stride = sizeof *cycle->item / sizeof(double),
                                   .sxx = &cycle->item->xx,
                                   .syy = &cycle->item->yy,
                                   .txy = &cycle->item->t,
                                   .is_sum = severity->is_sum,
                                   .offset = severity->offset,
                                   .gain = (severity->is_sum ? 2 : 1) * severity->gain,
                                   .mean = is_strain ? 1 + severity->shift : 0,
                                   .normal = is_strain,
                                   .shear = !is_strain,
                                   .room = cycle->wave};
    rw_plane_search(&waves, psi);
    double high = -DBL_MAX, low = DBL_MAX, peak = -DBL_MAX;
    for (size_t i = 0; i < cycle->loads; i++) {
        const double v = along(is_strain, &cycle->item[i], *psi);
        high = rw_larger(high, v), low = rw_smaller(low, v);
        peak = rw_larger(peak, normal_stress(&cycle->item[i], *psi));
    }
    const double amplitude = (high - low) / 2;
    *best = (rw_worst_plane){
        .value = rw_severity_of(severity, amplitude, peak), .amplitude = amplitude, .peak = peak};
}

/* ---- Away from the equator ---- */

/* psi within `half` of a direction; the tangent of half of that. */
typedef struct {
    rw_direction psi;
    double half, tangent;
} psi_arc;

/* Bounds on an arc: least and most of half the range of the amplitude's quantity; half the range of
 * its limit away from the equator; least and most of the peak; the largest szz. */
typedef struct {
    double least, most, beyond, least_peak, most_peak, z;
} reach;

static reach reach_of(const rw_plane_cycle *cycle, const rw_severity *v, const psi_arc *arc)
{
    double high = -DBL_MAX, low = DBL_MAX, top = -DBL_MAX, bottom = DBL_MAX, travel = 0, turn = 0;
    reach r = {.least_peak = -DBL_MAX, .z = -DBL_MAX};
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        const double value = along(v->is_strain, load, arc->psi);
        const double other = v->is_strain
                                 ? load->level
                                 : load->deviation_lift - (load->deviation_d * arc->psi.cosine +
                                                           load->deviation_t * arc->psi.sine);
        high = rw_larger(high, value), low = rw_smaller(low, value);
        top = rw_larger(top, other), bottom = rw_smaller(bottom, other);
        r.least_peak = rw_larger(r.least_peak, normal_stress(load, arc->psi));
        r.z = rw_larger(r.z, load->z);
        travel = rw_larger(travel, arc->half * load->deviation_size);
        turn = rw_larger(turn, arc->half * load->size);
    }
    r.least = rw_larger(0, (high - low) / 2 - travel);
    r.most = (high - low) / 2 + travel;
    r.beyond = (top - bottom) / 2 + (v->is_strain ? 0 : travel);
    r.most_peak = r.least_peak + turn;
    r.least_peak -= turn;
    return r;
}

/* With u the square of sin(beta), the half range r of a strain becomes at most (1-u) r + u beyond,
 * that of a shear stress at most sqrt((1-u) (r^2 + u beyond^2)); a peak p at most (1-u) p + u z.
 * The sum of such functions is concave in u, and so is the logarithm of their product: they fall
 * for every u if they fall from u = 0 on. */
static bool falls_away(const rw_severity *v, const reach *r)
{
    if (r->least <= 0 || (!v->is_sum && v->offset + v->gain * r->least_peak <= 0))
        return false;
    const double ratio = r->beyond / r->least;
    const double fall = v->is_strain ? 1 - ratio : (1 - ratio * ratio) / 2;
    const double peak = fall > 0 ? r->least_peak : r->most_peak;
    const double factor = v->is_sum ? r->least : v->offset + v->gain * peak;
    return v->gain * (r->z - r->least_peak) <= fall * factor;
}

/* Above the amplitude plus `rise` u, for every u: the derivative of the root has one zero. */
static double most_amplitude(const rw_severity *v, const reach *r, double rise)
{
    const double beyond = rw_larger(r->most, r->beyond);
    const double ratio = beyond > 0 ? r->most / beyond : 0, square = ratio * ratio;
    if (v->is_strain)
        return beyond;
    if ((1 - square) * beyond + 2 * ratio * rise < 0)
        return r->most; /* it falls */
    return ((1 + square) * sqrt(beyond * beyond + rise * rise) + (1 - square) * rise) / 2;
}

/* Above the severity for every u. */
static double most_severity(const rw_severity *v, const reach *r)
{
    if (!v->is_sum)
        return rw_severity_of(v, most_amplitude(v, r, 0), rw_larger(r->most_peak, r->z));
    const double rise = v->gain * (r->z - r->most_peak);
    return rw_severity_of(v, most_amplitude(v, r, rise), r->most_peak);
}

/* With u the square of sin(beta), the amplitude is at most (1-u) r + u beyond, the peak at most
 * (1-u) p + u z, and r p at most the value. Plane stress has no stress z across the plane, plane
 * strain no strain `beyond`. So what is left of the product is u (1-u) (r z + p beyond). */
static bool has_worst_product(const rw_plane_cycle *cycle, double value)
{
    double r = 0, p = 0, z = 0, top = -DBL_MAX, bottom = DBL_MAX;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        r = rw_larger(r, fabs(load->level - load->deviation_lift) + load->deviation_size);
        p = rw_larger(p, load->z - load->lift + load->size);
        z = rw_larger(z, load->z);
        top = rw_larger(top, load->level), bottom = rw_smaller(bottom, load->level);
    }
    const double beyond = (top - bottom) / 2;
    return r * z + p * beyond <= 2 * value;
}

enum { ARCS = 8 };

/* How often an arc is halved to show that no plane away from it is worse. */
enum { DEPTH = 7 };

#define DIAGONAL 0.70710678118654752
static const rw_direction CENTRES[ARCS] = {
    {1, 0},  {DIAGONAL, DIAGONAL},   {0, 1},  {-DIAGONAL, DIAGONAL},
    {-1, 0}, {-DIAGONAL, -DIAGONAL}, {0, -1}, {DIAGONAL, -DIAGONAL}};
static const double TANGENT = 0.19891236737965801; /* of pi/16 */

static psi_arc half_of(const psi_arc *arc, bool is_forward)
{
    const double tangent = rw_half_tangent(arc->tangent);
    return (psi_arc){rw_turned_by(arc->psi, is_forward ? tangent : -tangent), arc->half / 2,
                     tangent};
}

/* Whether no plane with psi in the arc, and whatever beta, is worse than the plane of the equator
 * with the same psi, or than `value`. */
static bool is_worst(const rw_plane_cycle *cycle, const rw_severity *v, const psi_arc *arc,
                     int depth, double value)
{
    const reach r = reach_of(cycle, v, arc);
    if (falls_away(v, &r) || most_severity(v, &r) <= value)
        return true;
    const psi_arc first = half_of(arc, false), second = half_of(arc, true);
    return depth > 0 && is_worst(cycle, v, &first, depth - 1, value) &&
           is_worst(cycle, v, &second, depth - 1, value);
}

bool rw_equator_has_worst(const rw_plane_cycle *cycle, const rw_severity *severity, double value,
                          double noise)
{
    if (severity->is_strain && has_worst_product(cycle, value))
        return true;
    for (int k = 0; k < ARCS; k++) {
        const psi_arc arc = {CENTRES[k], RW_PI / ARCS, TANGENT};
        if (!is_worst(cycle, severity, &arc, DEPTH, value + noise))
            return false;
    }
    return true;
}
