/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact of unlike bodies that grows from touching on, along a straight line of its loads. Each
 * part of the way adds the tractions of a flat punch as wide as the contact is then, under dP, dQ,
 * dM or no rotation, and d(stretch). Most of it is bonded; at its edges it slips, where the change
 * of the shear is f times that of the pressure. Tractions are constant over cells, and the
 * contact grows to the next cell, wherever that closes first: so no place comes into contact within
 * a step. Cells are finest where the bodies touch first. */
#ifndef RW_GROWING_CONTACT_H
#define RW_GROWING_CONTACT_H

#include "computed/growing_cells.h"
#include "numerical/step.h"

#include <stdint.h>

/* From touching under `from` to the loads `to`, with about so many cells in contact at the end.
 * RWEDGE_ENOMEM; RWEDGE_ENOCONV where the contact does not grow all the way; then there is nothing
 * to destroy. */
int32_t rw_growth_create(rw_growth *growth, const rw_frame *frame, rw_scaled_loads from,
                         rw_scaled_loads to, size_t cells);

#endif
