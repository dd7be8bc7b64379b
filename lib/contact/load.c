/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load of a contact: whether it is allowed, and what it does. */
#include "contact/numerical.h"
#include "history/dissipation.h"

#include <float.h>

/* How far Q may exceed f P, over f times a load: Q, f, P and f P are each rounded. Where a caller
 * interpolates between two loads, the rounding is that of the larger load, which may be many steps
 * back: the largest since the contact slides. */
static const double SLIDING_ROUNDING = 8 * DBL_EPSILON;

/* The new load P over the last one is not less. At this ratio the rounding of the last load changes
 * Q/(fP) by 2e-7 of it, and below it by more. */
static const double STEEPEST_FALL = 1e-8;

/* Of the tilt over theta: closer to 1 the edges are lost in rounding. */
static const double LARGEST_TILT = 1 - 1e-9;

/* The shear T = Q/f; exactly +-P where Q is at the limit of friction, to rounding. */
static int32_t shear_of(const rwedge_contact *contact, double P, double Q, double *shear)
{
    const double limit = contact->f * P, magnitude = fabs(Q);
    const double last = fmax(rw_memory_end(&contact->memory)->load, contact->slid_from);
    const double largest = fmax(P, fmin(last, P / STEEPEST_FALL));
    const double rounding = SLIDING_ROUNDING * contact->f * largest;
    if (magnitude > limit + rounding)
        return RWEDGE_ESLIDING;
    if (magnitude >= limit - rounding)
        *shear = Q > 0 ? P : Q < 0 ? -P : 0;
    else
        *shear = Q / limit * P;
    return RWEDGE_OK;
}

/* Whether lengths and pressures stay in the domain. */
static bool is_in_range(const rw_geometry *g, double P)
{
    if (g->pad)
        return rw_is_positive(rw_as_length(g, P));
    const double b = rw_half_width(g, P);
    if (!rw_is_contact_size(g, b))
        return false;
    return g->a == 0 || rw_is_positive(rw_unit_stress(g) * rwedge_peak_pressure(g->a / b));
}

/* Gives new corners their patches: the last corner is the contact itself. */
static void measure_new_corners(rwedge_contact *contact, const rw_step *step)
{
    rw_memory *memory = &contact->memory;
    for (size_t i = memory->count; i-- > 1 && isnan(memory->corners[i].patch.left);) {
        rw_corner *corner = &memory->corners[i];
        corner->patch = corner->load == step->to.load
                            ? step->patch
                            : rw_patch_under_tilt(&contact->geometry, corner->load, corner->tilt);
    }
}

/* Whether P and M stay, to rounding. The contact then keeps the loads of the path's end: otherwise
 * many small steps could shift them unnoticed. */
static bool is_same_pressing(const rwedge_contact *contact, rw_loads to)
{
    const rw_corner *end = rw_memory_end(&contact->memory);
    const double arm = fmax(fabs(end->patch.left), fabs(end->patch.right));
    return fabs(to.P - contact->loads.P) <= rw_memory_tolerance(end->load) &&
           fabs(to.M - contact->loads.M) <= rw_memory_tolerance(end->load) * arm;
}

/* The tilt of the contact under the loads; NaN where there is none. */
static double tilt_of(const rw_geometry *g, rw_loads loads, rw_patch patch)
{
    if (loads.P == 0 || (loads.M == 0 && rw_is_symmetric(g)))
        return 0;
    return isnan(patch.left) ? NAN : rw_pressing_of(g, patch).tilt;
}

/* The step to the loads in the units of the memory, and the patch that it leads to. */
static int32_t make_step(const rwedge_contact *contact, rw_loads to, rw_step *step)
{
    const rw_geometry *g = &contact->geometry;
    const rw_corner *end = rw_memory_end(&contact->memory);
    *step = (rw_step){.geometry = g,
                      .memory = &contact->memory,
                      .from_P = contact->loads.P,
                      .from_M = contact->loads.M,
                      .to_P = to.P,
                      .to_M = to.M,
                      .to = {.load = to.P}};
    const int32_t status = shear_of(contact, to.P, to.Q, &step->to.shear);
    if (status != RWEDGE_OK)
        return status;
    step->to.stretch = rw_contact_stretch(contact, to.sigma);
    if (is_same_pressing(contact, to) &&
        (to.M != 0 || !rw_memory_is_plain(&contact->memory, step->to))) {
        step->to_P = step->from_P;
        step->to_M = step->from_M;
        step->to.load = end->load;
        step->to.tilt = end->tilt;
        step->patch = end->patch;
        return RWEDGE_OK;
    }
    step->patch = rw_patch_under_moment(g, to.P, to.M);
    if (g->reach > 0 && isgreater(fmax(-step->patch.left, step->patch.right), g->reach))
        return RWEDGE_ERANGE;
    step->to.tilt = tilt_of(g, to, step->patch);
    return RWEDGE_OK;
}

