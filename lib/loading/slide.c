/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact that slides off its centre under a rig. Its traction is then f times the pressure, so
 * that it deforms the surface in proportion to the profile: the slip of all places follows from
 * that of one. The displacement is that with which the last place begins to slip. What the bodies
 * slide besides is the rig's. */
#include "loading/slide.h"

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

double rw_contact_displacement_of_loads(const rwedge_contact *contact)
{
    return rwedge_contact_displacement(contact, contact->drive.b) - contact->drive.slid;
}

bool rw_contact_slides_on(const rwedge_contact *before, const rwedge_contact *contact)
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
    const rw_slide step = slip_between(slide_of(before, rw_contact_displacement_of_loads(before)),
                                       slide_of(contact, 0));
    const double left = step.shift + step.slope * fmax(old.left, now.left),
                 right = step.shift + step.slope * fmin(old.right, now.right);
    return contact->loads.Q > 0 ? fmax(left, right) : fmin(left, right);
}

/* The energy of a contact that slides on. */
static double work_of(const rwedge_contact *before, const rwedge_contact *contact)
{
    const rw_slide step = slip_between(slide_of(before, rw_contact_displacement_of_loads(before)),
                                       contact->drive.slide);
    const double way = contact->loads.Q > 0 ? -1 : 1;
    const double P = before->loads.P / 2 + contact->loads.P / 2,
                 M = before->loads.M / 2 + contact->loads.M / 2;
    return way * contact->f * (P * step.shift + M * step.slope);
}

void rw_contact_count_slide(rwedge_contact *contact, double displacement)
{
    rw_slip_record *slip = &contact->slip;
    contact->drive.slide = slide_of(contact, displacement);
    rw_slip_origins_destroy(&slip->origins);
    contact->memory.shared = 0;
    slip->is_known = true;
    slip->settled = rw_memory_end(&contact->memory)->patch;
}

void rw_contact_slide_on(const rwedge_contact *before, rwedge_contact *contact)
{
    rw_contact_count_slide(contact, least_displacement(before, contact));
    contact->energy = before->energy;
    contact->energy.sum += work_of(before, contact);
}
