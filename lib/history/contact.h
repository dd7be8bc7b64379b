/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact with a load history is made of; the header has its functions. */
#ifndef RW_CONTACT_H
#define RW_CONTACT_H

#include "history/slip_origin.h"
#include "formulas/size.h"
#include "history/memory.h"
#include "stress/potential.h"
#include "rwedge.h"

struct rwedge_contact {
    rw_geometry geometry;
    double f;
    /* their sum; the carry is what rounding left out of a long history */
    double energy, energy_carry;
    rw_memory memory; /* loads are P, shears Q/f */
    rw_slip_origins origins;
};

/* The traction of a history is a sum of patches, one for each corner of its path: the pressure
 * of the contact under the corner's load, times f and the step that D makes there. The last
 * patch is the contact itself. */
static inline double rw_patch_weight(const rw_memory *memory, size_t corner)
{
    const double beyond = corner + 1 < memory->count ? memory->corners[corner + 1].ratio : 0;
    return memory->corners[corner].ratio - beyond;
}

/* The fields of the pressure and of the shear traction over f at n <= RW_BLOCK points; not the
 * apex of the sharp wedge. */
enum { RW_BLOCK = 32 };
typedef struct {
    rw_field normal[RW_BLOCK], tangential[RW_BLOCK];
} rw_contact_fields;

void rw_contact_fields_at(const rwedge_contact *contact, size_t n, const double x[],
                          const double y[], rw_contact_fields *fields);

#endif
