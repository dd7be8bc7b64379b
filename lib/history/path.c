/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Under one load both edges of a patch move outwards where the change (dP, d delta) of load and
 * tilt is in the cone |pi s d delta| <= dP (theta/A and theta; s is the half-width of the
 * patch): the pressure that is added, that of a flat punch, is then positive everywhere. A
 * straight step in P and M keeps to the cone if it does at its smaller end: the line of action
 * dM/dP of what is added lies between m - s/2 and m + s/2, and where one edge rests, that end of
 * the interval moves outwards. A straight step in P and tilt keeps to it if it does at its larger
 * end: where s passes |dP|/(pi |d delta|), one edge rests and the other goes the way of P.
 *
 * With S the sign of slip, z = f |p| - S q is what friction has left, and y >= 0 the slip so far
 * in the direction S: z y = 0, as pressure and gap of a contact without friction, of the load N
 * - S T. A change of N - S T in the negative cone takes z away everywhere. Then z falls and y
 * grows at every point and all the time, because slip at one point presses every other one the
 * same way. So y and z at the end of the step do not depend on the way there. They are what the
 * memory diagram says if that has z >= 0, which nested patches have, and y >= 0, see one_way.c.
 * No point slips the other way as long as z <= 2 f |p|. That is so where the pressure nowhere
 * falls; where what sticks is still inside the contact; and where the front inside one layer
 * stays behind the edges of the contact. */
#include "history/path.h"

#include <float.h>

/* How often a step is divided, to bound what changes on its pieces. */
enum { TRIES = 40 };

/* Loads at the limit of a cone are inside. */
static const double SLACK = 1e-12;

/* ---- Conditions ---- */

/* The rounding of tilts and stretches, which are as small as the contact is beside the rounding of
 * the profile. */
static double tilt_tolerance(const rw_step *s, rw_memory_loads to)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const double width = rw_patch_half_width(end->patch), a = s->geometry->a,
                 size = width < a ? width / a : 1;
    return 64 * DBL_EPSILON *
           (size + fmax(fabs(to.tilt), fabs(end->tilt)) +
            fmax(fabs(to.stretch), fabs(end->stretch)));
}

typedef struct {
    double least, most;
} range;

static double largest(range r)
{
    return fmax(fabs(r.least), fabs(r.most));
}

/* Whether a change of load, a length, and of tilt adds to the traction everywhere within a
 * patch. */
static bool adds_everywhere(double load, range tilt, rw_patch patch, double tolerance)
{
    const double arm = RW_PI * rw_patch_half_width(patch);
    return arm * (largest(tilt) - tolerance) <= (1 + SLACK) * load;
}

/* Whether slip has exhausted friction all over, so that nothing of the old path is left. No other
 * traction carries so much shear, whatever the way. */
static bool is_sliding(const rw_step *s, rw_memory_loads to, int slip, rw_departure *d)
{
    const double most = fmax(to.load, rw_memory_end(s->memory)->load);
    if (to.load - slip * to.shear > rw_memory_tolerance(most))
        return false;
    *d = (rw_departure){s->memory->corners[0], 1, slip};
    return true;
}

/* Whether the front of slip lies between the same two patches at both edges, and all points that it
 * passed have slipped. */
static bool front_is_known(const rw_step *s, rw_memory_loads to, rw_patch patch, rw_departure *d)
{
    const rw_memory *memory = s->memory;
    if (is_sliding(s, to, d->slip, d))
        return true;
    const rw_corner *before = &memory->corners[d->kept - 1];
    const bool is_corner = d->corner.load == before->load;
    if (!is_corner)
        d->corner.patch = rw_patch_under_tilt(s->geometry, d->corner.load, d->corner.tilt);
    else if (fabs(rw_memory_missing_tilt(before, d->slip, to)) > tilt_tolerance(s, to))
        return false;
    const double tilt = fmax(fabs(to.tilt), fabs(d->corner.tilt));
    return (d->kept == 1 || rw_patch_is_nested(before->patch, d->corner.patch, tilt)) &&
           rw_patch_is_nested(d->corner.patch, memory->corners[d->kept].patch, tilt) &&
           rw_patch_is_nested(d->corner.patch, patch, tilt) &&
           rw_slips_one_way(memory, d, s->geometry);
}

