/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The step to the next loads: whether they are allowed, and where they lead. */
#include "loading/step_to.h"

#include "base/domain.h"
#include "formulas/pressure.h"

#include <float.h>

/* How far Q may exceed f P, over f times a load: Q, f, P and f P are each rounded. Where a caller
 * interpolates between two loads, the rounding is that of the larger load, which may be many steps
 * back: the largest since the contact slides. */
static const double SLIDING_ROUNDING = 8 * DBL_EPSILON;

/* The new load P over the last one is not less. At this ratio the rounding of the last load changes
 * Q/(fP) by 2e-7 of it, and below it by more. */
static const double STEEPEST_FALL = 1e-8;

/* The shear T = Q/f; exactly +-P where Q is at the limit of friction, to rounding. */
static int32_t shear_of(const rwedge_contact *contact, double P, double Q, double *shear)
{
    const double slid = contact->phase == RW_SLIDING ? contact->sliding.largest_load : 0;
    const double limit = contact->f * P, magnitude = fabs(Q);
    const double last = fmax(rw_memory_end(&contact->memory)->load, slid);
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

/* The moment under which a contact has its tilt. */
static double moment_of(const rw_geometry *g, double P, rw_patch patch, double tilt)
{
    if (P == 0 || (tilt == 0 && rw_is_symmetric(g)))
        return 0;
    const rw_pressing carried = rw_pressing_of(g, patch);
    return carried.moment / carried.load * P;
}

/* Whether P and M stay, to rounding, or P and the tilt of a held pad. The contact then keeps the
 * loads of the path's end: otherwise many small steps could shift them unnoticed. */
static bool is_same_pressing(const rwedge_contact *contact, rw_goal to)
{
    const rw_corner *end = rw_memory_end(&contact->memory);
    const double arm = fmax(fabs(end->patch.left), fabs(end->patch.right));
    if (contact->is_held)
        return end->load > 0 && to.turn == contact->held_tilt &&
               fabs(to.P - contact->loads.P) <= rw_memory_tolerance(end->load);
    return fabs(to.P - contact->loads.P) <= rw_memory_tolerance(end->load) &&
           fabs(to.turn - contact->loads.M) <= rw_memory_tolerance(end->load) * arm;
}

/* The tilt of the contact under the loads; NaN where there is none. */
static double tilt_of(const rw_geometry *g, rw_goal to, rw_patch patch)
{
    if (to.P == 0 || (to.turn == 0 && rw_is_symmetric(g)))
        return 0;
    return isnan(patch.left) ? NAN : rw_pressing_of(g, patch).tilt;
}

/* How unlike bodies slide under the new load. */
static rw_sliding_way way_to(const rwedge_contact *contact, const rw_step *step)
{
    return (rw_sliding_way){contact->unlike, step->to.shear < 0 ? -1 : 1};
}

static void press_unlike(const rwedge_contact *contact, rw_goal to, rw_step *step)
{
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const rw_sliding_way slides = way_to(contact, step);
    const double P = rw_as_length(&contact->geometry, to.P);
    step->patch = contact->is_held
                      ? rw_sliding_patch_of_tilt(&arcs, slides, P, to.turn)
                      : rw_sliding_patch_of_moment(&arcs, slides, P,
                                                   rw_as_length(&contact->geometry, to.turn));
    rw_pressing carried = {NAN, NAN, NAN};
    if (!isnan(step->patch.left))
        carried = rw_sliding_pressing(&arcs, slides, step->patch);
    step->to.tilt = contact->is_held ? to.turn : carried.tilt;
    if (contact->is_held)
        step->to_M = carried.moment / carried.load * to.P;
}

static void press_similar(const rwedge_contact *contact, rw_goal to, rw_step *step)
{
    const rw_geometry *g = &contact->geometry;
    step->patch = contact->is_held ? rw_patch_under_tilt(g, to.P, to.turn)
                                   : rw_patch_under_moment(g, to.P, to.turn);
    step->to.tilt = contact->is_held ? to.turn : tilt_of(g, to, step->patch);
    if (contact->is_held)
        step->to_M = moment_of(g, to.P, step->patch, to.turn);
}

bool rw_slides_at_end(const rw_step *step)
{
    return fabs(step->to.shear) >= step->to.load;
}

/* The step to the loads in the units of the memory, and the patch that it leads to. */
static int32_t make_step(const rwedge_contact *contact, rw_goal to, rw_step *step)
{
    const rw_geometry *g = &contact->geometry;
    const rw_corner *end = rw_memory_end(&contact->memory);
    *step = (rw_step){.geometry = g,
                      .memory = &contact->memory,
                      .is_held = contact->is_held,
                      .from_P = contact->loads.P,
                      .from_M = contact->loads.M,
                      .to_P = to.P,
                      .to_M = to.turn,
                      .to = {.load = to.P}};
    const int32_t status = shear_of(contact, to.P, to.Q, &step->to.shear);
    if (status != RWEDGE_OK)
        return status;
    step->to.stretch = rw_contact_stretch(contact, to.sigma);
    const bool slides = contact->unlike && rw_slides_at_end(step);
    const bool turns = slides && (contact->phase != RW_SLIDING ||
                                  way_to(contact, step).way != rw_contact_way(contact).way);
    if (!turns && is_same_pressing(contact, to) &&
        (to.turn != 0 || !rw_memory_is_plain(&contact->memory, step->to))) {
        step->to_P = step->from_P;
        step->to_M = step->from_M;
        step->to.load = end->load;
        step->to.tilt = end->tilt;
        step->patch = end->patch;
        return RWEDGE_OK;
    }
    if (slides && to.P > 0)
        press_unlike(contact, to, step);
    else
        press_similar(contact, to, step);
    if (g->reach > 0 && isgreater(fmax(-step->patch.left, step->patch.right), g->reach))
        return RWEDGE_ERANGE;
    return RWEDGE_OK;
}

static int32_t check(const rwedge_contact *contact, rw_goal to)
{
    if (!rw_is_magnitude(to.P) || !rw_is_signed(to.turn) || !rw_is_signed(to.Q) ||
        !rw_is_signed(to.sigma) || (to.P == 0 && to.turn != 0 && !contact->is_held))
        return RWEDGE_EDOMAIN;
    if (to.P > 0 && (!is_in_range(&contact->geometry, to.P) ||
                     to.P < STEEPEST_FALL * rw_memory_end(&contact->memory)->load))
        return RWEDGE_ERANGE;
    return RWEDGE_OK;
}

bool rw_has_width(rw_patch patch)
{
    return !isgreaterequal(patch.left, patch.right);
}

/* Where a flank lies on the surface, to rounding, the contact has no definite edge there. */
static bool is_tilt_possible(const rw_step *step)
{
    return isless(fabs(step->to.tilt), RW_LARGEST_TILT);
}

int32_t rw_step_to(const rwedge_contact *contact, rw_goal to, rw_step *step)
{
    int32_t status = check(contact, to);
    if (status == RWEDGE_OK)
        status = make_step(contact, to, step);
    if (status != RWEDGE_OK || to.P == 0)
        return status;
    return !is_tilt_possible(step)      ? RWEDGE_EDOMAIN
           : !rw_has_width(step->patch) ? RWEDGE_ERANGE
                                        : RWEDGE_OK;
}

rw_patch rw_contact_patch_under(const rwedge_contact *contact, rw_goal to)
{
    rw_step step;
    return rw_step_to(contact, to, &step) == RWEDGE_OK && to.P > 0 ? step.patch
                                                                   : (rw_patch){NAN, NAN};
}

rw_obstacle rw_contact_obstacle(const rwedge_contact *contact, rw_loads to)
{
    rw_step step;
    rw_departure departure;
    if (contact->f == 0 || rw_step_to(contact, rw_goal_of(contact, to), &step) != RWEDGE_OK)
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
