/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Under one load both edges of a patch move outwards where the change (dP, d delta) of load and
 * tilt is in the cone |pi s d delta| <= dP (theta/A and theta; s is the half-width of the patch),
 * because flat punches add to its pressure at the edges. The same cone says which way the edges
 * slip: a change of shear and stretch in it makes both edges slip one way, any other one both ways.
 *
 * A straight step in P and M keeps to the cone if it does at its smaller end: the line of action
 * dM/dP of what is added lies between m - s/2 and m + s/2, and where one edge rests, that end of
 * the interval moves outwards. */
#include "history/path.h"

#include <float.h>

/* Of a step whose tilt is no straight line in the load: as many loads on the way are looked at.
 * What is looked for changes as slowly as the tilt itself. */
enum { STATIONS = 16 };

/* Loads at the limit of a cone are inside. */
static const double SLACK = 1e-12;

static double half_width(rw_patch patch)
{
    return rw_patch_half_width(patch);
}

/* P A/theta, a length. */
static double length_of(const rw_geometry *g, double P)
{
    return P * (g->A / g->theta);
}

rw_patch rw_patch_under_moment(const rw_geometry *g, double P, double M)
{
    if (M != 0 && P > 0)
        return rw_patch_of_moment(g->a, length_of(g, P), length_of(g, M));
    const double b = rw_half_width(g, P);
    return (rw_patch){-b, b};
}

rw_patch rw_patch_under_tilt(const rw_geometry *g, double P, double tilt)
{
    if (tilt != 0 && P > 0)
        return fabs(tilt) < 1 ? rw_patch_of_tilt(g->a, length_of(g, P), tilt)
                              : (rw_patch){NAN, NAN};
    const double b = rw_half_width(g, P);
    return (rw_patch){-b, b};
}

bool rw_path_is_plain(const rw_memory *memory, rw_loading to)
{
    if (to.tilt != 0)
        return false;
    for (size_t i = memory->count; i-- > 0;)
        if (memory->corners[i].tilt != 0 || memory->corners[i].stretch != to.stretch)
            return false;
    return true;
}

/* ---- Conditions ---- */

static double tilt_tolerance(const rw_memory *memory, rw_loading to)
{
    return 64 * DBL_EPSILON * (1 + fmax(fabs(to.stretch), fabs(rw_memory_end(memory)->stretch)));
}

bool rw_patch_is_nested(rw_patch inner, rw_patch outer)
{
    const double tolerance = SLACK * (outer.right - outer.left);
    return isgreaterequal(inner.left, outer.left - tolerance) &&
           islessequal(inner.right, outer.right + tolerance);
}

/* Whether a step that is not constant moves both edges outwards, or both inwards. */
static bool edges_go_together(const rw_step *s)
{
    const bool grows = s->to_P > s->from_P;
    if (s->to_P == s->from_P)
        return false;
    if (grows ? s->from_P == 0 : s->to_P == 0)
        return true;
    const rw_patch smaller = grows ? rw_memory_end(s->memory)->patch : s->patch;
    const double action = (s->to_M - s->from_M) / (s->to_P - s->from_P);
    return fabs(action - rw_patch_middle(smaller)) <= (0.5 + SLACK) * half_width(smaller);
}

static bool is_constant(const rw_step *s)
{
    return s->to_P == s->from_P && s->to_M == s->from_M;
}

static bool slips_one_way(const rw_step *s)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const double stretch = fabs(s->to.stretch - end->stretch);
    const double shear = length_of(s->geometry, fabs(s->to.shear - end->shear));
    return stretch <= (1 + SLACK) * shear / (RW_PI * half_width(end->patch)) +
                          tilt_tolerance(s->memory, s->to);
}

/* Whether the front that slips from the edges ends between the same two patches at both. Slip that
 * leaves nothing of the old path slides. */
static bool front_is_nested(const rw_step *s, rw_loading to, rw_patch patch, rw_departure *d)
{
    const rw_memory *memory = s->memory;
    const rw_corner *before = &memory->corners[d->kept - 1];
    const bool is_corner = d->corner.load == before->load;
    if (is_corner)
        return d->kept == 1 ||
               fabs(rw_memory_missing_tilt(before, d->slip, to)) <= tilt_tolerance(memory, to);
    d->corner.patch = rw_patch_under_tilt(s->geometry, d->corner.load, d->corner.tilt);
    const bool is_cut = d->kept == memory->count || memory->corners[d->kept].load > to.load;
    const rw_patch outer = is_cut ? patch : memory->corners[d->kept].patch;
    return (d->kept == 1 || rw_patch_is_nested(before->patch, d->corner.patch)) &&
           rw_patch_is_nested(d->corner.patch, outer);
}

