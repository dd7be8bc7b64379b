/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load of a contact: whether it is allowed, and what it does. */
#include "history/contact.h"
#include "history/dissipation.h"
#include "history/off_centre.h"

#include <float.h>

/* How far Q may exceed f P: Q, f and P are each rounded, and so is their product; where a caller
 * interpolates between two loads, they are rounded like the larger. */
static const double SLIDING_ROUNDING = 8 * DBL_EPSILON;

/* Of the load in one step: beyond, the rounding of the last load would be seen in what Q/(fP)
 * is, 2e-7 of it here. */
static const double STEEPEST_FALL = 1e-8;

/* Loads that an arithmetic of squares and ratios can hold, a width that a search of the
 * half-plane can multiply, and a stress of which tensors can be summed. */
static const double SMALLEST_LOAD = 1e-148, LARGEST_LOAD = 1e148, LARGEST_WIDTH = 1e300,
                    LARGEST_STRESS = 1e300;

/* Peak pressure of the sharp wedge in theta/A, as near to its apex as is_apex() allows: (2/pi)
 * arcosh(1/DBL_MIN). */
static const double SHARP_PEAK = 452;

/* Of the tilt over theta: closer to 1 the edges are not to be told from rounding. */
static const double LARGEST_TILT = 1 - 1e-9;

/* Q/f, at friction's limit exactly. */
static int32_t shear_of(const rwedge_contact *contact, double P, double Q, double *shear)
{
    const double limit = contact->f * P, magnitude = fabs(Q);
    const double last = rw_memory_end(&contact->memory)->load;
    const double rounding = P > 0 ? SLIDING_ROUNDING * contact->f * fmax(P, last) : 0;
    if (magnitude > limit + rounding)
        return RWEDGE_ESLIDING;
    if (magnitude >= limit - rounding)
        *shear = Q > 0 ? P : Q < 0 ? -P : 0;
    else
        *shear = Q / limit * P;
    return RWEDGE_OK;
}

/* Whether the peak pressure is a normal number, and friction's traction under it not too large. */
static bool is_pressure_in_range(const rwedge_contact *contact, double b)
{
    const rw_geometry *g = &contact->geometry;
    const double peak = g->a > 0 ? rwedge_peak_pressure(g->a / b) : SHARP_PEAK;
    const rw_scaled pressure = rw_scaled_times(rw_unit_stress(g), rw_scaled_from(peak));
    const double traction =
        rw_scaled_value(rw_scaled_times(pressure, rw_scaled_from(fmax(1, contact->f))));
    /* it may be NaN */
    return rw_scaled_is_normal(pressure) && islessequal(traction, LARGEST_STRESS);
}

/* Whether lengths and stresses under the load stay far from the ends of the range of a double;
 * next to an a/b that underflows to 0 the apex of the sharp wedge would appear. */
static bool is_in_range(const rwedge_contact *contact, double P)
{
    const rw_geometry *g = &contact->geometry;
    const double b = rw_half_width(g, P);
    return P >= SMALLEST_LOAD && P <= LARGEST_LOAD && isnormal(b) && b <= LARGEST_WIDTH &&
           rw_patch_matters(b, g->a) && (g->a == 0 || rw_quotient_is_normal(g->a, b)) &&
           is_pressure_in_range(contact, b);
}

/* The load (pi/2) a theta/A under which the rounding is just filled, over 2^doublings. */
static double corner_load_of(const rw_geometry *g, int doublings)
{
    if (g->a == 0)
        return 0;
    const rw_scaled width = rw_scaled_times(rw_scaled_from(RW_HALF_PI), rw_scaled_from(g->a));
    rw_scaled load = rw_scaled_times(width, rw_unit_stress(g));
    load.exponent -= doublings;
    /* where all is Hertz, whatever it is */
    return load.exponent > 1000 ? 1e300 : rw_scaled_value(load);
}

/* NaN where it is too large for a double. */
static double energy_of(const rwedge_contact *contact, double P, double shear)
{
    const double largest = fmax(P, rw_memory_end(&contact->memory)->load);
    if (contact->f == 0 || largest == 0)
        return 0;
    const int doublings = ilogb(largest);
    const double in_units = rw_dissipation(&contact->memory, P, shear, rw_power_of_two(doublings),
                                           corner_load_of(&contact->geometry, doublings));
    if (!(in_units > 0))
        return 0;
    const rw_scaled f = rw_scaled_from(contact->f),
                    f_over_pi = rw_scaled_over(f, rw_scaled_from(RW_PI));
    const rw_scaled factor = rw_scaled_times(f, rw_scaled_from(contact->geometry.A));
    rw_scaled energy =
        rw_scaled_times(factor, rw_scaled_times(f_over_pi, rw_scaled_from(in_units)));
    energy.exponent += 2 * doublings;
    return rw_scaled_value(energy);
}

