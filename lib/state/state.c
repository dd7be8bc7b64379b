/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact as numbers, for restarts and for other processes. In this order: the version of this
 * form and a checksum of all that follows; the pad and the present loads; the path of the memory;
 * the origins of slip; the computed shear. The numbers are those that the contact holds, to the
 * last bit, so that a restored contact goes on as the original would. */
#include "state/sound.h"

#include "base/logarithm.h"

#include <stdlib.h>

/* Version 2 added the strain per bulk tension, version 3 the computed shear and any pad, version 4
 * what is beside the contact, version 5 unlike bodies, a held pad, and what a rig prescribes. */
static const double VERSION = 5;

/* How many numbers they take, at least. */
enum { HEAD = 2, CORNER = 9, ORIGIN = 7, ELEMENT = 5, ARC = 3 };

/* Reads or writes one number after the other; `at` counts them. */
typedef struct {
    double *out;      /* NULL when reading or counting */
    const double *in; /* NULL when writing or counting */
    size_t at, size;
    double version;
    const rwedge_contact *contact;
    bool is_sound, is_short; /* of memory */
    bool is_inner;           /* in the last closed form of another contact */
    bool is_beside;          /* in a contact beside another one */
} stream;

static void require(stream *t, bool condition)
{
    t->is_sound = t->is_sound && condition;
}

static void pass(stream *t, double *value)
{
    const bool is_over = t->in && t->at >= t->size;
    require(t, !is_over);
    if (t->in)
        *value = is_over ? 0 : t->in[t->at];
    else if (t->out)
        t->out[t->at] = *value;
    t->at++;
}

/* Where memory is short, nothing is read any more, as where the numbers are not sound. */
static bool has(stream *t, bool memory)
{
    if (!memory)
        t->is_short = true;
    require(t, memory);
    return t->is_sound;
}

/* A whole number that is not above the limit. */
static size_t pass_number(stream *t, size_t number, size_t limit)
{
    double value = (double)number;
    pass(t, &value);
    const bool is_number = isgreaterequal(value, 0) && islessequal(value, (double)limit);
    require(t, is_number && value == floor(value));
    return is_number ? (size_t)value : 0;
}

/* How many things follow, each of so many numbers at least. */
static size_t pass_count(stream *t, size_t count, size_t numbers)
{
    return pass_number(t, count, t->in ? t->size / numbers : count);
}

/* What is only read stays unwritten: other threads may read it too. */
static void pass_int(stream *t, int *number, size_t limit)
{
    const size_t count = pass_number(t, (size_t)*number, limit);
    if (t->in)
        *number = (int)count;
}

static void pass_flag(stream *t, bool *flag)
{
    int number = *flag;
    pass_int(t, &number, 1);
    if (t->in)
        *flag = number == 1;
}

static void pass_finite(stream *t, double *number)
{
    pass(t, number);
    require(t, isfinite(*number));
}

/* The list ends with NULL. */
static void pass_all(stream *t, double *const numbers[])
{
    for (size_t i = 0; numbers[i]; i++)
        pass_finite(t, numbers[i]);
}

static void pass_patch(stream *t, rw_patch *patch)
{
    pass_finite(t, &patch->left);
    pass_finite(t, &patch->right);
}

/* ---- The path of the memory, and the origins of slip ---- */

static void pass_corner(stream *t, rw_corner *c)
{
    pass_all(t, (double *const[]){&c->load, &c->shear, &c->tilt, &c->stretch, &c->ratio, NULL});
    pass_patch(t, &c->patch);
    pass(t, &c->least); /* infinite where nothing bounds the slope */
    pass(t, &c->most);
}

/* Corners one after the other; `before` is the corner in front of them, or NULL. */
static void pass_corners(stream *t, rw_corner corners[], size_t count, const rw_corner *before)
{
    for (size_t i = 0; i < count; i++) {
        pass_corner(t, &corners[i]);
        require(t, !t->in || rw_is_corner_sound(t->contact, &corners[i], before));
        before = &corners[i];
    }
}

static void pass_path(stream *t, rw_memory *memory)
{
    const size_t count = pass_count(t, memory->count, CORNER);
    const size_t shared = pass_number(t, memory->shared, count);
    require(t, count > 0);
    if (!t->is_sound || (t->in && !has(t, rw_memory_reserve(memory, count))))
        return;
    if (t->in) {
        memory->count = count;
        memory->shared = shared;
    }
    pass_corners(t, memory->corners, count, NULL);
    if (t->in)
        rw_memory_relevel(memory);
}