/* Whether the contact, receded, ends between the same two patches at both edges. */
static bool cut_is_nested(const rw_step *s, double load, rw_patch patch)
{
    const rw_memory *memory = s->memory;
    size_t i = memory->count - 1;
    while (memory->corners[i].load > load)
        i--;
    const bool is_last = i + 1 == memory->count;
    return (i == 0 || rw_patch_is_nested(memory->corners[i].patch, patch)) &&
           (is_last || rw_patch_is_nested(patch, memory->corners[i + 1].patch));
}

/* ---- Steps ---- */

static rw_loading part_way(const rw_step *s, double t, rw_patch *patch)
{
    const rw_corner *end = rw_memory_end(s->memory);
    if (t == 1) {
        *patch = s->patch;
        return s->to;
    }
    const double P = s->from_P + t * (s->to_P - s->from_P),
                 M = s->from_M + t * (s->to_M - s->from_M);
    *patch = rw_patch_under_moment(s->geometry, P, M);
    return (rw_loading){.load = P,
                        .shear = end->shear + t * (s->to.shear - end->shear),
                        .tilt = rw_patch_pressing(s->geometry->a, *patch).tilt,
                        .stretch = end->stretch + t * (s->to.stretch - end->stretch)};
}

static rw_obstacle constant_step(const rw_step *s, rw_departure *d)
{
    if (!slips_one_way(s))
        return RW_SLIPS_BOTH_WAYS;
    *d = rw_memory_departure(s->memory, s->to);
    return d->slip == 0 || front_is_nested(s, s->to, s->patch, d) ? RW_NO_OBSTACLE : RW_FRONTS_PART;
}

/* A growing contact whose shear does not slip: a straight line of tilt and stretch in the load. */
static rw_obstacle sticking_growth(const rw_step *s)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const double tolerance = tilt_tolerance(s->memory, s->to);
    const double rise = s->to.shear - end->shear, stretched = s->to.stretch - end->stretch;
    if (rise == 0 && stretched == 0)
        return RW_NO_OBSTACLE;
    for (int i = 1; i <= STATIONS; i++) {
        rw_patch patch;
        const rw_loading at = part_way(s, (double)i / STATIONS, &patch);
        const bool is_level = end->load == 0 || fabs(at.tilt - end->tilt) <= tolerance;
        if (fabs(stretched) > tolerance || !is_level || fabs(at.tilt - s->to.tilt) > tolerance)
            return RW_GROWS_UNEVENLY;
    }
    return RW_NO_OBSTACLE;
}

/* A moving contact: slip must go one way all along, and the fronts inwards. */
static rw_obstacle moving_step(const rw_step *s, rw_departure *d)
{
    *d = rw_memory_departure(s->memory, s->to);
    const bool grows = s->to_P > s->from_P;
    if (grows && d->slip == 0)
        return sticking_growth(s);
    rw_patch front = rw_memory_end(s->memory)->patch;
    bool slips = false;
    for (int i = 1; i <= STATIONS; i++) {
        rw_patch patch;
        const rw_loading at = part_way(s, (double)i / STATIONS, &patch);
        if (at.load == 0)
            break;
        rw_departure on_way = rw_memory_departure(s->memory, at);
        if (!grows && !cut_is_nested(s, at.load, patch))
            return RW_FRONTS_PART;
        if (on_way.slip != (slips ? d->slip : 0) && on_way.slip != d->slip)
            return RW_SLIPS_BOTH_WAYS;
        slips = on_way.slip != 0;
        if (!slips) {
            const double missing = at.stretch - on_way.corner.stretch;
            if (fabs(missing) > tilt_tolerance(s->memory, at))
                return RW_SLIPS_BOTH_WAYS;
            continue;
        }
        const bool is_nested = front_is_nested(s, at, patch, &on_way);
        if (i == STATIONS && !is_nested)
            return RW_FRONTS_PART;
        const bool slides = on_way.corner.load == 0;
        if (!slides && !rw_patch_is_nested(on_way.corner.patch, front))
            return RW_SLIPS_BOTH_WAYS;
        front = slides ? (rw_patch){0, 0} : on_way.corner.patch;
        if (i == STATIONS)
            *d = on_way;
    }
    return RW_NO_OBSTACLE;
}

rw_obstacle rw_path_departure(const rw_step *s, rw_departure *departure)
{
    if (s->to.load == 0 || rw_path_is_plain(s->memory, s->to)) {
        *departure = rw_memory_departure(s->memory, s->to);
        return RW_NO_OBSTACLE;
    }
    if (is_constant(s))
        return constant_step(s, departure);
    if (!edges_go_together(s))
        return RW_EDGES_PART;
    return moving_step(s, departure);
}
