/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact as numbers, for restarts and for other processes. In this order: the version of this
 * form and a checksum of all that follows; the pad and the present loads; the path of the memory;
 * the origins of slip; the computed shear. The numbers are those that the contact holds, to the
 * last bit, so that a restored contact goes on as the original would. */
#include "contact/sound.h"

#include "base/logarithm.h"

#include <stdlib.h>

/* Version 2 added the strain per bulk tension, version 3 the computed shear and any pad. */
static const double VERSION = 3;

enum { HEAD = 2, CORNER = 9, ORIGIN = 7 };

/* Reads or writes one number after the other; `at` counts them. */
typedef struct {
    double *out;      /* NULL when reading or counting */
    const double *in; /* NULL when writing or counting */
    size_t at, size;
    double version;
    const rw_geometry *geometry;
    bool is_sound, is_short; /* of memory */
    bool is_inner;           /* in a contact that another one keeps */
} stream;

static void pass(stream *t, double *value)
{
    const bool is_over = t->in && t->at >= t->size;
    t->is_sound = t->is_sound && !is_over;
    if (t->in)
        *value = is_over ? 0 : t->in[t->at];
    else if (t->out)
        t->out[t->at] = *value;
    t->at++;
}

/* Where memory is short, nothing is read any more, as where the numbers are not sound. */
static void need(stream *t, bool has_memory)
{
    if (has_memory)
        return;
    t->is_short = true;
    t->is_sound = false;
}

/* A count or a flag, a whole number that is not above the limit. */
static size_t pass_count(stream *t, size_t count, size_t limit)
{
    double value = (double)count;
    pass(t, &value);
    if (!(isgreaterequal(value, 0) && islessequal(value, (double)limit)) || value != floor(value)) {
        t->is_sound = false;
        return 0;
    }
    return (size_t)value;
}

/* What is only read stays unwritten: other threads may read it too. */
static void pass_int(stream *t, int *number, size_t limit)
{
    const size_t count = pass_count(t, (size_t)*number, limit);
    if (t->in)
        *number = (int)count;
}

static void pass_flag(stream *t, bool *flag)
{
    const bool is_set = pass_count(t, *flag, 1) == 1;
    if (t->in)
        *flag = is_set;
}

static void pass_finite(stream *t, double *number)
{
    pass(t, number);
    t->is_sound = t->is_sound && isfinite(*number);
}

static void pass_all(stream *t, size_t count, double *const numbers[])
{
    for (size_t i = 0; i < count; i++)
        pass_finite(t, numbers[i]);
}

static void pass_corner(stream *t, rw_corner *c)
{
    double *const finite[] = {&c->load,  &c->shear,      &c->tilt,       &c->stretch,
                              &c->ratio, &c->patch.left, &c->patch.right};
    pass_all(t, sizeof finite / sizeof *finite, finite);
    pass(t, &c->least); /* infinite where nothing bounds the slope */
    pass(t, &c->most);
}

/* ---- Reading and writing ---- */

/* Corners one after the other; `before` is the corner in front of them, or NULL. */
static void pass_corners(stream *t, rw_corner corners[], size_t count, const rw_corner *before)
{
    for (size_t i = 0; i < count; i++) {
        pass_corner(t, &corners[i]);
        if (t->in && !rw_is_corner_sound(t->geometry, &corners[i], before))
            t->is_sound = false;
        before = &corners[i];
    }
}

static void pass_path(stream *t, rw_memory *memory)
{
    const size_t limit = t->in ? t->size / CORNER : memory->count;
    const size_t count = pass_count(t, memory->count, limit);
    const size_t shared = pass_count(t, memory->shared, count);
    if (t->in) {
        memory->shared = shared;
        t->is_sound = t->is_sound && count > 0;
        if (t->is_sound)
            need(t, rw_memory_reserve(memory, count));
        memory->count = t->is_sound ? count : 0;
    }
    pass_corners(t, memory->corners, memory->count, NULL);
    if (t->in && memory->count > 0)
        rw_memory_relevel(memory);
}

/* An origin without its corners: how many it has, and how many it shares with the last origin. */
static void pass_origin(stream *t, rw_slip_origin *o, size_t *shared, size_t most_shared)
{
    double *const numbers[] = {&o->end, &o->from_load, &o->from_shear, &o->to_load, &o->to_shear};
    pass_all(t, sizeof numbers / sizeof *numbers, numbers);
    const size_t common = pass_count(t, *shared, most_shared);
    const size_t own = pass_count(t, o->corners - common, t->in ? t->size / CORNER : o->corners);
    if (t->in) {
        *shared = common;
        o->corners = common + own;
    }
}

static void write_origin(stream *t, const rw_slip_origins *origins, size_t i)
{
    rw_slip_origin origin = origins->all[i];
    size_t shared = origins->branches[i].shared;
    pass_origin(t, &origin, &shared, shared);
    pass_corners(t, origins->own.corners + origins->branches[i].first, origin.corners - shared,
                 NULL);
}

