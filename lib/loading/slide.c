/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact that slides off its centre under a rig. Its traction is then f times the pressure, so
 * that it deforms the surface in proportion to the profile: the slip of all places follows from
 * that of one. The displacement is that with which the last place begins to slip. What the bodies
 * slide besides is the rig's. */
#include "loading/slide.h"

#include "loading/beside.h"

/* How far from f P a place still sticks, over f P. The displacement then changes by some ten times
 * that until it slides. The first may be too near to compute. */
static const double VERGE[] = {1e-6, 1e-5, 1e-4};
enum { VERGES = sizeof VERGE / sizeof VERGE[0] };

/* The slip of a contact that slides, with this displacement. */
static rw_slide slide_of(const rwedge_contact *contact, double displacement)
{
    const rw_corner *end = rw_memory_end(&contact->memory);
    const double unit = contact->f * contact->geometry.theta, x = rw_patch_middle(end->patch);
    const double tension = contact->loads.sigma - contact->touched_at;
    const double height = unit * end->ratio;
    const double slope = height * end->tilt + contact->geometry.A * contact->strain * tension / 4;
    const double slip = rw_contact_moved(contact, contact->drive.b, x) - displacement;
    return (rw_slide){slip - slope * x + height * rw_profile_height(&contact->geometry, x), slope,
                      height};
}

/* Without what the rig has slid; NaN where it is not known. */
static double displacement_of(const rwedge_contact *contact)
{
    return rwedge_contact_displacement(contact, contact->drive.b) - contact->drive.slid;
}

/* The contact when it is about to slide under the loads: one of which the displacement is known.
 * RWEDGE_EPATH where it never is. */
static int32_t find_verge(const rwedge_contact *contact, rw_goal to, rwedge_contact **verge)
{
    for (int i = 0; i < VERGES; i++) {
        rw_goal before = to;
        before.Q *= 1 - VERGE[i];
        int32_t status = rwedge_contact_copy(contact, verge);
        if (status == RWEDGE_OK)
            status = rw_contact_apply(*verge, before);
        if (status == RWEDGE_ENOMEM || (status == RWEDGE_OK && !isnan(displacement_of(*verge))))
            return status;
        rwedge_contact_destroy(*verge);
        *verge = NULL;
    }
    return RWEDGE_EPATH;
}

/* Whether a contact of which the slip is known slides on the same way. */
static bool slides_on(const rwedge_contact *before, const rwedge_contact *contact)
{
    return before->phase == RW_SLIDING && before->loads.Q * contact->loads.Q > 0 &&
           rw_contact_knows_slip(before);
}

/* The slip in a step between two states that slide the same way, whose heights are the same: shift
 * + slope x. */
static rw_slide slip_between(rw_slide from, rw_slide to)
{
    return (rw_slide){to.shift - from.shift, to.slope - from.slope, 0};
}

/* The displacement with which the contact just slides on: no place slips back in the step. */
static double least_displacement(const rwedge_contact *before, const rwedge_contact *contact)
{
    const rw_patch old = rw_memory_end(&before->memory)->patch,
                   now = rw_memory_end(&contact->memory)->patch;
    const rw_slide step =
        slip_between(slide_of(before, displacement_of(before)), slide_of(contact, 0));
    const double left = step.shift + step.slope * fmax(old.left, now.left),
                 right = step.shift + step.slope * fmin(old.right, now.right);
    return contact->loads.Q > 0 ? fmax(left, right) : fmin(left, right);
}

/* The energy of a contact that slides on. */
static double work_of(const rwedge_contact *before, const rwedge_contact *contact)
{
    const rw_slide step =
        slip_between(slide_of(before, displacement_of(before)), contact->drive.slide);
    const double way = contact->loads.Q > 0 ? -1 : 1;
    const double P = before->loads.P / 2 + contact->loads.P / 2,
                 M = before->loads.M / 2 + contact->loads.M / 2;
    return way * contact->f * (P * step.shift + M * step.slope);
}

/* From now on slip counts from here. */
static void count_slip(rwedge_contact *contact, double displacement)
{
    rw_slip_record *slip = &contact->slip;
    contact->drive.slide = slide_of(contact, displacement);
    rw_slip_origins_destroy(&slip->origins);
    contact->memory.shared = 0;
    slip->is_known = true;
    slip->settled = rw_memory_end(&contact->memory)->patch;
}

static void slide_on(const rwedge_contact *before, rwedge_contact *contact)
{
    count_slip(contact, least_displacement(before, contact));
    contact->energy = before->energy;
    contact->energy.sum += work_of(before, contact);
}

static int32_t begin_to_slide(const rwedge_contact *before, rw_goal to, rwedge_contact *contact)
{
    rwedge_contact *verge = NULL;
    const int32_t status = find_verge(before, to, &verge);
    if (status == RWEDGE_OK) {
        count_slip(contact, displacement_of(verge));
        contact->energy = rw_contact_of_slip(verge)->energy;
    }
    rwedge_contact_destroy(verge);
    return status == RWEDGE_ENOMEM ? status : RWEDGE_OK;
}

int32_t rw_contact_know_slide(const rwedge_contact *before, rw_goal to, rwedge_contact *contact)
{
    if (contact->phase != RW_SLIDING || !contact->sliding.is_off_centre || contact->unlike)
        return RWEDGE_OK;
    if (!slides_on(before, contact))
        return begin_to_slide(before, to, contact);
    slide_on(before, contact);
    return RWEDGE_OK;
}