/* ---- Constant load and moment ---- */

static rw_obstacle constant_step(const rw_step *s, rw_departure *d)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const double shear = rw_as_length(s->geometry, fabs(s->to.shear - end->shear));
    const double stretch = s->to.stretch - end->stretch;
    if (!adds_everywhere(shear, (range){stretch, stretch}, end->patch, tilt_tolerance(s, s->to)))
        return RW_SLIPS_BOTH_WAYS;
    *d = rw_memory_departure(s->memory, s->to);
    return d->slip == 0 || front_is_known(s, s->to, s->patch, d) ? RW_NO_OBSTACLE : RW_FRONTS_PART;
}

/* ---- A moving contact ---- */

static bool grows(const rw_step *s)
{
    return s->to_P > s->from_P;
}

/* How much a held pad turns. Before the bodies touch it has the tilt of the step's end. */
static double turned(const rw_step *s)
{
    const rw_corner *end = rw_memory_end(s->memory);
    return end->load == 0 ? 0 : s->to.tilt - end->tilt;
}

/* The tilt of a held pad on the way. */
static double tilt_at(const rw_step *s, double t)
{
    return s->to.tilt - (1 - t) * turned(s);
}

static rw_patch patch_of(const rw_step *s, double P, double M, double held_tilt)
{
    return s->is_held ? rw_patch_under_tilt(s->geometry, P, held_tilt)
                      : rw_patch_under_moment(s->geometry, P, M);
}

/* The contact on the way. */
static rw_patch patch_at(const rw_step *s, double t)
{
    return patch_of(s, s->from_P + t * (s->to_P - s->from_P), s->from_M + t * (s->to_M - s->from_M),
                    tilt_at(s, t));
}

/* Whether a step that is not constant moves both edges outwards, or both inwards. */
static bool edges_go_together(const rw_step *s)
{
    if (s->to_P == s->from_P)
        return false;
    if (grows(s) ? s->from_P == 0 : s->to_P == 0)
        return true;
    const rw_patch end = rw_memory_end(s->memory)->patch, smaller = grows(s) ? end : s->patch;
    if (s->is_held) {
        const double load = rw_as_length(s->geometry, fabs(s->to_P - s->from_P)), tilt = turned(s);
        return adds_everywhere(load, (range){tilt, tilt}, grows(s) ? s->patch : end,
                               tilt_tolerance(s, s->to));
    }
    const double action = (s->to_M - s->from_M) / (s->to_P - s->from_P);
    return fabs(action - rw_patch_middle(smaller)) <= (0.5 + SLACK) * rw_patch_half_width(smaller);
}

/* Whether the tilt stays as it is: without moment, and for Hertz under one line of action. */
static bool is_level(const rw_step *s)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const rw_patch larger = grows(s) ? s->patch : end->patch;
    const double a = s->geometry->a;
    const bool is_hertz = !s->geometry->pad && rw_arc_covers(rw_rounding(a), larger);
    return (rw_is_symmetric(s->geometry) && s->from_M == 0 && s->to_M == 0) ||
           (is_hertz &&
            (end->load == 0 || fabs(s->to.tilt - end->tilt) <= tilt_tolerance(s, s->to)));
}

/* The tilt that a moment makes. For a patch without width it is unbounded, but not infinite: 0
 * times it is 0. */
static double tilt_by(double moment, double half_width)
{
    static const double UNBOUNDED = 1e200;
    if (half_width == 0)
        return copysign(UNBOUNDED, moment);
    return 2 / RW_PI * moment / (half_width * half_width);
}

/* Bounds on d delta/dt = 2 (dM - m dP)/(pi s^2) while the patch, of middle m and half-width s, is
 * between two others; the step lasts from t = 0 to 1. */