/* Reads the corners straight to their final place. */
static void read_origin(stream *t, rw_slip_origins *origins)
{
    const size_t last = rw_slip_origins_last_corners(origins);
    rw_slip_origin origin = {.corners = 0};
    size_t shared = 0;
    pass_origin(t, &origin, &shared, last);
    t->is_sound = t->is_sound && origin.corners > 0;
    if (t->is_sound)
        need(t, rw_slip_origins_reserve(origins, 1, origin.corners - shared));
    if (!t->is_sound)
        return;
    rw_corner *own = origins->own.corners + origins->own.count;
    const rw_corner *before = NULL;
    if (shared > 0) {
        const rw_path path = rw_slip_origin_path(origins, &origins->all[origins->count - 1]);
        before = rw_path_corner(&path, shared - 1);
    }
    pass_corners(t, own, origin.corners - shared, before);
    if (!t->is_sound)
        return;
    rw_slip_origins_keep(origins, origin, own, shared);
    t->is_sound = rw_is_origin_sound(origins, origins->count - 1);
}

static void pass_origins(stream *t, rw_slip_origins *origins)
{
    pass_finite(t, &origins->fresh);
    const size_t limit = t->in ? t->size / ORIGIN : origins->count;
    const size_t count = pass_count(t, origins->count, limit);
    for (size_t i = 0; i < count && t->is_sound; i++)
        if (t->in)
            read_origin(t, origins);
        else
            write_origin(t, origins, i);
}

/* ---- The computed shear ---- */

static void pass_elements(stream *t, rw_traction *traction)
{
    const size_t count = pass_count(t, traction->count, t->in ? t->size / 5 : traction->count);
    double end = -HUGE_VAL;
    for (size_t i = 0; i < count && t->is_sound; i++) {
        rw_element e = {.end = 0};
        if (!t->in)
            e = traction->elements[i];
        double *const shape[] = {&e.end, &e.scale, &e.first, &e.last};
        pass_all(t, 4, shape);
        pass_int(t, &e.terms, RW_TERMS);
        for (int k = 0; k < e.terms; k++)
            pass_finite(t, &e.coefficient[k]);
        if (!t->in || !t->is_sound)
            continue;
        t->is_sound = e.scale != 0 && e.first >= 0 && e.first < e.last && e.last <= 1;
        if (t->is_sound)
            need(t, rw_traction_append(traction, &e));
        if (!t->is_sound)
            continue;
        const rw_element *last = &traction->elements[i];
        t->is_sound = last->low < last->high && last->low >= end;
        end = last->low;
    }
}

static void pass_zones(stream *t, rw_zones *z)
{
    pass_int(t, &z->count, RW_MOST_ZONES);
    for (int i = 0; i < z->count; i++) {
        double *const ends[] = {&z->zone[i].left, &z->zone[i].right};
        pass_all(t, 2, ends);
        int label = z->zone[i].label + 1;
        pass_int(t, &label, 2);
        if (t->in)
            z->zone[i].label = label - 1;
        if (!(z->zone[i].left < z->zone[i].right) ||
            (i > 0 &&
             (z->zone[i].left != z->zone[i - 1].right || z->zone[i].label == z->zone[i - 1].label)))
            t->is_sound = false;
    }
    t->is_sound = t->is_sound && z->count > 0;
}

static void pass_errors(stream *t, rw_numerical *n)
{
    for (int i = 0; i < RW_PLACES; i++) {
        pass_finite(t, &n->error[i]);
        t->is_sound = t->is_sound && n->error[i] >= 0;
    }
}

static void pass_shear(stream *t, rw_numerical **shear)
{
    if (t->in)
        *shear = calloc(1, sizeof **shear);
    need(t, *shear);
    if (!*shear)
        return;
    rw_numerical *n = *shear;
    rw_numerical_state *s = &n->now;
    double *const finite[] = {&s->at.P,           &s->at.M,           &s->at.shear,
                              &s->at.stretch,     &s->contact.left,   &s->contact.right,
                              &s->move,           &s->energy,         &s->error,
                              &s->unslipped.left, &s->unslipped.right};
    pass_all(t, sizeof finite / sizeof *finite, finite);
    pass_zones(t, &s->shear.zones);
    pass_int(t, &s->shear.kinks, RW_MOST_KINKS);
    for (int i = 0; i < s->shear.kinks; i++) {
        pass_finite(t, &s->shear.kink[i]);
    }
    pass_elements(t, &s->shear.traction);
    pass_flag(t, &n->has_origin);
    pass_flag(t, &s->is_still);
    pass_elements(t, &n->origin);
    pass_errors(t, n);
}

static void pass_contact(stream *t, rwedge_contact *c);