static void measure_new_corners(rwedge_contact *contact)
{
    rw_memory *memory = &contact->memory;
    for (size_t i = memory->count; i-- > 1 && isnan(memory->corners[i].patch.left);)
        memory->corners[i].patch = rw_patch_under_tilt(
            &contact->geometry, memory->corners[i].load, memory->corners[i].tilt);
}

/* Differences of rounding in P and M are none. */
static bool is_same_pressing(const rwedge_contact *contact, rw_loads to)
{
    const rw_corner *end = rw_memory_end(&contact->memory);
    const double arm = fmax(fabs(end->patch.left), fabs(end->patch.right));
    return fabs(to.P - contact->loads.P) <= rw_memory_tolerance(end->load) &&
           fabs(to.M - contact->loads.M) <= rw_memory_tolerance(end->load) * arm;
}

/* What the loads are to the memory, and to the contact. */
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
    /* 0 first: A sigma/(4 theta f) of no friction is none */
    step->to.stretch = contact->f > 0 ? -(g->A / g->theta) * to.sigma / (4 * contact->f) : 0;
    if (!isfinite(step->to.stretch))
        return RWEDGE_ERANGE;
    step->patch = rw_patch_under_moment(g, to.P, to.M);
    step->to.tilt = to.M != 0 ? rw_patch_pressing(g->a, step->patch).tilt : 0;
    if (is_same_pressing(contact, to) && !rw_path_is_plain(&contact->memory, step->to)) {
        step->to_P = step->from_P;
        step->to_M = step->from_M;
        step->to.load = end->load;
        step->to.tilt = end->tilt;
        step->patch = end->patch;
    }
    return RWEDGE_OK;
}

static int32_t check(const rwedge_contact *contact, rw_loads to)
{
    if (!rw_is_nonnegative(to.P) || !isfinite(to.M) || !isfinite(to.Q) || !isfinite(to.sigma) ||
        (to.P == 0 && to.M != 0))
        return RWEDGE_EDOMAIN;
    if (to.P > 0 &&
        (!is_in_range(contact, to.P) || to.P < STEEPEST_FALL * rw_memory_end(&contact->memory)->load))
        return RWEDGE_ERANGE;
    return RWEDGE_OK;
}

/* A flank that lies on the surface, to rounding, has no edge to tell. */
static bool is_tilt_possible(const rw_step *step)
{
    return step->to.load == 0 || (isfinite(step->patch.left) && fabs(step->to.tilt) < LARGEST_TILT);
}

/* The energy of a step off the centre, which has led from `before` to the present memory: NaN where
 * there is no single integral for it. */
static double share_off_centre(const rwedge_contact *contact, const rw_memory *before,
                               const rw_step *step, int slip)
{
    const rw_geometry *g = &contact->geometry;
    const rw_memory *after = &contact->memory;
    if (slip == 0)
        return 0;
    const bool slides = after->count == 2 && slip != 0;
    if (step->to_P != step->from_P || step->to_M != step->from_M || slides)
        return NAN;
    return contact->f * g->theta * (contact->f * g->theta / g->A) *
           rw_annuli_work(before, after, g->a);
}

static void go(rwedge_contact *contact, const rw_loads *to, const rw_step *step,
               const rw_departure *departure)
{
    rw_memory *memory = &contact->memory;
    if (memory->count == 1)
        contact->touched_at = contact->loads.sigma;
    contact->loads = *to;
    if (memory->count == 1) /* it touches */
        memory->corners[0].tilt = step->to.tilt;
    if (contact->f == 0)
        rw_memory_restart(memory, step->to, 0);
    else if (departure->slip != 0 && departure->corner.load == 0 && departure->kept == 1)
        rw_memory_restart(memory, step->to, departure->slip); /* it slides */
    else
        rw_memory_advance(memory, departure, step->to);
    if (memory->count == 1) {
        memory->corners[0].tilt = 0;
        memory->corners[0].stretch = step->to.stretch;
    }
    measure_new_corners(contact);
}

static int32_t go_centred(rwedge_contact *contact, rw_loads to, const rw_step *step,
                          const rw_departure *departure)
{
    const double load = step->to.load, shear = step->to.shear;
    const double share = energy_of(contact, load, shear) + contact->energy_carry;
    const bool is_known = !isnan(contact->energy);
    if (!isfinite(share) || (is_known && contact->energy / 2 + share / 2 > DBL_MAX / 2))
        return RWEDGE_ERANGE;
    /* the carry may be negative */
    const double energy =
        is_known ? fmax(contact->energy, contact->energy + share) : contact->energy;
    if (!rw_memory_reserve(&contact->memory, 2) ||
        !rw_slip_origins_advance(&contact->origins, &contact->memory, departure->slip != 0, load,
                                 shear))
        return RWEDGE_ENOMEM;
    go(contact, &to, step, departure);
    contact->energy_carry = is_known ? share - (energy - contact->energy) : 0;
    contact->energy = energy;
    if (load == 0) {
        contact->was_off_centre = false;
        contact->is_origin_known = true;
    }
    return RWEDGE_OK;
}