/* The last of the first corners that the path has in common with the last one that is kept. */
static const rw_corner *last_shared(const rw_slip_origins *origins, size_t shared)
{
    if (shared == 0)
        return NULL;
    const rw_path path = rw_slip_origin_path(origins, &origins->all[origins->count - 1]);
    return rw_path_corner(&path, shared - 1);
}

/* An origin with the corners that its path does not share with that of the one before it. They are
 * read straight to their final place. */
static void pass_origin(stream *t, rw_slip_origins *origins, size_t i)
{
    const size_t most = rw_slip_origins_last_corners(origins);
    rw_slip_origin o = {.corners = most, .shared = most, .first = origins->own.count};
    if (!t->in)
        o = origins->all[i];
    const size_t count = o.corners - o.shared;
    pass_all(t,
             (double *const[]){&o.end, &o.from_load, &o.from_shear, &o.to_load, &o.to_shear, NULL});
    o.shared = pass_number(t, o.shared, o.shared);
    const size_t own = pass_count(t, count, CORNER);
    o.corners = o.shared + own;
    require(t, o.corners > 0);
    if (!t->is_sound || (t->in && !has(t, rw_slip_origins_reserve(origins, 1, own))))
        return;
    rw_corner *corners = origins->own.corners + o.first;
    pass_corners(t, corners, own, t->in ? last_shared(origins, o.shared) : NULL);
    if (!t->in || !t->is_sound)
        return;
    rw_slip_origins_keep(origins, o, corners);
    require(t, rw_is_origin_sound(origins, i));
}

static void pass_origins(stream *t, rw_slip_origins *origins)
{
    pass_finite(t, &origins->fresh);
    const size_t count = pass_count(t, origins->count, ORIGIN);
    for (size_t i = 0; i < count && t->is_sound; i++)
        pass_origin(t, origins, i);
}

/* ---- The computed shear ---- */

static void pass_element(stream *t, rw_traction *traction, size_t i)
{
    rw_element e = {.end = 0};
    if (!t->in)
        e = traction->elements[i];
    pass_all(t, (double *const[]){&e.end, &e.scale, &e.first, &e.last, NULL});
    pass_int(t, &e.terms, RW_TERMS);
    for (int k = 0; k < e.terms; k++)
        pass_finite(t, &e.coefficient[k]);
    require(t, e.scale != 0 && e.first >= 0 && e.first < e.last && e.last <= 1);
    if (!t->in || !t->is_sound || !has(t, rw_traction_append(traction, &e)))
        return;
    const rw_element *last = &traction->elements[i];
    require(t, last->low < last->high && (i == 0 || last->low >= last[-1].low));
}

static void pass_elements(stream *t, rw_traction *traction)
{
    const size_t count = pass_count(t, traction->count, ELEMENT);
    for (size_t i = 0; i < count && t->is_sound; i++)
        pass_element(t, traction, i);
}

static void pass_zones(stream *t, rw_zones *z)
{
    pass_int(t, &z->count, RW_MOST_ZONES);
    for (int i = 0; i < z->count; i++) {
        rw_zone *zone = &z->zone[i];
        int label = zone->label + 1;
        pass_finite(t, &zone->left);
        pass_finite(t, &zone->right);
        pass_int(t, &label, 2);
        if (t->in)
            zone->label = label - 1;
        require(t, zone->left < zone->right &&
                       (i == 0 || (zone->left == zone[-1].right && zone->label != zone[-1].label)));
    }
    require(t, z->count > 0);
}

/* Passes the pressure of unlike bodies. */
static void pass_pressure(stream *t, rw_numerical_state *s)
{
    if (!t->contact->unlike)
        return;
    pass_elements(t, &s->pressed);
    pass_finite(t, &s->tilt);
    if (t->in)
        s->coupling = -t->contact->beta / t->contact->f;
}

static void pass_shear(stream *t, rw_numerical **shear)
{
    if (t->in)
        *shear = calloc(1, sizeof **shear);
    if (!has(t, *shear))
        return;
    rw_numerical *n = *shear;
    rw_numerical_state *s = &n->now;
    pass_all(t, (double *const[]){&s->at.P, &s->at.turn, &s->at.shear, &s->at.stretch, NULL});
    pass_patch(t, &s->contact);
    pass_all(t, (double *const[]){&s->move, &s->energy, &s->error, NULL});
    pass_patch(t, &s->unslipped);
    pass_zones(t, &s->shear.zones);
    pass_int(t, &s->shear.kinks, RW_MOST_KINKS);
    for (int i = 0; i < s->shear.kinks; i++)
        pass_finite(t, &s->shear.kink[i]);
    pass_elements(t, &s->shear.traction);
    pass_flag(t, &n->has_origin);
    pass_flag(t, &s->is_still);
    pass_elements(t, &n->origin);
    pass_pressure(t, s);
    for (int i = 0; i < RW_PLACES; i++) {
        pass_finite(t, &n->error[i]);
        require(t, n->error[i] >= 0);
    }
    if (t->in && t->is_sound)
        has(t, rw_numerical_cluster(n));
}