/* The contact when it last had a closed form. */
static void pass_exact(stream *t, rwedge_contact *c)
{
    const bool has_exact = pass_count(t, c->exact != NULL, 1) == 1;
    if (!has_exact || !t->is_sound)
        return;
    if (t->in)
        c->exact = calloc(1, sizeof *c->exact);
    need(t, c->exact);
    t->is_inner = true;
    if (c->exact)
        pass_contact(t, c->exact);
}

static void pass_numerical(stream *t, rwedge_contact *c)
{
    pass(t, &c->tolerance);
    const bool has_shear = pass_count(t, c->numerical != NULL, t->is_inner ? 0 : 1) == 1;
    if (!has_shear || !t->is_sound)
        return;
    pass_finite(t, &c->strayed);
    pass_shear(t, &c->numerical);
    if (!t->is_sound)
        return;
    pass_shear(t, &c->start);
    pass_exact(t, c);
}

/* What the pad is, if it is not a wedge. */
static void pass_pad(stream *t, rw_geometry *g)
{
    double *const finite[] = {&g->reach, &g->middle_slope};
    pass_all(t, 2, finite);
    t->is_sound = t->is_sound && rw_is_magnitude(g->reach);
    const size_t count = pass_count(t, g->pad ? g->pad->count : 0, t->in ? t->size / 3 : SIZE_MAX);
    if (t->in && t->is_sound && count > 0) {
        g->pad = rw_pad_create(count);
        need(t, g->pad);
    }
    for (size_t i = 0; i < count && t->is_sound; i++) {
        rw_arc arc = {0, 0};
        double weight = 0;
        if (!t->in) {
            arc = g->pad->arcs[i];
            weight = g->pad->weights[i];
        }
        double *const numbers[] = {&arc.left, &arc.right, &weight};
        pass_all(t, 3, numbers);
        t->is_sound = t->is_sound && (!t->in || rw_is_arc_sound(g->pad, arc, weight));
        if (t->in && t->is_sound)
            rw_pad_append(g->pad, arc, weight);
    }
    t->is_sound = t->is_sound && (!g->pad || rw_is_pad_sound(g->pad));
}

static void pass_contact(stream *t, rwedge_contact *c)
{
    double *const finite[] = {
        &c->geometry.theta, &c->geometry.a,   &c->geometry.A,   &c->f,
        &c->loads.P,        &c->loads.M,      &c->loads.Q,      &c->loads.sigma,
        &c->touched_at,     &c->settled.left, &c->settled.right};
    pass_all(t, sizeof finite / sizeof *finite, finite);
    pass(t, &c->energy_carry); /* NaN where the energy is not known */
    pass(t, &c->slid_from);
    if (t->version > 1)
        pass(t, &c->strain);
    else
        c->strain = 1;
    pass(t, &c->energy); /* NaN in states of older libraries, where it was not known */
    t->geometry = &c->geometry;
    if (t->version > 2)
        pass_pad(t, &c->geometry);
    if (t->in && !(rw_is_geometry(t->geometry) && rw_is_positive(rw_unit_stress(t->geometry))))
        t->is_sound = false;
    pass_flag(t, &c->was_off_centre);
    pass_flag(t, &c->is_origin_known);
    pass_path(t, &c->memory);
    pass_origins(t, &c->origins);
    if (t->version > 2)
        pass_numerical(t, c);
    else
        c->tolerance = 0;
}

/* A number of 52 bits. */
static double sum_of_bits(const double *state, size_t n)
{
    uint64_t sum = 0xcbf29ce484222325; /* FNV-1a, by words */
    for (size_t i = 0; i < n; i++)
        sum = (sum ^ rw_bits_of(state[i])) * 0x100000001b3 ^ (sum >> 29);
    return (double)(sum >> 12);
}

static size_t size_of(const rwedge_contact *contact)
{
    rwedge_contact same = *contact; /* is only counted */
    stream t = {.at = HEAD, .version = VERSION, .is_sound = true};
    pass_contact(&t, &same);
    return t.at;
}

size_t rwedge_contact_state_size(const rwedge_contact *contact)
{
    return contact ? size_of(contact) : 0;
}

int32_t rwedge_contact_state(const rwedge_contact *contact, size_t n, double state[])
{
    if (!contact || !state)
        return RWEDGE_ENULL;
    if (n != size_of(contact))
        return RWEDGE_ERANGE;
    rwedge_contact same = *contact; /* is only read */
    stream t = {.out = state, .at = HEAD, .version = VERSION, .is_sound = true};
    pass_contact(&t, &same);
    state[0] = VERSION;
    state[1] = sum_of_bits(state + HEAD, n - HEAD);
    return RWEDGE_OK;
}

int32_t rwedge_contact_restore(size_t n, const double state[], rwedge_contact **contact)
{
    if (!state || !contact)
        return RWEDGE_ENULL;
    if (n <= HEAD || !(state[0] == 1 || state[0] == 2 || state[0] == VERSION) ||
        state[1] != sum_of_bits(state + HEAD, n - HEAD))
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