static int32_t check(const rwedge_contact *contact, rw_loads to)
{
    if (!rw_is_magnitude(to.P) || !rw_is_signed(to.M) || !rw_is_signed(to.Q) ||
        !rw_is_signed(to.sigma) || (to.P == 0 && to.M != 0))
        return RWEDGE_EDOMAIN;
    if (to.P > 0 && (!is_in_range(&contact->geometry, to.P) ||
                     to.P < STEEPEST_FALL * rw_memory_end(&contact->memory)->load))
        return RWEDGE_ERANGE;
    return RWEDGE_OK;
}

/* Rounding may put both edges at one place. A patch of NaN is not known yet, and counts as wide. */
static bool has_width(rw_patch patch)
{
    return !isgreaterequal(patch.left, patch.right);
}

/* Where a flank lies on the surface, to rounding, the contact has no definite edge there. */
static bool is_tilt_possible(const rw_step *step)
{
    return isless(fabs(step->to.tilt), LARGEST_TILT);
}

/* The step to the loads, if they are allowed. */
static int32_t prepare(const rwedge_contact *contact, rw_loads to, rw_step *step)
{
    int32_t status = check(contact, to);
    if (status == RWEDGE_OK)
        status = make_step(contact, to, step);
    if (status != RWEDGE_OK || to.P == 0)
        return status;
    return !is_tilt_possible(step)   ? RWEDGE_EDOMAIN
           : !has_width(step->patch) ? RWEDGE_ERANGE
                                     : RWEDGE_OK;
}

/* Whether slip reaches all of the path. */
static bool slides(const rw_departure *departure)
{
    return departure->slip != 0 && departure->corner.load == 0;
}

/* The bodies touch. The tension is that of the load before. */
static void touch(rwedge_contact *contact, double sigma)
{
    contact->touched_at = sigma;
    if (isnan(contact->energy_carry))
        contact->energy_carry = 0;
}

static void go(rwedge_contact *contact, const rw_loads *to, const rw_step *step,
               const rw_departure *departure)
{
    rw_memory *memory = &contact->memory;
    if (memory->count == 1) {
        touch(contact, contact->loads.sigma);
        memory->corners[0].tilt = step->to.tilt;
    }
    contact->loads = (rw_loads){step->to_P, step->to_M, to->Q, to->sigma};
    if (contact->f == 0)
        rw_memory_restart(memory, step->to, 0);
    else if (slides(departure))
        rw_memory_restart(memory, step->to, departure->slip);
    else
        rw_memory_advance(memory, departure, step->to);
    if (memory->count == 1) {
        memory->corners[0].tilt = 0;
        memory->corners[0].stretch = step->to.stretch;
    }
    measure_new_corners(contact, step);
    contact->slid_from = rw_memory_slides(memory) ? fmax(contact->slid_from, step->to.load) : 0;
}

/* The carry may be negative. */
static void add_energy(rwedge_contact *contact, double share)
{
    const double more = contact->energy_carry + share, before = contact->energy;
    contact->energy = isnan(more) ? before : fmax(before, before + more);
    contact->energy_carry = more - (contact->energy - before);
}

static bool is_off_centre(const rwedge_contact *contact, const rw_step *step)
{
    return contact->f > 0 && step->to.load > 0 &&
           (contact->was_off_centre || !rw_memory_is_plain(&contact->memory, step->to));
}

/* What has been in contact since the first slip. */
static rw_patch settled_part(const rwedge_contact *contact)
{
    const rw_slip_origins *origins = &contact->origins;
    const rw_corner *end = rw_memory_end(&contact->memory);
    if (contact->was_off_centre)
        return contact->numerical || origins->count > 0 ? contact->settled : end->patch;
    const double load =
        origins->count > 0 ? fmin(origins->all[0].end, origins->all[0].from_load) : end->load;
    return load == end->load ? end->patch : rw_patch_under_tilt(&contact->geometry, load, 0);
}

/* Off the centre the slip is known while one origin (slip_origin.h) serves all points that slipped:
 * they were in contact before the first slip, and no later point slips. */
static bool keeps_origin(const rwedge_contact *contact, const rw_step *step, int slip)
{
    const rw_slip_origins *origins = &contact->origins;
    const rw_patch from = rw_memory_end(&contact->memory)->patch;
    if (!contact->is_origin_known || origins->count > 1 ||
        (origins->count > 0 && origins->all[0].to_load > origins->all[0].from_load))
        return false;
    if (slip == 0)
        return true;
    if (origins->count == 0)
        return rw_patch_is_nested(step->patch, from, step->to.tilt);
    const rw_patch settled = settled_part(contact);
    return rw_patch_is_nested(from, settled, step->to.tilt) &&
           rw_patch_is_nested(step->patch, settled, step->to.tilt);
}