static void pass_contact(stream *t, rwedge_contact *c);

/* The contact when it last had a closed form. */
static void pass_exact(stream *t, rwedge_contact *c)
{
    rwedge_contact **exact = &c->computed.exact;
    bool has_exact = *exact;
    pass_flag(t, &has_exact);
    if (!has_exact)
        return;
    if (t->in)
        *exact = calloc(1, sizeof **exact);
    t->is_inner = true;
    if (has(t, *exact))
        pass_contact(t, *exact);
    t->is_inner = false;
}

/* The same contact, from which slip and energy are known. */
static void pass_beside(stream *t, rwedge_contact *c)
{
    bool has_beside = c->beside;
    pass_flag(t, &has_beside);
    if (!has_beside || !t->is_sound)
        return;
    if (t->in)
        c->beside = calloc(1, sizeof *c->beside);
    t->is_beside = true;
    if (has(t, c->beside))
        pass_contact(t, c->beside);
    if (t->in && c->beside)
        c->beside->slip.followed = RW_SLIP_AND_ENERGY_FOLLOWED;
}

static void pass_numerical(stream *t, rwedge_contact *c)
{
    int shears = c->phase == RW_COMPUTED;
    pass(t, &c->tolerance);
    pass_int(t, &shears, t->is_inner ? 0 : 1);
    if (shears == 0)
        return;
    pass_finite(t, &c->computed.strayed);
    pass_shear(t, &c->computed.now);
    if (t->is_sound)
        pass_shear(t, &c->computed.start);
    if (t->is_sound)
        pass_exact(t, c);
}

/* ---- The contact ---- */

static void pass_arc(stream *t, rw_pad *pad, size_t i)
{
    rw_arc arc = {0, 0};
    double weight = 0;
    if (!t->in) {
        arc = pad->arcs[i];
        weight = pad->weights[i];
    }
    pass_all(t, (double *const[]){&arc.left, &arc.right, &weight, NULL});
    if (t->in)
        rw_pad_append(pad, arc, weight);
}

/* What the pad is, if it is not a wedge. */
static void pass_pad(stream *t, rw_geometry *g)
{
    pass_all(t, (double *const[]){&g->reach, &g->middle_slope, NULL});
    require(t, rw_is_magnitude(g->reach));
    const size_t count = pass_count(t, g->pad ? g->pad->count : 0, ARC);
    if (count == 0 || !t->is_sound)
        return;
    if (t->in)
        g->pad = rw_pad_create(count);
    if (!has(t, g->pad))
        return;
    for (size_t i = 0; i < count && t->is_sound; i++)
        pass_arc(t, g->pad, i);
    require(t, rw_is_pad_sound(g->pad));
}

/* Whether the bodies are unlike follows from beta and friction. */
static void pass_beta(stream *t, rwedge_contact *c)
{
    pass_finite(t, &c->beta);
    require(t, rw_is_signed(c->beta) && fabs(c->beta) <= 0.5 && rw_is_friction(c->f));
    if (t->in && t->is_sound)
        has(t, rw_contact_make_unlike(c));
}

/* What rounding left out of the sum; NaN where the energy is not known. */
static void pass_rest_of_energy(stream *t, rw_dissipated *energy)
{
    double rest = energy->is_known ? energy->rest : NAN;
    pass(t, &rest);
    if (!t->in)
        return;
    energy->is_known = !isnan(rest);
    energy->rest = energy->is_known ? rest : 0;
}

/* NaN in states of older libraries, where it was not known. */
static void pass_energy(stream *t, rw_dissipated *energy)
{
    pass(t, &energy->sum);
    if (isnan(energy->sum))
        *energy = (rw_dissipated){.is_known = false};
}

/* Whether the pad is held, and at which tilt; what a rig has prescribed. */
static void pass_guidance(stream *t, rwedge_contact *c)
{
    pass_flag(t, &c->is_held);
    if (c->is_held)
        pass_finite(t, &c->held_tilt);
    rw_slide *slide = &c->drive.slide;
    pass_all(t, (double *const[]){&c->drive.b, &c->drive.slid, &slide->shift, &slide->slope,
                                  &slide->height, NULL});
    require(t, rw_is_magnitude(c->drive.b));
}

