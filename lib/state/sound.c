/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "state/sound.h"

/* Two numbers that follow from each other in a contact differ by no more than this, relatively,
 * whatever was rounded. */
static const double LOOSE = 1e-6;

/* No patch of a contact has a smaller half-width. */
static const double LEAST = 1e-90;

static bool is_near(double value, double expected, double scale)
{
    return islessequal(fabs(value - expected), LOOSE * scale);
}

static rw_pressing carried_by(const rwedge_contact *contact, const rw_corner *c)
{
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const rw_sliding_way slides = {contact->unlike, c->ratio < 0 ? -1 : 1};
    return rw_sliding_pressing(&arcs, slides, c->patch);
}

/* Whether a patch is that of its corner's load and tilt. */
static bool is_patch_sound(const rwedge_contact *contact, const rw_corner *c)
{
    const rw_geometry *g = &contact->geometry;
    const rw_patch p = c->patch;
    const double load = rw_as_length(g, c->load);
    if (!(rw_patch_half_width(p) > LEAST && fmax(-p.left, p.right) < 2 * RW_LARGEST) ||
        !(g->pad || fmax(p.left, -p.right) < g->a) || !(fabs(c->tilt) < 1))
        return false;
    if (contact->unlike && c->ratio == 0) /* the shear has its part: is_pressure_sound() */
        return true;
    const rw_pressing carried = carried_by(contact, c);
    return is_near(carried.load, load, load) && is_near(carried.tilt, c->tilt, 1);
}

static bool is_nested(rw_patch inner, rw_patch outer)
{
    const double slack = LOOSE * (outer.right - outer.left);
    return inner.left > outer.left - slack && inner.right < outer.right + slack;
}

bool rw_is_corner_sound(const rwedge_contact *contact, const rw_corner *c, const rw_corner *before)
{
    if (isnan(c->least) || isnan(c->most))
        return false;
    if (!before)
        return c->load == 0 && c->shear == 0 && c->ratio == 0 && c->patch.left == 0 &&
               c->patch.right == 0;
    const double run = c->load - before->load, rise = c->shear - before->shear;
    return run > 0 && c->load < 2 * RW_LARGEST && fabs(c->ratio) <= 1 &&
           is_near(rise, c->ratio * run, c->load) && is_patch_sound(contact, c) &&
           (before->load == 0 || is_nested(before->patch, c->patch));
}

bool rw_is_origin_sound(const rw_slip_origins *origins, size_t i)
{
    const rw_slip_origin *o = &origins->all[i];
    const rw_path path = rw_slip_origin_path(origins, o);
    const rw_corner *end = rw_path_end(&path);
    return o->end > (i > 0 ? origins->all[i - 1].end : 0) &&
           o->end <= fmax(o->from_load, o->to_load) && o->from_load == end->load &&
           o->from_shear == end->shear && o->to_load >= 0 && o->to_load < 2 * RW_LARGEST &&
           fabs(o->to_shear) <= (1 + LOOSE) * o->to_load;
}

/* Whether the computed pressure of unlike bodies carries the loads. */
static bool is_pressure_sound(const rwedge_contact *c)
{
    const rw_traction *pressed = &c->computed.now->now.pressed;
    const double P = c->f * rw_as_length(&c->geometry, c->loads.P);
    return pressed->count > 0 && c->computed.start->now.pressed.count > 0 &&
           is_near(c->loads.P, rw_memory_end(&c->memory)->load, c->loads.P) &&
           fabs(rw_traction_total(pressed) - P) <= 0.01 * P;
}

/* Whether the loads are those at the end of the path. */
static bool are_loads_sound(const rwedge_contact *c)
{
    const rw_geometry *g = &c->geometry;
    const rw_corner *end = rw_memory_end(&c->memory);
    if (end->load == 0)
        return c->loads.P == 0 && c->loads.M == 0 && c->loads.Q == 0;
    if (c->unlike && c->phase == RW_COMPUTED)
        return is_pressure_sound(c);
    const rw_pressing carried = carried_by(c, end);
    const double arm = fmax(-end->patch.left, end->patch.right);
    return is_near(c->loads.P, end->load, end->load) &&
           is_near(rw_as_length(g, c->loads.M), carried.moment, carried.load * arm) &&
           (c->phase == RW_COMPUTED || is_near(c->loads.Q, c->f * end->shear, c->f * end->load));
}

