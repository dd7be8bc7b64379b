/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact with a load history: how it is made, copied and freed, and its present loads. */
#include "contact/handle.h"

#include "base/array.h"
#include "base/domain.h"

int32_t rw_contact_create(const rw_geometry *geometry, double f, rwedge_contact **contact)
{
    rwedge_contact *created = malloc(sizeof *created);
    if (!created)
        return RWEDGE_ENOMEM;
    *created = (rwedge_contact){
        .geometry = *geometry, .f = f, .strain = 1, .slip.is_known = true, .energy.is_known = true};
    if (!rw_memory_create(&created->memory)) {
        free(created);
        return RWEDGE_ENOMEM;
    }
    *contact = created;
    return RWEDGE_OK;
}

int32_t rw_contact_unloaded(const rwedge_contact *contact, rwedge_contact **unloaded)
{
    bool is_whole = true;
    rw_geometry geometry = contact->geometry;
    geometry.pad = rw_pad_copy(geometry.pad, &is_whole);
    rwedge_contact *created = NULL;
    int32_t status = is_whole ? rw_contact_create(&geometry, contact->f, &created) : RWEDGE_ENOMEM;
    if (status != RWEDGE_OK) {
        rw_pad_destroy(geometry.pad);
        return status;
    }
    created->strain = contact->strain;
    created->beta = contact->beta;
    created->is_held = contact->is_held;
    created->held_tilt = contact->held_tilt;
    if (!rw_contact_make_unlike(created)) {
        rwedge_contact_destroy(created);
        return RWEDGE_ENOMEM;
    }
    *unloaded = created;
    return RWEDGE_OK;
}

int32_t rwedge_contact_create(double theta, double a, double A, double f, rwedge_contact **contact)
{
    const rw_geometry geometry = {.theta = theta, .a = a, .A = A};
    if (!rw_is_geometry(&geometry) || !rw_is_friction(f) ||
        !rw_is_positive(rw_unit_stress(&geometry)))
        return RWEDGE_EDOMAIN;
    return contact ? rw_contact_create(&geometry, f, contact) : RWEDGE_ENULL;
}

int32_t rwedge_contact_allow_error(rwedge_contact *contact, double tolerance)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (tolerance != 0 && !(isgreaterequal(tolerance, 1e-6) && islessequal(tolerance, 1e-2)))
        return RWEDGE_EDOMAIN;
    contact->tolerance = tolerance;
    if (tolerance == 0)
        rw_contact_drop_beside(contact);
    if (contact->beside)
        contact->beside->tolerance = tolerance;
    return RWEDGE_OK;
}

double rwedge_contact_tolerance(const rwedge_contact *contact)
{
    return contact ? contact->tolerance : NAN;
}

double rwedge_contact_error(const rwedge_contact *contact)
{
    if (!contact)
        return NAN;
    return contact->phase == RW_COMPUTED ? rw_numerical_error(contact->computed.now) : 0;
}

/* Parts of it that could not be copied are absent. */
static rwedge_contact *copy_of(const rwedge_contact *contact, bool *is_whole)
{
    rwedge_contact *copy = rw_copied(contact, contact != NULL, sizeof *copy, is_whole);
    if (!copy)
        return NULL;
    copy->unlike =
        rw_copied(contact->unlike, contact->unlike != NULL, sizeof *copy->unlike, is_whole);
    copy->geometry.pad = rw_pad_copy(contact->geometry.pad, is_whole);
    copy->memory = rw_memory_copy(&contact->memory, is_whole);
    copy->slip.origins = rw_slip_origins_copy(&contact->slip.origins, is_whole);
    copy->computed.now = rw_numerical_copy(contact->computed.now, is_whole);
    copy->computed.start = rw_numerical_copy(contact->computed.start, is_whole);
    copy->computed.exact = copy_of(contact->computed.exact, is_whole);
    copy->beside = copy_of(contact->beside, is_whole);
    return copy;
}

int32_t rwedge_contact_copy(const rwedge_contact *contact, rwedge_contact **copy)
{
    if (!contact || !copy)
        return RWEDGE_ENULL;
    bool is_whole = true;
    rwedge_contact *copied = copy_of(contact, &is_whole);
    if (!is_whole) {
        rwedge_contact_destroy(copied);
        return RWEDGE_ENOMEM;
    }
    *copy = copied;
    return RWEDGE_OK;
}

void rw_contact_exchange(rwedge_contact *a, rwedge_contact *b)
{
    const rwedge_contact before = *a;
    *a = *b;
    *b = before;
}

void rw_contact_drop_computed(rwedge_contact *contact)
{
    rwedge_contact_destroy(contact->computed.exact);
    rw_numerical_destroy(contact->computed.now);
    rw_numerical_destroy(contact->computed.start);
    contact->computed = (rw_computed){.exact = NULL};
    if (contact->phase == RW_COMPUTED)
        contact->phase = RW_OFF_CENTRE;
}

void rw_contact_drop_beside(rwedge_contact *contact)
{
    rwedge_contact_destroy(contact->beside);
    contact->beside = NULL;
}

rwedge_contact *rw_contact_keep_beside(rwedge_contact *contact, rwedge_contact *other)
{
    if (contact->slip.followed != RW_NONE_FOLLOWED || contact->tolerance == 0 ||
        contact->phase == RW_APART || contact->phase == RW_SLIDING ||
        contact->phase == RW_COMPUTED || rw_contact_knows_slip_and_energy(contact) ||
        !rw_contact_knows_slip_and_energy(other))
        return other;
    other->slip.followed = RW_SLIP_AND_ENERGY_FOLLOWED;
    contact->beside = other;
    return NULL;
}

void rwedge_contact_destroy(rwedge_contact *contact)
{
    if (!contact)
        return;
    rw_memory_destroy(&contact->memory);
    rw_slip_origins_destroy(&contact->slip.origins);
    rw_contact_drop_computed(contact);
    rw_contact_drop_beside(contact);
    rw_pad_destroy(contact->geometry.pad);
    free(contact->unlike);
    free(contact);
}

int32_t rwedge_contact_loads(const rwedge_contact *contact, double *P, double *M, double *Q,
                             double *sigma)
{
    if (!contact || !P || !M || !Q || !sigma)
        return RWEDGE_ENULL;
    *P = contact->loads.P;
    *M = contact->loads.M;
    *Q = contact->loads.Q;
    *sigma = contact->loads.sigma;
    return RWEDGE_OK;
}

size_t rwedge_contact_memory(const rwedge_contact *contact)
{
    if (!contact)
        return 0;
    const rw_memory *memory = &contact->memory;
    if (contact->phase == RW_COMPUTED)
        return contact->computed.now->now.shear.traction.count;
    /* what the present path has in common with the last one kept counts once */
    const size_t shared = memory->shared > 0 ? memory->shared : 1;
    return memory->count - shared + rw_slip_origins_corners(&contact->slip.origins);
}

double rwedge_contact_dissipated_energy(const rwedge_contact *contact)
{
    if (!contact)
        return NAN;
    const rw_dissipated *energy = &rw_contact_of_slip(contact)->energy;
    return energy->is_known ? energy->sum : NAN;
}
