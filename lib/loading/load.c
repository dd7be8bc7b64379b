/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load of a contact: what it does. */
#include "loading/load.h"

#include "computed/beginning.h"
#include "history/dissipation.h"
#include "loading/step_to.h"

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

/* Whether slip reaches all of the path. */
static bool slides(const rw_departure *departure)
{
    return departure->slip != 0 && departure->corner.load == 0;
}

/* The bodies touch. The tension is that of the load before. */
static void touch(rwedge_contact *contact, double sigma)
{
    contact->touched_at = sigma;
    contact->drive.slide = (rw_slide){0, 0, 0};
    contact->energy.is_known = true;
}

/* The contact has the loads of a goal. */
static void note_loads(rwedge_contact *contact, const rw_goal *to, double P, double M)
{
    contact->loads = (rw_loads){P, M, to->Q, to->sigma};
    if (contact->is_held)
        contact->held_tilt = to->turn;
}

static void go(rwedge_contact *contact, const rw_goal *to, const rw_step *step,
               const rw_departure *departure)
{
    rw_memory *memory = &contact->memory;
    if (contact->phase == RW_APART) {
        touch(contact, contact->loads.sigma);
        memory->corners[0].tilt = step->to.tilt;
    }
    note_loads(contact, to, step->to_P, step->to_M);
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
}

/* The phase after a step in closed form, which the memory has taken. */
static void set_phase(rwedge_contact *contact, bool is_off_centre)
{
    const double load = rw_memory_end(&contact->memory)->load;
    const double before = contact->phase == RW_SLIDING ? contact->sliding.largest_load : 0;
    contact->phase = load == 0                            ? RW_APART
                     : rw_memory_slides(&contact->memory) ? RW_SLIDING
                     : is_off_centre                      ? RW_OFF_CENTRE
                                                          : RW_CENTRED;
    contact->sliding = (rw_sliding){fmax(before, load), is_off_centre};
}

/* The energy of a step. */
typedef struct {
    double value;
    bool is_known;
} share;

static const share NONE = {0, true}, UNKNOWN = {0, false};

/* What rounding leaves out may be negative. */
static void add_energy(rwedge_contact *contact, share step)
{
    rw_dissipated *energy = &contact->energy;
    energy->is_known = energy->is_known && step.is_known;
    const double more = energy->is_known ? energy->rest + step.value : 0, before = energy->sum;
    energy->sum = fmax(before, before + more);
    energy->rest = more - (energy->sum - before);
}

static bool is_off_centre(const rwedge_contact *contact, const rw_step *step)
{
    return contact->f > 0 && step->to.load > 0 &&
           (contact->unlike || rw_contact_is_off_centre(contact) ||
            !rw_memory_is_plain(&contact->memory, step->to));
}

/* What has been in contact since the first slip. */
static rw_patch settled_part(const rwedge_contact *contact)
{
    const rw_slip_origins *origins = &contact->slip.origins;
    const rw_corner *end = rw_memory_end(&contact->memory);
    if (rw_contact_is_off_centre(contact))
        return contact->phase == RW_COMPUTED || origins->count > 0 ? contact->slip.settled
                                                                   : end->patch;
    const double load =
        origins->count > 0 ? fmin(origins->all[0].end, origins->all[0].from_load) : end->load;
    return load == end->load ? end->patch : rw_patch_under_tilt(&contact->geometry, load, 0);
}

/* Off the centre the slip is known while one origin (slip_origin.h) serves all points that slipped:
 * they were in contact before the first slip, and no later point slips. */