/* The part of a patch inside of another. */
static rw_patch common_part(rw_patch a, rw_patch b)
{
    return (rw_patch){fmax(a.left, b.left), fmin(a.right, b.right)};
}

/* The energy of a step; never negative, NaN where there is no single integral for it. */
static double share_of(const rwedge_contact *contact, const rw_step *step,
                       const rw_departure *departure)
{
    const rw_geometry *g = &contact->geometry;
    const rw_memory *memory = &contact->memory;
    const double f = contact->f;
    if (f == 0)
        return 0;
    if (rw_is_symmetric(g) && rw_memory_is_plain(memory, step->to))
        return f * g->A * (f / RW_PI * fmax(0, rw_dissipation(memory, step->to, g)));
    if (step->to.load == 0)
        return memory->count == 1 || rw_path_separates_stuck(step) ? 0 : NAN;
    if (departure->slip == 0)
        return 0;
    if (step->to_P != step->from_P || slides(departure))
        return NAN;
    return f * g->theta * (f * g->theta / g->A) * rw_edge_work(memory, departure, g);
}

/* Whether the closed form of a step leaves the slip unknown, though it could be computed. */
static bool loses_slip(const rwedge_contact *contact, const rw_step *step,
                       const rw_departure *departure)
{
    return is_off_centre(contact, step) && !slides(departure) &&
           !keeps_origin(contact, step, departure->slip);
}

static int32_t go_on(rwedge_contact *contact, rw_loads to, const rw_step *step,
                     const rw_departure *departure, double share)
{
    const bool off_centre = is_off_centre(contact, step), is_separated = step->to.load == 0;
    const bool is_sliding = slides(departure);
    const bool keeps = keeps_origin(contact, step, departure->slip) && !is_sliding;
    const rw_patch settled = settled_part(contact);
    if (isgreater(contact->energy + share, RW_LARGEST))
        return RWEDGE_ERANGE;
    if (!rw_memory_reserve(&contact->memory, 2) ||
        !rw_slip_origins_advance(&contact->origins, &contact->memory, departure->slip != 0,
                                 step->to.load, step->to.shear))
        return RWEDGE_ENOMEM;
    go(contact, &to, step, departure);
    add_energy(contact, share);
    contact->was_off_centre = off_centre;
    if (off_centre)
        contact->settled = common_part(settled, step->patch);
    if (off_centre || is_separated || is_sliding)
        contact->is_origin_known = keeps || is_separated;
    return RWEDGE_OK;
}

/* ---- Without a closed form ---- */

static int32_t go_numerically(rwedge_contact *contact, rw_loads to, const rw_step *step)
{
    double share;
    const bool touches = contact->memory.count == 1;
    const double before = contact->loads.sigma;
    const rw_patch settled = touches ? step->patch : settled_part(contact);
    const int32_t status = rw_numerical_go(contact, step, &share);
    if (status != RWEDGE_OK)
        return status;
    if (touches)
        touch(contact, before);
    contact->loads = to;
    contact->slid_from = 0;
    contact->was_off_centre = true;
    contact->settled = common_part(settled, step->patch);
    contact->is_origin_known = contact->numerical->has_origin;
    add_energy(contact, share);
    return RWEDGE_OK;
}

/* Separation and full sliding end the computed shear: what follows is in closed form again. */
static int32_t leave_shear(rwedge_contact *contact, rw_loads to, const rw_step *step)
{
    const bool separates = step->to.load == 0;
    double work = NAN;
    int32_t status = separates ? rw_numerical_energy_to_separation(contact, &work) : RWEDGE_OK;
    if (status != RWEDGE_OK)
        return status;
    const rw_departure departure = {contact->memory.corners[0], 1,
                                    separates            ? 0
                                    : step->to.shear < 0 ? -1
                                                         : 1};
    status = go_on(contact, to, step, &departure, work);
    if (status == RWEDGE_OK)
        rw_numerical_end(contact);
    return status;
}

static int32_t apply_numerically(rwedge_contact *contact, rw_loads to)
{
    rw_step step;
    const int32_t status = prepare(contact, to, &step);
    if (status != RWEDGE_OK)
        return status;
    if (contact->numerical && (to.P == 0 || fabs(step.to.shear) >= step.to.load))
        return leave_shear(contact, to, &step);
    return contact->tolerance > 0 ? go_numerically(contact, to, &step) : RWEDGE_EPATH;
}

/* ---- With a closed form ---- */