/* The phase is not among the numbers: it follows from them. */
static rw_phase phase_of(const rwedge_contact *c, bool is_off_centre)
{
    return c->memory.count == 1           ? RW_APART
           : c->computed.now              ? RW_COMPUTED
           : rw_memory_slides(&c->memory) ? RW_SLIDING
           : is_off_centre                ? RW_OFF_CENTRE
                                          : RW_CENTRED;
}

static void pass_contact(stream *t, rwedge_contact *c)
{
    rw_geometry *g = &c->geometry;
    rw_loads *loads = &c->loads;
    rw_sliding sliding = {.is_off_centre = rw_contact_is_off_centre(c)};
    if (c->phase == RW_SLIDING)
        sliding = c->sliding;
    t->contact = c;
    pass_all(t, (double *const[]){&g->theta, &g->a, &g->A, &c->f, &loads->P, &loads->M, &loads->Q,
                                  &loads->sigma, &c->touched_at, NULL});
    pass_patch(t, &c->slip.settled);
    pass_rest_of_energy(t, &c->energy);
    pass(t, &sliding.largest_load); /* 0 where it does not slide */
    if (t->version > 1)
        pass(t, &c->strain);
    else
        c->strain = 1;
    pass_energy(t, &c->energy);
    if (t->version > 2)
        pass_pad(t, g);
    if (t->version > 4)
        pass_beta(t, c);
    require(t, !t->in || (rw_is_geometry(g) && rw_is_positive(rw_unit_stress(g))));
    pass_flag(t, &sliding.is_off_centre);
    pass_flag(t, &c->slip.is_known);
    pass_path(t, &c->memory);
    pass_origins(t, &c->slip.origins);
    if (t->version > 2)
        pass_numerical(t, c);
    if (t->version > 3 && !t->is_inner && !t->is_beside)
        pass_beside(t, c);
    if (t->version > 4)
        pass_guidance(t, c);
    if (!t->in || !t->is_sound)
        return;
    c->sliding = sliding;
    c->phase = phase_of(c, sliding.is_off_centre);
}

/* A number of 52 bits. */
static double sum_of_bits(const double *state, size_t n)
{
    uint64_t sum = 0xcbf29ce484222325; /* FNV-1a, by words */
    for (size_t i = 0; i < n; i++)
        sum = (sum ^ rw_bits_of(state[i])) * 0x100000001b3 ^ (sum >> 29);
    return (double)(sum >> 12);
}

/* How many numbers there are; `out` receives them, unless it is NULL. */
static size_t write_numbers(const rwedge_contact *contact, double *out)
{
    rwedge_contact same = *contact; /* is only read */
    stream t = {.out = out, .at = HEAD, .version = VERSION, .is_sound = true};
    pass_contact(&t, &same);
    return t.at;
}

size_t rwedge_contact_state_size(const rwedge_contact *contact)
{
    return contact ? write_numbers(contact, NULL) : 0;
}

int32_t rwedge_contact_state(const rwedge_contact *contact, size_t n, double state[])
{
    if (!contact || !state)
        return RWEDGE_ENULL;
    if (n != write_numbers(contact, NULL))
        return RWEDGE_ERANGE;
    write_numbers(contact, state);
    state[0] = VERSION;
    state[1] = sum_of_bits(state + HEAD, n - HEAD);
    return RWEDGE_OK;
}

int32_t rwedge_contact_restore(size_t n, const double state[], rwedge_contact **contact)
{
    if (!state || !contact)
        return RWEDGE_ENULL;
    if (n <= HEAD || !(isgreaterequal(state[0], 1) && islessequal(state[0], VERSION)) ||
        state[0] != floor(state[0]) || state[1] != sum_of_bits(state + HEAD, n - HEAD))
        return RWEDGE_EDOMAIN;
    rwedge_contact *restored = calloc(1, sizeof *restored);
    if (!restored)
        return RWEDGE_ENOMEM;
    stream t = {.in = state, .at = HEAD, .size = n, .version = state[0], .is_sound = true};
    pass_contact(&t, restored);
    if (!t.is_sound || t.at != n || !rw_is_contact_sound(restored)) {
        rwedge_contact_destroy(restored);
        return t.is_short ? RWEDGE_ENOMEM : RWEDGE_EDOMAIN;
    }
    *contact = restored;
    return RWEDGE_OK;
}