static range tilt_rate(const rw_step *s, rw_patch smaller, rw_patch larger)
{
    if (s->is_held)
        return (range){turned(s), turned(s)};
    if (is_level(s))
        return (range){0, 0};
    const double P = rw_as_length(s->geometry, s->to_P - s->from_P);
    const double M = rw_as_length(s->geometry, s->to_M - s->from_M);
    const double at_left = M - P * (larger.left / 2 + smaller.right / 2);
    const double at_right = M - P * (smaller.left / 2 + larger.right / 2);
    const double least = fmin(at_left, at_right), most = fmax(at_left, at_right);
    const double few = rw_patch_half_width(smaller), many = rw_patch_half_width(larger);
    return (range){tilt_by(least, least > 0 ? many : few), tilt_by(most, most > 0 ? few : many)};
}

/* Whether the shear stays in a layer of slope D during the step: its stretch does not change, so D
 * times the tilt must not either. */
static bool keeps_to_layer(const rw_step *s, double D, range tilt_rate)
{
    const double tolerance = tilt_tolerance(s, s->to);
    return fabs(s->to.stretch - rw_memory_end(s->memory)->stretch) <= tolerance &&
           fabs(D) * largest(tilt_rate) <= tolerance;
}

/* A growing contact that does not slip. */
static rw_obstacle sticking_growth(const rw_step *s)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const double rise = s->to.shear - end->shear;
    if (rise == 0 && s->to.stretch == end->stretch)
        return RW_NO_OBSTACLE;
    const double D = rise / (s->to.load - end->load);
    return keeps_to_layer(s, D, tilt_rate(s, end->patch, s->patch)) ? RW_NO_OBSTACLE
                                                                    : RW_GROWS_UNEVENLY;
}

/* A receding contact that does not slip: only its last layer becomes smaller. */
static rw_obstacle sticking_recession(const rw_step *s, const rw_departure *d)
{
    const rw_corner *end = rw_memory_end(s->memory);
    if (d->kept + 1 != s->memory->count ||
        (d->kept > 1 && !rw_patch_is_nested(end[-1].patch, s->patch, s->to.tilt)))
        return RW_FRONTS_PART;
    return keeps_to_layer(s, end->ratio, tilt_rate(s, s->patch, end->patch)) ? RW_NO_OBSTACLE
                                                                             : RW_SLIPS_BOTH_WAYS;
}

/* A moment of the step. */
typedef struct {
    double t;
    rw_patch contact;
    rw_departure front;
    bool is_known;  /* the front; otherwise it may be in different layers at the edges */
    rw_patch stuck; /* the last front that was known */
} station;

/* The beginning of the step: all sticks but a ring that slips this way already. */
static station first_station(const rw_step *s, int slip)
{
    const size_t count = s->memory->count;
    const rw_corner *end = rw_memory_end(s->memory);
    const bool has_slipped = end->ratio == slip;
    const rw_corner *front = has_slipped ? end - 1 : end;
    return (station){.t = 0,
                     .contact = end->patch,
                     .front = {*front, has_slipped ? count - 2 : count - 1, slip},
                     .is_known = true,
                     .stuck = front->patch};
}

/* The loads on the straight way to the new load, where `contact` is the patch of `load`. */
static rw_memory_loads loads_at(const rw_step *s, double t, double load, rw_patch contact)
{
    const rw_corner *end = rw_memory_end(s->memory);
    return (rw_memory_loads){.load = load,
                             .shear = end->shear + t * (s->to.shear - end->shear),
                             .tilt = s->is_held ? tilt_at(s, t)
                                                : rw_pressing_of(s->geometry, contact).tilt,
                             .stretch = end->stretch + t * (s->to.stretch - end->stretch)};
}

/* A later moment, whose front is not looked for yet. */
static station station_at(const rw_step *s, double t, const station *last)
{
    return (station){.t = t, .contact = t < 1 ? patch_at(s, t) : s->patch, .stuck = last->stuck};
}

static void find_front(const rw_step *s, int slip, station *at)
{
    const double P = s->from_P + at->t * (s->to_P - s->from_P);
    const rw_memory_loads loads = at->t < 1 ? loads_at(s, at->t, P, at->contact) : s->to;
    at->front = rw_memory_departure(s->memory, loads);
    at->is_known = at->front.slip == slip && front_is_known(s, loads, at->contact, &at->front);
    if (at->is_known)
        at->stuck = at->front.corner.patch;
}