/* The straight line as one step. */
static int32_t apply_whole(rwedge_contact *contact, rw_loads to)
{
    rw_step step;
    const int32_t status = prepare(contact, to, &step);
    if (status != RWEDGE_OK)
        return status;
    rw_departure departure = {.corner = {0}};
    if (contact->f > 0 && rw_path_departure(&step, &departure) != RW_NO_OBSTACLE)
        return RWEDGE_EPATH;
    if (departure.slip != 0 && !slides(&departure) && !has_width(departure.corner.patch))
        return RWEDGE_ERANGE;
    if (contact->follows_slip && loses_slip(contact, &step, &departure))
        return RWEDGE_EPATH;
    return go_on(contact, to, &step, &departure, share_of(contact, &step, &departure));
}

/* A line that has no closed form as one step may have one in pieces. */
enum { MOST_PIECES = 40 };
static const double SHORTEST_PIECE = 1.0 / 256;

/* Each piece is tried to the end of the line, and then at ever shorter lengths. */
static int32_t apply_in_pieces(rwedge_contact *contact, rw_loads to)
{
    const rw_loads from = contact->loads;
    double t = 0, next = 0.5;
    for (int i = 0; i < MOST_PIECES && t < 1 && next - t >= SHORTEST_PIECE; i++) {
        if (apply_whole(contact, rw_loads_between(from, to, next)) == RWEDGE_OK) {
            t = next;
            next = 1;
        } else
            next = t / 2 + next / 2;
    }
    return t == 1 ? RWEDGE_OK : RWEDGE_EPATH;
}

/* The straight line from the last closed form to these loads may have a closed form. If all places
 * that have slipped since slip on that line too, to the same fronts, it ends in the same state: the
 * places that stick have moved on neither way. */
static void return_to_closed_form(rwedge_contact *contact)
{
    rwedge_contact *exact;
    if (!rw_numerical_is_passed(contact) ||
        rwedge_contact_copy(contact->exact, &exact) != RWEDGE_OK)
        return;
    exact->tolerance = contact->tolerance;
    if (apply_whole(exact, contact->loads) == RWEDGE_OK && rw_numerical_agrees(contact, exact)) {
        exact->energy = contact->energy;
        exact->energy_carry = contact->energy_carry;
        rw_contact_exchange(contact, exact);
    }
    rwedge_contact_destroy(exact);
}

static int32_t apply_to_numerical(rwedge_contact *contact, rw_loads to)
{
    const int32_t status = apply_numerically(contact, to);
    if (status == RWEDGE_OK)
        return_to_closed_form(contact);
    return status;
}

static int32_t apply(rwedge_contact *contact, rw_loads to)
{
    rw_contact_drop_kept(contact);
    if (contact->numerical)
        return apply_to_numerical(contact, to);
    const int32_t status = apply_whole(contact, to);
    if (status != RWEDGE_EPATH)
        return status;
    if (contact->loads.P == 0)
        return apply_numerically(contact, to);
    rwedge_contact *trial;
    if (rwedge_contact_copy(contact, &trial) != RWEDGE_OK)
        return RWEDGE_ENOMEM;
    const int32_t in_pieces = apply_in_pieces(trial, to);
    if (in_pieces == RWEDGE_OK)
        rw_contact_exchange(contact, trial);
    rwedge_contact_destroy(trial);
    return in_pieces == RWEDGE_EPATH ? apply_numerically(contact, to) : in_pieces;
}

int32_t rwedge_contact_apply(rwedge_contact *contact, double P, double M, double Q, double sigma)
{
    return contact ? apply(contact, (rw_loads){P, M, Q, sigma}) : RWEDGE_ENULL;
}

int32_t rwedge_contact_load(rwedge_contact *contact, double P, double Q)
{
    if (!contact)
        return RWEDGE_ENULL;
    return apply(contact, (rw_loads){P, P == 0 ? 0 : contact->loads.M, Q, contact->loads.sigma});
}

rw_patch rw_contact_patch_under(const rwedge_contact *contact, rw_loads to)
{
    rw_step step;
    return prepare(contact, to, &step) == RWEDGE_OK && to.P > 0 ? step.patch : (rw_patch){NAN, NAN};
}

rw_obstacle rw_contact_obstacle(const rwedge_contact *contact, rw_loads to)
{
    rw_step step;
    rw_departure departure;
    if (contact->f == 0 || prepare(contact, to, &step) != RWEDGE_OK)
        return RW_NO_OBSTACLE;
    return rw_path_departure(&step, &departure);
}

double rwedge_contact_largest_tension_step(const rwedge_contact *contact, double Q)
{
    if (!contact || !rw_is_signed(Q))
        return NAN;
    const double s = rwedge_contact_half_width(contact);
    if (contact->f == 0 || contact->strain == 0)
        return HUGE_VAL;
    return s > 0 ? 4 * fabs(Q - contact->loads.Q) / (RW_PI * s) / contact->strain : 0;
}