static bool is_off_centre(const rwedge_contact *contact, const rw_step *step)
{
    return contact->f > 0 && step->to.load > 0 &&
           (contact->was_off_centre || !rw_path_is_plain(&contact->memory, step->to)) &&
           !(contact->memory.count == 1 && step->to.tilt == 0);
}

/* One origin serves for all points where they were in contact before the first slip, and none came
 * after it. */
static bool keeps_origin(const rwedge_contact *contact, const rw_step *step, int slip)
{
    const rw_slip_origins *origins = &contact->origins;
    const double last = rw_memory_end(&contact->memory)->load;
    if (!contact->is_origin_known || origins->count > 1)
        return false;
    if (origins->count == 1 && origins->all[0].to_load > origins->all[0].from_load)
        return false;
    const bool grew = fmax(last, step->to.load) > (origins->count == 1 ? origins->fresh : last);
    return slip == 0 || !grew;
}

static int32_t go_off_centre(rwedge_contact *contact, rw_loads to, const rw_step *step,
                             const rw_departure *departure)
{
    const int slip = departure->slip;
    rw_memory before;
    if (!rw_memory_copy(&contact->memory, &before))
        return RWEDGE_ENOMEM;
    const bool is_known = keeps_origin(contact, step, slip);
    const bool is_plain = rw_path_is_plain(&before, step->to);
    const double plain_share = is_plain ? energy_of(contact, step->to.load, step->to.shear) : 0;
    if (!rw_memory_reserve(&contact->memory, 2) ||
        !rw_slip_origins_advance(&contact->origins, &contact->memory, slip != 0, step->to.load,
                                 step->to.shear)) {
        rw_memory_destroy(&before);
        return RWEDGE_ENOMEM;
    }
    go(contact, &to, step, departure);
    const bool slides = contact->memory.count == 2 && slip != 0;
    contact->was_off_centre = true;
    contact->is_origin_known = is_known && !slides;
    const double share = contact->energy_carry +
                         (is_plain ? plain_share : share_off_centre(contact, &before, step, slip));
    const double energy = contact->energy + share; /* NaN if one of them is */
    contact->energy_carry = isnan(energy) ? 0 : share - (energy - contact->energy);
    contact->energy = energy;
    rw_memory_destroy(&before);
    return RWEDGE_OK;
}

static int32_t apply(rwedge_contact *contact, rw_loads to)
{
    int32_t status = check(contact, to);
    rw_step step;
    if (status == RWEDGE_OK)
        status = make_step(contact, to, &step);
    if (status != RWEDGE_OK)
        return status;
    if (!is_tilt_possible(&step))
        return RWEDGE_EDOMAIN;
    rw_departure departure = {.corner = {0}};
    if (contact->f > 0 && rw_path_departure(&step, &departure) != RW_NO_OBSTACLE)
        return RWEDGE_EPATH;
    if (!is_off_centre(contact, &step))
        return go_centred(contact, to, &step, &departure);
    return go_off_centre(contact, to, &step, &departure);
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

static const char *text_of(rw_obstacle obstacle)
{
    switch (obstacle) {
    case RW_EDGES_PART:
        return "one edge of the contact would advance while the other recedes: change P with M, so "
               "that dM/dP stays within a quarter of the contact's width from its middle";
    case RW_SLIPS_BOTH_WAYS:
        return "the two edges would slip in opposite directions: change sigma by less, or Q by more, "
               "or in a load of its own at constant P and M";
    case RW_FRONTS_PART:
        return "slip or the edges would end between different patches of the history at the left and "
               "at the right: go on until both have passed, or separate the bodies first";
    case RW_GROWS_UNEVENLY:
        return "the contact would grow with a shear that does not keep to its tilt: change P and M "
               "first, under constant Q and sigma, then Q and sigma";
    default:
        return "";
    }
}

const char *rwedge_contact_obstacle(const rwedge_contact *contact, double P, double M, double Q,
                                    double sigma, double *largest)
{
    const rw_loads to = {P, M, Q, sigma};
    rw_step step;
    rw_departure departure;
    if (!contact || check(contact, to) != RWEDGE_OK ||
        make_step(contact, to, &step) != RWEDGE_OK || !is_tilt_possible(&step))
        return "";
    const double stretch_of_tension = contact->geometry.A / contact->geometry.theta / 4;
    if (largest)
        *largest = contact->f > 0
                       ? rw_path_largest_stretch(&step) * contact->f / stretch_of_tension
                       : HUGE_VAL;
    return contact->f > 0 ? text_of(rw_path_departure(&step, &departure)) : "";
}