static bool keeps_origin(const rwedge_contact *contact, const rw_step *step, int slip)
{
    const rw_slip_origins *origins = &contact->slip.origins;
    const rw_patch from = rw_memory_end(&contact->memory)->patch;
    if (!contact->slip.is_known || origins->count > 1 ||
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

/* Its energy where there is a single integral for it. */
static share share_of(const rwedge_contact *contact, const rw_step *step,
                      const rw_departure *departure)
{
    const rw_geometry *g = &contact->geometry;
    const rw_memory *memory = &contact->memory;
    const double f = contact->f;
    if (f == 0)
        return NONE;
    if (!contact->unlike && rw_is_symmetric(g) && rw_memory_is_plain(memory, step->to)) {
        const double integral = fmax(0, rw_dissipation(memory, step->to, g));
        return (share){f * g->A * (f / RW_PI * integral), true};
    }
    if (step->to.load == 0)
        return contact->phase == RW_APART || rw_path_separates_stuck(step) ? NONE : UNKNOWN;
    if (departure->slip == 0)
        return NONE;
    if (step->to_P != step->from_P || slides(departure))
        return UNKNOWN;
    return (share){f * g->theta * (f * g->theta / g->A) * rw_edge_work(memory, departure, g), true};
}

/* Whether the closed form of a step leaves unknown what is followed. */
static bool loses(const rwedge_contact *contact, const rw_step *step, const rw_departure *departure,
                  share energy)
{
    const rw_followed followed = contact->slip.followed;
    return followed != RW_NONE_FOLLOWED && is_off_centre(contact, step) && !slides(departure) &&
           (!keeps_origin(contact, step, departure->slip) ||
            (followed == RW_SLIP_AND_ENERGY_FOLLOWED && !energy.is_known));
}

static int32_t go_on(rwedge_contact *contact, rw_goal to, const rw_step *step,
                     const rw_departure *departure, share energy)
{
    const bool off_centre = is_off_centre(contact, step), is_separated = step->to.load == 0;
    const bool is_sliding = slides(departure);
    const bool keeps = keeps_origin(contact, step, departure->slip) && !is_sliding;
    const rw_patch settled = settled_part(contact);
    if (isgreater(contact->energy.sum + energy.value, RW_LARGEST))
        return RWEDGE_ERANGE;
    if (!rw_memory_reserve(&contact->memory, 2) ||
        !rw_slip_origins_advance(&contact->slip.origins, &contact->memory, departure->slip != 0,
                                 step->to.load, step->to.shear))
        return RWEDGE_ENOMEM;
    go(contact, &to, step, departure);
    add_energy(contact, energy);
    set_phase(contact, off_centre);
    if (off_centre)
        contact->slip.settled = common_part(settled, step->patch);
    if (off_centre || is_separated || is_sliding)
        contact->slip.is_known = keeps || is_separated;
    return RWEDGE_OK;
}

/* ---- Without a closed form ---- */

static int32_t go_numerically(rwedge_contact *contact, rw_goal to, rw_step *step)
{
    share energy = {.is_known = true};
    const bool touches = contact->phase == RW_APART;
    const double before = contact->loads.sigma;
    const rw_patch settled = touches ? (rw_patch){-HUGE_VAL, HUGE_VAL} : settled_part(contact);
    const int32_t status = rw_numerical_go(contact, step, &energy.value);
    if (status != RWEDGE_OK)
        return status;
    if (touches)
        touch(contact, before);
    note_loads(contact, &to, to.P, contact->is_held ? step->to_M : to.turn);
    contact->phase = RW_COMPUTED;
    contact->slip.settled = common_part(settled, step->patch);
    contact->slip.is_known = contact->computed.now->has_origin;
    add_energy(contact, energy);
    return RWEDGE_OK;
}

/* The departure for a load that separates the bodies or slides, whatever was before. */
static rw_departure departure_from_all(const rwedge_contact *contact, const rw_step *step)
{
    const int slip = step->to.load == 0 ? 0 : step->to.shear < 0 ? -1 : 1;
    return (rw_departure){contact->memory.corners[0], 1, slip};
}

/* Separation and full sliding end the computed shear: what follows is in closed form again. */
static int32_t leave_shear(rwedge_contact *contact, rw_goal to, const rw_step *step)
{
    const bool separates = step->to.load == 0;
    share work = UNKNOWN;
    int32_t status =
        separates ? rw_numerical_energy_to_separation(contact, &work.value) : RWEDGE_OK;
    if (status != RWEDGE_OK)
        return status;
    work.is_known = separates && !isnan(work.value);
    const rw_departure departure = departure_from_all(contact, step);
    status = go_on(contact, to, step, &departure, work);
    if (status == RWEDGE_OK)
        rw_contact_drop_computed(contact);
    return status;
}

static int32_t apply_numerically(rwedge_contact *contact, rw_goal to)
{
    rw_step step;
    const int32_t status = rw_step_to(contact, to, &step);
    if (status != RWEDGE_OK)
        return status;
    if (contact->phase == RW_COMPUTED && (to.P == 0 || rw_slides_at_end(&step)))
        return leave_shear(contact, to, &step);
    return contact->tolerance > 0 ? go_numerically(contact, to, &step) : RWEDGE_EPATH;
}

/* ---- With a closed form ---- */

/* The energy of the way to separation, where its closed form is not known. */
static int32_t compute_separation(const rwedge_contact *contact, share *energy)
{
    if (energy->is_known || contact->slip.followed != RW_SLIP_AND_ENERGY_FOLLOWED)
        return RWEDGE_OK;
    const int32_t status = rw_numerical_energy_to_separation(contact, &energy->value);
    energy->is_known = status == RWEDGE_OK && !isnan(energy->value);
    return status;
}

/* The straight line as one step. */
static int32_t apply_whole(rwedge_contact *contact, rw_goal to)
{
    rw_step step;
    int32_t status = rw_step_to(contact, to, &step);
    if (status != RWEDGE_OK)
        return status;
    rw_departure departure = {.corner = {0}};
    if (contact->unlike && !rw_slides_at_end(&step)) /* full sliding alone has a closed form */
        return RWEDGE_EPATH;
    if (contact->unlike)
        departure = departure_from_all(contact, &step);
    else if (contact->f > 0 && rw_path_departure(&step, &departure) != RW_NO_OBSTACLE)
        return RWEDGE_EPATH;
    if (departure.slip != 0 && !slides(&departure) && !rw_has_width(departure.corner.patch))
        return RWEDGE_ERANGE;
    share energy = share_of(contact, &step, &departure);
    if (to.P == 0)
        status = compute_separation(contact, &energy);
    else if (loses(contact, &step, &departure, energy))
        status = RWEDGE_EPATH;
    return status == RWEDGE_OK ? go_on(contact, to, &step, &departure, energy) : status;
}

/* A line that has no closed form as one step may have one in pieces. */
enum { MOST_PIECES = 40 };
static const double SHORTEST_PIECE = 1.0 / 256;

static rw_goal part_of_way(rw_goal from, rw_goal to, double part)
{
    return part == 1 ? to
                     : (rw_goal){from.P + part * (to.P - from.P),
                                 from.turn + part * (to.turn - from.turn),
                                 from.Q + part * (to.Q - from.Q),
                                 from.sigma + part * (to.sigma - from.sigma)};
}

/* Each piece is tried to the end of the line, and then at ever shorter lengths. */
static int32_t apply_in_pieces(rwedge_contact *contact, rw_goal to)
{
    const rw_goal from = rw_goal_of(contact, contact->loads);
    double t = 0, next = 0.5;
    for (int i = 0; i < MOST_PIECES && t < 1 && next - t >= SHORTEST_PIECE; i++) {
        if (apply_whole(contact, part_of_way(from, to, next)) == RWEDGE_OK) {
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
        rwedge_contact_copy(contact->computed.exact, &exact) != RWEDGE_OK)
        return;
    exact->tolerance = contact->tolerance;
    exact->slip.followed = contact->slip.followed;
    if (apply_whole(exact, rw_goal_of(contact, contact->loads)) == RWEDGE_OK &&
        rw_numerical_agrees(contact, exact)) {
        exact->energy = contact->energy;
        rw_contact_exchange(contact, exact);
        exact = rw_contact_keep_beside(contact, exact);
    }
    rwedge_contact_destroy(exact);
}

static int32_t apply_to_numerical(rwedge_contact *contact, rw_goal to)
{
    const int32_t status = apply_numerically(contact, to);
    if (status == RWEDGE_OK)
        return_to_closed_form(contact);
    return status;
}

int32_t rw_contact_apply_alone(rwedge_contact *contact, rw_goal to)
{
    if (contact->phase == RW_COMPUTED)
        return apply_to_numerical(contact, to);
    const int32_t status = apply_whole(contact, to);
    if (status != RWEDGE_EPATH)
        return status;
    if (contact->phase == RW_APART || contact->unlike)
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