/* Whether the front stays in its layer of slope D, behind the edges of the contact: S (dT - D dN)
 * adds to the traction everywhere. */
static bool stays_behind(const rw_step *s, const station *from, const station *to, range tilt_rate)
{
    if (!from->is_known || !to->is_known || from->front.kept != to->front.kept)
        return false;
    const rw_corner *end = rw_memory_end(s->memory);
    const double S = to->front.slip, D = s->memory->corners[to->front.kept].ratio;
    const double load = (s->to.shear - end->shear) - D * (s->to.load - end->load);
    const double stretch = s->to.stretch - end->stretch;
    const range tilt = {stretch - D * tilt_rate.least, stretch - D * tilt_rate.most};
    return adds_everywhere(S * rw_as_length(s->geometry, load), tilt, from->contact,
                           tilt_tolerance(s, s->to));
}

/* The obstacle between two moments, of which the front of the later one is found on the way. */
static rw_obstacle obstacle_between(const rw_step *s, int slip, const station *from, station *to)
{
    const rw_corner *end = rw_memory_end(s->memory);
    const rw_patch smaller = grows(s) ? from->contact : to->contact;
    const rw_patch larger = grows(s) ? to->contact : from->contact;
    const range rate = tilt_rate(s, smaller, larger);
    const double load = slip * (s->to.shear - end->shear) - (s->to.load - end->load);
    const double stretch = slip * (s->to.stretch - end->stretch);
    const range tilt = {stretch - rate.most, stretch - rate.least};
    if (!adds_everywhere(rw_as_length(s->geometry, load), tilt, larger, tilt_tolerance(s, s->to)))
        return RW_SLIPS_BOTH_WAYS;
    find_front(s, slip, to);
    if (grows(s) || rw_patch_is_nested(from->stuck, to->contact, s->to.tilt) ||
        stays_behind(s, from, to, rate))
        return RW_NO_OBSTACLE;
    return RW_FRONTS_PART;
}

/* A moving contact that slips: the step is divided until all of it is shown to slip one way. */
static rw_obstacle slipping_step(const rw_step *s, rw_departure *d)
{
    station from = first_station(s, d->slip);
    rw_obstacle obstacle = RW_NO_OBSTACLE;
    double length = 1;
    for (int i = 0; i < TRIES && from.t < 1; i++) {
        station to = station_at(s, fmin(1, from.t + length), &from);
        const rw_obstacle reason = obstacle_between(s, d->slip, &from, &to);
        if (reason == RW_NO_OBSTACLE)
            from = to;
        else
            obstacle = reason;
        length *= reason == RW_NO_OBSTACLE ? 2 : 0.5;
    }
    if (from.t < 1)
        return obstacle;
    *d = from.front;
    return from.is_known ? RW_NO_OBSTACLE : RW_FRONTS_PART;
}

static rw_obstacle moving_step(const rw_step *s, rw_departure *d)
{
    *d = rw_memory_departure(s->memory, s->to);
    if (d->slip != 0)
        return slipping_step(s, d);
    return grows(s) ? sticking_growth(s) : sticking_recession(s, d);
}

static bool is_constant(const rw_step *s)
{
    return s->to_P == s->from_P && (s->is_held ? turned(s) == 0 : s->to_M == s->from_M);
}

static rw_obstacle obstacle_of(const rw_step *s, rw_departure *departure)
{
    if (is_constant(s))
        return constant_step(s, departure);
    if (!edges_go_together(s))
        return RW_EDGES_PART;
    return moving_step(s, departure);
}

/* A contact that recedes and sticks may come to the last corner of its path, at both edges at once.
 * From there on the step is one of the shorter path, `rest`. */
