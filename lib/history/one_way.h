/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether slip goes one way at every point that slips. */
#ifndef RW_ONE_WAY_H
#define RW_ONE_WAY_H

#include "formulas/size.h"
#include "history/memory.h"

/* Whether all points between the front of a departure and the edges of the contact that the path
 * ends at have slipped the way of the departure, to rounding, where the front has slipped over the
 * layers of the path. false where that is not shown. The front's patch is known, and the patches
 * of the path are nested from it on. */
bool rw_slips_one_way(const rw_memory *path, const rw_departure *departure,
                      const rw_geometry *geometry);

#endif