/* Whether a held pad has its tilt. */
static bool is_tilt_sound(const rwedge_contact *c)
{
    const rw_corner *end = rw_memory_end(&c->memory);
    return !c->is_held ||
           (fabs(c->held_tilt) < 1 && (end->load == 0 || is_near(c->held_tilt, end->tilt, 1)));
}

/* Whether the last kept path has the corners that the present one shares with it. */
static bool is_share_sound(const rwedge_contact *c)
{
    const rw_slip_origins *origins = &c->slip.origins;
    if (c->memory.shared == 0)
        return true;
    if (c->memory.shared > rw_slip_origins_last_corners(origins))
        return false;
    const rw_path last = rw_slip_origin_path(origins, &origins->all[origins->count - 1]);
    return rw_memory_common(&c->memory, &last) >= c->memory.shared;
}

static bool is_numerical_sound(const rw_numerical *n)
{
    const rw_numerical_state *s = &n->now;
    const rw_zones *z = &s->shear.zones;
    return s->at.P > 0 && z->zone[0].left == s->contact.left &&
           z->zone[z->count - 1].right == s->contact.right;
}

static bool is_shear_sound(const rwedge_contact *c)
{
    if (!(c->tolerance == 0 ||
          (isgreaterequal(c->tolerance, 1e-6) && islessequal(c->tolerance, 1e-2))))
        return false;
    if (c->phase != RW_COMPUTED)
        return true;
    const rw_patch contact = rw_memory_end(&c->memory)->patch, now = c->computed.now->now.contact;
    const double width = contact.right - contact.left;
    return c->f > 0 && fabs(c->loads.Q) <= c->f * c->loads.P * (1 + LOOSE) &&
           c->memory.count == 2 && c->memory.corners[1].ratio == 0 &&
           is_near(now.left, contact.left, width) && is_near(now.right, contact.right, width) &&
           c->computed.strayed >= 0 && is_numerical_sound(c->computed.now) &&
           is_numerical_sound(c->computed.start);
}

/* Unlike bodies are apart, or slide, or their shear is computed. */
static bool is_unlike_sound(const rwedge_contact *c)
{
    const bool has_phase =
        c->phase == RW_APART || c->phase == RW_SLIDING || c->phase == RW_COMPUTED;
    return !c->unlike || (has_phase && !c->beside && !c->computed.exact);
}

/* Whether the contact beside this one has the same edges. */
static bool is_beside_sound(const rwedge_contact *c)
{
    if (!c->beside)
        return true;
    const rw_patch own = rw_memory_end(&c->memory)->patch,
                   other = rw_memory_end(&c->beside->memory)->patch;
    const double width = own.right - own.left;
    return c->phase == RW_OFF_CENTRE && c->tolerance > 0 && c->beside->tolerance > 0 &&
           is_near(other.left, own.left, width) && is_near(other.right, own.right, width) &&
           rw_is_contact_sound(c->beside);
}

bool rw_is_contact_sound(const rwedge_contact *c)
{
    const rw_slip_origins *origins = &c->slip.origins;
    return rw_is_friction(c->f) && rw_is_magnitude(c->loads.P) && rw_is_signed(c->loads.M) &&
           rw_is_signed(c->loads.Q) && rw_is_signed(c->loads.sigma) &&
           rw_is_signed(c->touched_at) && !isless(c->energy.sum, 0) && isfinite(c->energy.sum) &&
           isfinite(c->energy.rest) && rw_is_magnitude(c->sliding.largest_load) &&
           rw_is_magnitude(c->strain) && are_loads_sound(c) && is_tilt_sound(c) &&
           is_share_sound(c) && is_shear_sound(c) &&
           (!c->computed.exact || rw_is_contact_sound(c->computed.exact)) && is_beside_sound(c) &&
           is_unlike_sound(c) &&
           origins->fresh >= (origins->count > 0 ? origins->all[origins->count - 1].end : 0);
}

bool rw_is_pad_sound(const rw_pad *pad)
{
    double all = 0;
    for (size_t i = 0; i < pad->count; i++) {
        const rw_arc arc = pad->arcs[i];
        if (!(arc.left <= arc.right && pad->weights[i] > 0 &&
              (i == 0 || pad->arcs[i - 1].right <= arc.left)))
            return false;
        all += pad->weights[i];
    }
    return is_near(all, 1, 1);
}