static bool leaves_layer(const rw_step *s, rw_memory *shorter, rw_step *rest)
{
    const rw_corner *end = rw_memory_end(s->memory), *at = end - 1;
    if (grows(s) || s->memory->count < 3 || s->to.load >= fmin(at->load, end->load))
        return false;
    const double t = (end->load - at->load) / (end->load - s->to.load);
    rw_step part = *s;
    part.to_P = at->load;
    part.to_M = s->from_M + t * (s->to_M - s->from_M);
    part.patch = patch_of(s, part.to_P, part.to_M, tilt_at(s, t));
    part.to = loads_at(s, t, at->load, part.patch);
    rw_departure d;
    if (!rw_patch_is_nested(part.patch, at->patch, part.to.tilt) ||
        obstacle_of(&part, &d) != RW_NO_OBSTACLE || d.slip != 0)
        return false;
    *shorter = *s->memory;
    shorter->count--;
    *rest = *s;
    rest->memory = shorter;
    rest->from_P = part.to_P;
    rest->from_M = part.to_M;
    return true;
}

/* ---- A contact without a change of shear ---- */

/* The outer corner of the last layer that carries shear; the origin where none does. */
static size_t last_sheared(const rw_memory *memory, double tolerance)
{
    size_t i = memory->count - 1;
    double carried = 0;
    while (i > 0) {
        const rw_corner *corner = &memory->corners[i];
        carried += fabs(corner->ratio) * (corner->load - corner[-1].load);
        if (carried > tolerance)
            break;
        i--;
    }
    return i;
}

/* Whether the edges of the contact, which are outside of a patch at both ends of a step, stay there
 * all the way. Those of a held pad are farthest inwards at an end. */
static bool stays_outside(const rw_step *s, rw_patch patch)
{
    if (s->is_held)
        return true;
    const rw_corner *end = rw_memory_end(s->memory);
    const double tilt = fmax(fabs(s->to.tilt), fabs(end->tilt));
    const rw_arcs arcs = rw_arcs_of(s->geometry);
    const rw_turns turns = rw_arcs_turns(&arcs, end->patch, s->patch);
    bool is_outside = true;
    for (double t = rw_stop_before(&turns, 0, 1); t < 1; t = rw_stop_before(&turns, t, 1))
        is_outside &= rw_patch_is_nested(patch, patch_at(s, t), tilt);
    return is_outside;
}

/* Whether Q and the tension stay, and the contact keeps the last patch that carries shear. Then
 * nothing slips: the pressure there is never less than that patch's own. */
static bool keeps_sheared(const rw_step *s, rw_departure *d)
{
    const rw_memory *memory = s->memory;
    const rw_corner *end = rw_memory_end(memory);
    const double tolerance = rw_memory_tolerance(fmax(s->to.load, end->load));
    if (fabs(s->to.shear - end->shear) > tolerance || s->to.stretch != end->stretch)
        return false;
    const size_t i = last_sheared(memory, tolerance);
    const rw_patch sheared = memory->corners[i].patch;
    if (i > 0 && !(rw_patch_is_nested(sheared, s->patch, s->to.tilt) && stays_outside(s, sheared)))
        return false;
    *d = (rw_departure){.corner = rw_corner_at(s->to, s->patch), .kept = i + 1};
    return true;
}

rw_obstacle rw_path_departure(const rw_step *s, rw_departure *departure)
{
    if (s->to.load == 0 || (rw_is_symmetric(s->geometry) && rw_memory_is_plain(s->memory, s->to))) {
        *departure = rw_memory_departure(s->memory, s->to);
        return RW_NO_OBSTACLE;
    }
    const rw_obstacle reason = obstacle_of(s, departure);
    if (reason == RW_NO_OBSTACLE || is_sliding(s, s->to, s->to.shear < 0 ? -1 : 1, departure) ||
        keeps_sheared(s, departure))
        return RW_NO_OBSTACLE;
    rw_memory shorter;
    rw_step rest;
    return leaves_layer(s, &shorter, &rest) ? rw_path_departure(&rest, departure) : reason;
}

bool rw_path_separates_stuck(const rw_step *s)
{
    const rw_departure d = rw_memory_departure(s->memory, s->to);
    return sticking_recession(s, &d) == RW_NO_OBSTACLE;
}
